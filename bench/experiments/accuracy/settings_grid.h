#pragma once

#include <vector>

#include "formulations/base/settings.h"
#include "formulations/variants.h"

namespace desmo::accuracy {

/// Returns five settings, with errors of five sizes where all unknowns are solved at once: the
/// paper's, one iteration a step from three guesses, and two iterations a step.
std::vector<Settings> minimal_settings();

/// Returns the minimal settings, three iterations a step, some tolerances, and strides between
/// whose instants the others are interpolated. They have errors of four sizes or more in every
/// formulation. (The minimal grid does not: solved dyad by dyad, a long four-bar diverges with
/// fewer than three iterations; and closed forms have other errors with strides alone.)
std::vector<Settings> reduced_settings();

/// Returns the full grid, which includes settings that the variant does not offer
/// (unsupported_reason):
/// - every guess × Jacobian update × stop (a tolerance or a number of iterations)
/// - strides, with the paper's settings and with those that usually cost least
/// - for variants with code for lanes, all of these with lanes, too
std::vector<Settings> full_settings(const Variant& variant);

}  // namespace desmo::accuracy
