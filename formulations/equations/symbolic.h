#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "formulations/equations/equations.h"
#include "formulations/equations/kernel.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/model/model.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// The kernel that desmo was built with for a fingerprint, or null.
const Kernel* find_kernel(std::string_view fingerprint);

/// A generated kernel bound to a group, or a block of one, of a mechanism.
struct BoundKernel {
  const Kernel* kernel;
  std::vector<int> inputs;        ///< position in the state of each local input
  std::vector<double> constants;  ///< its dimensions
};

/// Finds and binds the kernel for a part of one group; nothing when the table has none for its
/// type. The table must outlive what is bound.
std::optional<BoundKernel> bind_kernel(const Model& model, const PartDefinition& part,
                                       const KernelTable& table = KernelTable::built_in());

/// The kernels of a part, group by group; nothing when one is missing.
std::optional<std::vector<BoundKernel>> bind_kernels(
    const Model& model, const PartDefinition& part,
    const KernelTable& table = KernelTable::built_in());

/// Symbolic equations: the generated kernels of a part's groups, one after the other.
class SymbolicEquations final : public Equations<double> {
 public:
  /// kernels: of the part, by bind_kernels().
  SymbolicEquations(const Model& model, const PartDefinition& part,
                    std::vector<BoundKernel> kernels);

  const Pattern& pattern() const override { return pattern_; }
  void constant_jacobian(double* values) const override;
  void residual(const double* state, double* phi) const override;
  /// Where a coordinate that one group takes as known is an unknown of the part, its entries are
  /// written too.
  void jacobian(const double* state, double* values) const override;
  void known_jacobian(const double* state, double* values) const override;
  void quadratic(const double* state, const double* rate, double* gamma) const override;

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
