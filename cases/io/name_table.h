#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/io/json_document.h"

namespace desmo {

/// Names of one kind of entity and their positions. The texts must outlive the table.
class NameTable {
 public:
  explicit NameTable(std::string kind) : kind_(std::move(kind)) {}

  /// Adds a name at a position, by default the next. It must be new: documents have no key twice,
  /// and a valid mechanism no name.
  void add(std::string_view name, std::optional<int> position = {});

  std::optional<int> position(std::string_view name) const;
  /// Return the positions of names in the document. Throw InputError, with the nearest names, where
  /// one is unknown.
  int find(const JsonValue& value) const { return find(value, value.text()); }
  int find(const JsonValue& place, std::string_view name) const;
  std::vector<int> find_each(const JsonValue& list) const;
  /// Returns the positions of two different names.
  std::array<int, 2> find_pair(const JsonValue& list) const;

  const std::vector<std::string_view>& names() const { return names_; }

 private:
  std::string kind_;
  std::vector<std::string_view> names_;
  std::map<std::string_view, int> positions_;
};

}  // namespace desmo
