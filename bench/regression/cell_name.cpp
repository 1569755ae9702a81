#include "bench/regression/cell_name.h"

#include <charconv>
#include <stdexcept>

namespace desmo::regression {

CellName parse_cell(std::string_view name) {
  const std::size_t first = name.find('/'), second = name.find('/', first + 1);
  CellName cell{std::string(name.substr(0, first)), 0, {}};
  if (second != std::string_view::npos) {
    cell.id = name.substr(second + 1);
    const std::string_view size = name.substr(first + 1, second - first - 1);
    const char* const end = size.data() + size.size();
    const auto [stop, error] = std::from_chars(size.data(), end, cell.coordinates);
    if (error == std::errc{} && stop == end && !cell.id.empty()) return cell;
  }
  throw std::invalid_argument("'" + std::string(name) +
                              "' is not of the form <case>/<coordinates>/<id>");
}

}  // namespace desmo::regression
