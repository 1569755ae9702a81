#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/equations/symbolic.h"
#include "formulations/model/partition.h"
#include "formulations/parts/profile.h"

namespace desmo {

struct Backend;

/// The ingredients of a Newton part.
struct PartContext {
  const Model& model;
  const PartDefinition& definition;
  std::vector<double> weights;  ///< 1/magnitude of each equation of the part (see magnitudes.h)
  /// Kernels of the symbolic equations, by bind_kernels(). Without them the equations are
  /// automatic.
  std::optional<std::vector<BoundKernel>> kernels;
  /// Settings of the analysis, for the linear solver and frames. The part's own tolerance is in
  /// `settings`.
  const Settings& analysis;
  PartSettings settings;
  Profile* profile = nullptr;        ///< receives the times of phases; null: nothing is measured
  std::vector<double> magnitudes{};  ///< of each unknown; empty: all are 1
};

/// Makes the part that a context describes: Newton–Raphson (see NewtonSolver) with linear systems
/// solved by `backend`. Throws std::invalid_argument when the backend cannot analyse the part's
/// Jacobian.
std::unique_ptr<Part> make_newton_part(const PartContext& context, const Backend& backend);

}  // namespace desmo
