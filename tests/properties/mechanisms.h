#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "cases/mechanism/mechanism.h"
#include "tests/random.h"

namespace desmo::properties {

/// A mechanism with random dimensions.
struct Drawn {
  Mechanism mechanism;
  std::vector<double> direction = {};  ///< change of each driver for a unit of the path
  double reach = 3;                    ///< longest path, both ways
  bool exact = false;                  ///< its singular positions are exact in double precision
};

/// A family of mechanisms. Families of the library keep their dimensions, but not size and place.
struct Family {
  std::string_view name;
  Drawn (*draw)(Random&);  ///< null: of the library
};

// Families of about unit size, with random dimensions.
std::span<const Family> plane_families();
std::span<const Family> spatial_families();
std::span<const Family> coupled_families();  ///< mechanisms of the plane

/// Overconstrained ones, of which the first contradicts itself by a relative 1e-16 to 1e-5.
std::span<const Family> overconstrained_families();

/// Returns the families of the plane, of space and with couplings, then those of the library.
const std::vector<Family>& families();
/// Chooses one of them.
const Family& chosen_family(Random& random);

/// Returns a mechanism of the family, at a random place and of a random size (1e-3 to 1e6).
Drawn draw(const Family& family, Random& random);

}  // namespace desmo::properties
