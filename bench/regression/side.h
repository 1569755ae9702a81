#pragma once

#include <string>
#include <vector>

#include "bench/kit/process/child.h"

namespace desmo::regression {

/// One of the two trees that are compared.
struct Side {
  std::string name;    ///< "base" or "head"
  std::string folder;  ///< where its desmo_probe and desmo_steps are
  std::string slowed;  ///< the cell made slower on purpose; empty: none
  int percent = 0;     ///< by so much

  /// Environment and arguments of `desmo_probe ...`, which are the same on both sides.
  Launch probe(std::vector<std::string> arguments) const;
};

/// A program in a fixed environment: one thread, every symbol resolved at the start, no language.
/// What says where libraries are, LD_LIBRARY_PATH and DESMO_LIBCOINHSL, is passed on.
Launch fixed_launch(std::vector<std::string> arguments);

}  // namespace desmo::regression
