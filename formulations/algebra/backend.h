#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "formulations/algebra/absence.h"
#include "formulations/algebra/linear_solver.h"
#include "formulations/base/settings.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// One library for linear systems.
struct Backend {
  std::string_view name;
  bool dense;
  /// Makes a solver of systems with this pattern, as the settings say; with Scalar::mixed its
  /// factors are single. Throws std::invalid_argument when the library cannot analyse the pattern.
  std::unique_ptr<LinearSolver<double>> (*make_solver)(const Pattern&, const PartSettings&);
  std::string (*version)();
  bool squares_condition = false;  ///< it solves normal equations: so much worse are its errors
  Absence (*absence)() = nullptr;  ///< null: it is linked, and always there
  /// Makes a solver in single precision. Dense libraries offer it, sparse ones do not: null.
  std::unique_ptr<LinearSolver<float>> (*make_single_solver)(const Pattern&) = nullptr;
};

/// Makes a solver of a class whose constructor takes the pattern alone.
template <class Solver>
std::unique_ptr<LinearSolver<double>> make_sparse_solver(const Pattern& pattern,
                                                         const PartSettings&) {
  return std::make_unique<Solver>(pattern);
}

/// The libraries of this build that are on this machine, in the order of the design.
std::span<const Backend* const> backends();

/// Those of this build that are not on this machine.
std::span<const Backend* const> absent_backends();

}  // namespace desmo
