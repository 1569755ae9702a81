#pragma once

#include <memory>
#include <vector>

#include "formulations/equations/equations.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Automatic equations: loops over the constraint objects of a part. Objects of one kind are
/// contiguous, so that no call in a loop is virtual. The constructor looks up the positions of
/// their partial derivatives.
class AutomaticEquations final : public Equations {
 public:
  class Loops;  // loops over the objects of one kind

  AutomaticEquations(const Model& model, const PartDefinition& part);
  ~AutomaticEquations() override;

  const Pattern& pattern() const override { return pattern_; }
  void constant_jacobian(double* values) const override;
  void residual(const double* state, double* phi) const override;
  void jacobian(const double* state, double* values) const override;
  /// Does nothing: the loop of jacobian() has written these entries.
  void known_jacobian(const double*, double*) const override {}
  void quadratic(const double* state, const double* rate, double* gamma) const override;

 private:
  Pattern pattern_;
  // of each kind that occurs: one for constraints with all equations in this part, one for
  // constraints with equations in other parts, too
  std::vector<std::unique_ptr<Loops>> loops_;
};

}  // namespace desmo
