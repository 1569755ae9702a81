#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "cases/mechanism/scene.h"

namespace desmo {

/// Makes the scalable four-bar, driven for 30 s: a crank and K dyads (pairs of links joined by a
/// hinge), 3 + 3 K coordinates, lengths in a free unit. Throws std::invalid_argument unless
/// 1 ≤ dyads ≤ 10⁷.
Scene four_bar(int dyads);

/// Makes the truck suspension on its road for 30 s: k axles of five structural groups each,
/// 3 + 111 k coordinates, in metres. Throws std::invalid_argument unless 1 ≤ axles ≤ 10⁵.
Scene truck_suspension(int axles);

/// A scalable case of the suite:
///
///   const Scene scene = make_scene(find_case("truck_suspension"), 558);
struct Case {
  std::string_view name;           ///< "four_bar", "truck_suspension"
  std::string_view unit_name;      ///< plural of its repeated unit: "dyads", "axles"
  Scene (*with_units)(int units);  ///< four_bar() or truck_suspension()
  int base_coordinates;  ///< coordinates = base_coordinates + coordinates_per_unit · units
  int coordinates_per_unit;
  std::vector<int> sizes;  ///< numbers of coordinates in the paper's tables, ascending
  /// Further numbers of coordinates, measured with sparse global references and generated code
  /// only.
  std::vector<int> extra_sizes;
};

/// Returns every case, in the order of the paper's tables.
std::span<const Case> cases();

/// Returns the case of that name. Throws std::invalid_argument, with similar names or all of them,
/// when there is none.
const Case& find_case(std::string_view name);

/// Makes the scene of a case with that number of coordinates. Throws std::invalid_argument when no
/// whole number of units, 1 or more, has it, and when the generator refuses that number of units.
Scene make_scene(const Case& definition, int coordinates);

}  // namespace desmo
