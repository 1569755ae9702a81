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

/// Returns guesses × Jacobian updates × where to stop (tolerances and numbers of iterations), in
/// double precision; single and mixed precision with the paper's guess and the best one; strides
/// with the paper's settings and what usually costs least. Among them is what the variant does not
/// offer (unsupported_reason), to be told. Where it has code for lanes, all with them, too.
std::vector<Settings> full_settings(const Variant& variant);

}  // namespace desmo::accuracy
