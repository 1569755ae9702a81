#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formulations/equations/automatic.h"
#include "formulations/equations/symbolic.h"
#include "formulations/newton_part.h"
#include "formulations/part.h"
#include "formulations/profile.h"

namespace desmo {

/// All that a Newton part is made from.
struct PartContext {
  const Mechanism& mechanism;
  const PartDefinition& definition;
  /// Of the symbolic equations, by bind_kernels(); without them the equations are automatic.
  std::optional<std::vector<BoundKernel>> kernels;
  Settings settings;           ///< with the tolerance on ‖Φ‖₂ of the part's own equations
  Profile* profile = nullptr;  ///< where phases are measured, or null for the timed code
};

/// One library for linear systems.
struct Backend {
  std::string_view name;
  bool dense;
  std::unique_ptr<Part> (*make_part)(const PartContext&);
  std::string (*version)();
};

/// The backends of this build, in the order of the design.
std::span<const Backend* const> backends();

/// The part that a context describes, with this algebra (see NewtonPart).
template <class Algebra>
std::unique_ptr<Part> make_newton_part(const PartContext& context) {
  const auto make = [&]<class Equations>(Equations equations) -> std::unique_ptr<Part> {
    if (!context.profile)
      return std::make_unique<NewtonPart<Equations, Algebra>>(std::move(equations),
                                                              context.settings);
    using Profiled = ProfiledEquations<Equations>;
    return std::make_unique<NewtonPart<Profiled, ProfiledAlgebra<Algebra>>>(
        Profiled(std::move(equations), *context.profile), context.settings, *context.profile);
  };
  if (!context.kernels) return make(AutomaticEquations(context.mechanism, context.definition));
  return make(SymbolicEquations(context.mechanism, context.definition, *context.kernels));
}

}  // namespace desmo
