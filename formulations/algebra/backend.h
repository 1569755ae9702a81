#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formulations/algebra/absence.h"
#include "formulations/equations/automatic.h"
#include "formulations/equations/symbolic.h"
#include "formulations/newton_part.h"
#include "formulations/part.h"
#include "formulations/partition.h"
#include "formulations/profile.h"
#include "formulations/single_precision_part.h"

namespace desmo {

/// All that a Newton part is made from.
struct PartContext {
  const Mechanism& mechanism;
  const PartDefinition& definition;
  std::vector<double> weights;  ///< 1/magnitude of each equation of the part (see magnitudes.h)
  /// Of the symbolic equations, by bind_kernels(); without them the equations are automatic.
  std::optional<std::vector<BoundKernel>> kernels;
  PartSettings settings;       ///< with the tolerance on ‖Φ‖₂ of the part's own equations
  Profile* profile = nullptr;  ///< where phases are measured, or null for the timed code
  std::shared_ptr<SinglePrecisionState> single{};  ///< where the scalar is single
  std::vector<double> magnitudes{};                ///< of the unknowns; none: all are 1
};

/// One library for linear systems.
struct Backend {
  std::string_view name;
  bool dense;
  /// settings.scalar: a dense one offers all, a sparse one double precision only.
  std::unique_ptr<Part> (*make_part)(const PartContext&);
  std::string (*version)();
  bool squares_condition = false;  ///< it solves normal equations: so much worse are its errors
  Absence (*absence)() = nullptr;  ///< null: it is linked, and always there
  /// Where measurement decides (see algebra/mixed.h), which of the others makes a part. Null: this
  /// one does.
  const Backend& (*choose)(const PartContext&) = nullptr;
};

/// The libraries of this build that are on this machine, in the order of the design.
std::span<const Backend* const> backends();

/// Those of this build that are not on this machine.
std::span<const Backend* const> absent_backends();

/// NewtonSolver's `patience` with a sparse factorisation, of which assembly is a good part.
inline constexpr int sparse_patience = 3;

/// The part that a context describes, with this algebra (see NewtonSolver).
template <class Algebra>
std::unique_ptr<Part> make_newton_part(const PartContext& c) {
  const auto make = [&]<class Equations>(Equations equations) -> std::unique_ptr<Part> {
    if (!c.profile)
      return std::make_unique<NewtonPart<Equations, Algebra>>(std::move(equations), c.weights,
                                                              c.magnitudes, c.settings);
    using Profiled = ProfiledEquations<Equations>;
    return std::make_unique<NewtonPart<Profiled, ProfiledAlgebra<Algebra>>>(
        Profiled(std::move(equations), *c.profile), c.weights, c.magnitudes, c.settings,
        *c.profile);
  };
  if (!c.kernels) return make(AutomaticEquations(c.mechanism, c.definition));
  return make(SymbolicEquations(c.mechanism, c.definition, *c.kernels));
}

/// The same, all in single precision: the context has its state, and its equations are automatic.
template <class Algebra>
std::unique_ptr<Part> make_single_precision_part(const PartContext& c) {
  using Equations = BasicAutomaticEquations<float>;
  Equations equations(c.mechanism, c.definition);
  std::vector<int> read = states_read(c.mechanism, c.definition);
  if (!c.profile)
    return std::make_unique<SinglePrecisionPart<Equations, Algebra>>(
        std::move(equations), c.weights, c.magnitudes, c.settings, c.single, std::move(read));
  using Profiled = ProfiledEquations<Equations>;
  return std::make_unique<SinglePrecisionPart<Profiled, ProfiledAlgebra<Algebra>>>(
      Profiled(std::move(equations), *c.profile), c.weights, c.magnitudes, c.settings, c.single,
      std::move(read), *c.profile);
}

}  // namespace desmo
