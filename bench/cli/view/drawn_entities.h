// Points and vectors of a mechanism that a page draws.
#pragma once

#include <cstddef>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo::cli {

/// Returns of each point whether a body carries it; the model knows no others.
std::vector<bool> carried_points(const Mechanism& mechanism);

/// Returns of each vector whether it is drawn: those of joints and of driven coordinates are.
std::vector<bool> drawn_vectors(const Mechanism& mechanism);

/// Returns how many numbers an instant has for what is drawn: no less than 1, and no more than
/// this.
std::size_t drawn_numbers(const Mechanism& mechanism);

}  // namespace desmo::cli
