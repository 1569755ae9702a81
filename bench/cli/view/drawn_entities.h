// Points and vectors of a mechanism that a page draws.
#pragma once

#include <cstddef>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo::cli {

/// Returns for each point whether a body carries it; the model has no other points.
std::vector<bool> carried_points(const Mechanism& mechanism);

/// Returns for each vector whether it is drawn: those of joints and of driven coordinates are.
std::vector<bool> drawn_vectors(const Mechanism& mechanism);

/// Returns an upper bound, 1 or more, on the numbers that an instant needs for what is drawn.
std::size_t drawn_numbers(const Mechanism& mechanism);

}  // namespace desmo::cli
