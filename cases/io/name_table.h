#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/io/json_document.h"

namespace desmo {

/// Names of one kind of entity, with their positions in a list of entities. The texts must outlive
/// the table.
class NameTable {
 public:
  explicit NameTable(std::string kind) : kind_(std::move(kind)) {}

  /// Adds a name at a position; by default that is the number of names added before. The table must
  /// not have the name. (Keys of a JsonDocument's object differ, as do names of a valid mechanism.)
  void add(std::string_view name, std::optional<int> position = {});

  std::optional<int> position(std::string_view name) const;  ///< none: the name is unknown
  /// Return the positions of names that a document gives. Throw InputError where one is unknown;
  /// the message has similar names, or all of them. place: value that the message refers to.
  int find(const JsonValue& value) const { return find(value, value.text()); }
  int find(const JsonValue& place, std::string_view name) const;
  std::vector<int> find_each(const JsonValue& list) const;
  /// Returns the positions of the two names of a list. Throws InputError also where the list has
  /// not two names, or one twice.
  std::array<int, 2> find_pair(const JsonValue& list) const;

  const std::vector<std::string_view>& names() const { return names_; }

 private:
  std::string kind_;
  std::vector<std::string_view> names_;
  std::map<std::string_view, int> positions_;
};

}  // namespace desmo
