#pragma once

#include <optional>
#include <vector>

#include "formulations/equations/equations.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// A generated kernel bound to a group of a model, or to a block of a group.
struct BoundKernel {
  const Kernel* kernel;
  std::vector<int> inputs;        ///< position of each local input in the state
  std::vector<double> constants;  ///< dimensions of its constraints
};

/// Finds and binds the kernel for a part of one group. Returns nothing when the table has none for
/// its type. The table must outlive the result.
std::optional<BoundKernel> bind_kernel(const Model& model, const PartDefinition& part,
                                       const KernelTable& table = KernelTable::built_in());

/// Binds the kernels of a part, group by group. Returns nothing when one is missing.
std::optional<std::vector<BoundKernel>> bind_kernels(
    const Model& model, const PartDefinition& part,
    const KernelTable& table = KernelTable::built_in());

/// Symbolic equations: the generated kernels of a part's groups, called one after the other.
class SymbolicEquations final : public Equations {
 public:
  /// kernels: the part's, made by bind_kernels().
  SymbolicEquations(const Model& model, const PartDefinition& part,
                    std::vector<BoundKernel> kernels);

  const Pattern& pattern() const override { return pattern_; }
  void constant_jacobian(double* values) const override;
  void residual(const double* state, double* phi) const override;
  /// Also writes all known entries of a group, if one of them is by an unknown of the part.
  void jacobian(const double* state, double* values) const override;
  void known_jacobian(const double* state, double* values) const override;
  void quadratic(const double* state, const double* rate, double* gamma) const override;

 private:
  struct Block {
    BoundKernel bound;
    int first_row;
    std::vector<int> slots;
    bool known_is_unknown;  // true: a known entry is by an unknown of the part
  };

  Pattern pattern_;
  std::vector<Block> blocks_;
};

}  // namespace desmo
