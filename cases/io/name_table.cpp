#include "cases/io/name_table.h"

#include "cases/mechanism/names.h"

namespace desmo {

void NameTable::add(std::string_view name, std::optional<int> position) {
  positions_.emplace(name, position.value_or(static_cast<int>(names_.size())));
  names_.push_back(name);
}

std::optional<int> NameTable::position(std::string_view name) const {
  const auto found = positions_.find(name);
  return found == positions_.end() ? std::nullopt : std::optional(found->second);
}

int NameTable::find(const JsonValue& place, std::string_view name) const {
  if (const auto found = position(name)) return *found;
  place.complain(unknown_name(kind_, name, names_));
}

std::vector<int> NameTable::find_each(const JsonValue& list) const {
  std::vector<int> positions;
  for (const JsonValue& value : list.elements()) positions.push_back(find(value));
  return positions;
}

std::array<int, 2> NameTable::find_pair(const JsonValue& list) const {
  const std::vector<int> positions = find_each(list);
  if (positions.size() != 2)
    list.complain("has " + std::to_string(positions.size()) + " names; give two, each of a " +
                  kind_);
  if (positions[0] == positions[1])
    list.complain("names the " + kind_ + " " + in_quotes(list.elements()[0].text()) +
                  " twice; name two different ones");
  return {positions[0], positions[1]};
}

}  // namespace desmo
