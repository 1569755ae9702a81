#include "formulations/verification/certificate/block_equations.h"
#include "formulations/verification/certificate/block_functions.h"

namespace desmo {

BlockEquations::PathFunctions BlockEquations::path_functions(int kind) {
  PathFunctions found{};
  visit_kind(kind, [&]<class Kind>(Kind) {
    if constexpr (!Kind::linear) found = FunctionsOf<Kind>::along_paths;
  });
  return found;
}

void BlockEquations::write_fixed(PathValue* x) const {
  for (const int i : written_) {
    x[i] = {};
    x[i].c[0] = fixed_[i].value;
    x[i].rest = radii_[i];
  }
}

void BlockEquations::residual(const PathValue* x, PathValue* phi) const {
  for (const Object& o : objects_) o.path_functions.residual(o, x, phi);
  linear_.residual(x, phi);
}

void BlockEquations::jacobian(const PathSlope* x, LaneMatrix& to) const {
  for (const Object& o : objects_) o.path_functions.jacobian(o, o.shape->slots, x, to);
}

}  // namespace desmo
