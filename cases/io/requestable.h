// The names that a request can ask for.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/io/json_document.h"
#include "cases/io/name_table.h"
#include "cases/mechanism/mechanism.h"

namespace desmo {

/// The names that a request may list under one of its keys, with their positions in the mechanism.
struct RequestKey : NameTable {
  RequestKey(std::string key, std::string kind, bool defines = false)
      : NameTable(std::move(kind)), key(std::move(key)), defines(defines) {}

  const std::string key;  ///< key in an entry of a request, such as "points"
  const bool defines;     ///< an entry may define entities under the key, too
};

/// An entity that a request asks for.
struct AskedEntity {
  int index;                 ///< position of its name in the mechanism
  std::string_view pattern;  ///< pattern that its name matches; empty: the request has the name
};

/// The names of all that a request of a mechanism can ask for. Functions that read throw
/// InputError.
class Requestable {
 public:
  /// mechanism: outlives this object, and has the entities that the request defines.
  explicit Requestable(const Mechanism& mechanism);

  /// Reads what an entry of a request lists or defines under the key of `names`: each name, and
  /// each name that matches a listed pattern.
  std::vector<AskedEntity> read(const JsonValue& entry, const RequestKey& names);

  /// Reads and returns the name of a coordinate, or of a component of a point or vector: "C.x".
  std::string read_component(const JsonValue& value) const;

  RequestKey points{"points", "point", true}, vectors{"vectors", "vector"},
      angles{"angles", "angle", true}, distances{"distances", "distance", true},
      bodies{"bodies", "body"}, rotations{"rotations", "moving body"},
      joints{"joints", "joint that turns or slides"};

 private:
  void match(const JsonValue& pattern, const RequestKey& names, std::vector<AskedEntity>& asked);
  void check_kind(const JsonValue& name, const RequestKey& names) const;
  void check_joint(const JsonValue& name) const;

  const Mechanism& mechanism_;
  int patterns_ = 0;
};

}  // namespace desmo
