#include "cases/generators/cases.h"

#include <array>
#include <stdexcept>
#include <string>

#include "cases/mechanism/names.h"

namespace desmo {

std::span<const Case> cases() {
  // 1002 coordinates: where the paper says that the four-bar's times begin to show.
  static const std::array table{
      Case{"four_bar", "dyads", &four_bar, 3, 3, {114, 225, 336, 447, 558}, {1002}},
      Case{"truck_suspension", "axles", &truck_suspension, 3, 111, {114, 225, 336, 447, 558}, {}},
  };
  return table;
}

const Case& find_case(std::string_view name) { return entry_named(name, cases(), "case"); }

Scene make_scene(const Case& c, int coordinates) {
  const int units = (coordinates - c.base_coordinates) / c.coordinates_per_unit;
  if (units < 1 || c.base_coordinates + units * c.coordinates_per_unit != coordinates)
    throw std::invalid_argument(std::string(c.name) + ": no size has " +
                                std::to_string(coordinates) + " coordinates; they are " +
                                std::to_string(c.base_coordinates) + " + " +
                                std::to_string(c.coordinates_per_unit) + " k, k = 1, 2, …");
  return c.with_units(units);
}

}  // namespace desmo
