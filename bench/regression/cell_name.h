#pragma once

#include <string>
#include <string_view>

namespace desmo::regression {

/// What a cell's name says.
struct CellName {
  std::string case_name;
  int coordinates;
  std::string id;
};

/// <case>/<coordinates>/<id>; throws std::invalid_argument for anything else.
CellName parse_cell(std::string_view name);

}  // namespace desmo::regression
