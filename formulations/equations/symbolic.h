#pragma once

#include <string_view>
#include <vector>

#include "cases/mechanism.h"
#include "formulations/equations/kernel.h"
#include "formulations/equations/pattern.h"
#include "formulations/partition.h"

namespace desmo {

/// The kernel for a fingerprint, or null.
const Kernel* find_kernel(std::string_view fingerprint);

/// A generated kernel bound to one group of a mechanism.
struct BoundKernel {
  const Kernel* kernel;
  std::vector<int> inputs;        ///< position in the state of each local input
  std::vector<double> constants;  ///< dimensions of the group
};

/// Finds and binds the kernel of a group. Throws std::invalid_argument, naming the group, when
/// none was generated for its type.
BoundKernel bind_kernel(const Mechanism& mechanism, GroupId group);

/// Symbolic equations: the generated kernels of a part's groups, one after the other. Meets the
/// contract of AutomaticEquations.
class SymbolicEquations {
 public:
  /// Throws std::invalid_argument when a group has no kernel.
  SymbolicEquations(const Mechanism& mechanism, const PartDefinition& part);

  const Pattern& pattern() const { return pattern_; }

  void constant_jacobian(double* values) const;
  void residual(const double* state, double* phi) const;
  /// Where a coordinate that one group takes as known is an unknown of the part, its entries are
  /// written too.
  void jacobian(const double* state, double* values) const;
  void known_jacobian(const double* state, double* values) const;
  void quadratic(const double* state, const double* rate, double* gamma) const;

 private:
  struct Block {
    BoundKernel bound;
    int first_row;
    std::vector<int> slots;
    bool known_is_unknown;  // some known entry of the group lies in a column of the part
  };

  Pattern pattern_;
  std::vector<Block> blocks_;
};

}  // namespace desmo
