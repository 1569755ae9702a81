// The names that a request can ask for.
#pragma once

#include <functional>
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
  RequestKey(std::string key, std::string kind) : NameTable(std::move(kind)), key(std::move(key)) {}

  const std::string key;  ///< key in an entry of a request, such as "points"
};

/// The names of all that a request of a mechanism can ask for. Functions that read throw
/// InputError.
class Requestable {
 public:
  /// mechanism: outlives this object, and has the entities that the request defines.
  explicit Requestable(const Mechanism& mechanism);

  /// Function that takes the position of a requested entity, and the pattern that it matched; "":
  /// the request has its name.
  using Want = std::function<void(int, std::string_view)>;
  /// Reads what an entry of a request lists or defines under the key of `names`. Calls want() for
  /// each name, and for each name that matches a listed pattern.
  void read(const JsonValue& entry, const RequestKey& names, const Want& want);

  /// Reads and returns the name of a coordinate, or of a component of a point or vector: "C.x".
  std::string read_component(const JsonValue& value) const;

  RequestKey points{"points", "point"}, vectors{"vectors", "vector"}, angles{"angles", "angle"},
      distances{"distances", "distance"}, bodies{"bodies", "body"},
      rotations{"rotations", "moving body"}, joints{"joints", "joint that turns or slides"};

 private:
  bool defines_in_place(const RequestKey& names) const;
  std::vector<int> match(const JsonValue& pattern, const RequestKey& names);
  void check_kind(const JsonValue& name, const RequestKey& names) const;
  void check_joint(const JsonValue& name) const;

  const Mechanism& mechanism_;
  int patterns_ = 0;
};

}  // namespace desmo
