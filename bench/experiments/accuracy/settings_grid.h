#pragma once

#include <vector>

#include "formulations/base/settings.h"
#include "formulations/variants.h"

namespace desmo::accuracy {

/// Returns settings that end at errors of five sizes where all unknowns are solved at once: the
/// paper's, and with one and two iterations a step from different guesses.
std::vector<Settings> minimal_settings();

/// Returns these, and three iterations, some tolerances, and instants interpolated between those
/// that the paper's settings solve: they end at errors of four sizes or more in every formulation.
/// (The minimal grid does not do: solved dyad by dyad, a long four-bar diverges with fewer than
/// three iterations; and to closed forms nothing but interpolation makes a difference.)
std::vector<Settings> reduced_settings();

/// Returns the full grid, which includes settings that the variant does not offer
/// (unsupported_reason):
/// - every guess × Jacobian update × stop (a tolerance or a number of iterations)
/// - strides, with the paper's settings and with those that usually cost least
/// - for variants with code for lanes, all of these with lanes, too
std::vector<Settings> full_settings(const Variant& variant);

}  // namespace desmo::accuracy
