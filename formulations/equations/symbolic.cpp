#include "formulations/equations/symbolic.h"

#include <algorithm>

#include "formulations/model/part_type.h"

namespace desmo {

std::optional<BoundKernel> bind_kernel(const Model& m, const PartDefinition& part,
                                       const KernelTable& table) {
  PartType type = describe_type(m, part);
  const Kernel* kernel = table.find_kernel(type.fingerprint);
  if (!kernel) return std::nullopt;
  std::vector<int> inputs;
  for (const PartType::Input& input : type.inputs) inputs.push_back(input.state);
  return BoundKernel{kernel, std::move(inputs), std::move(type.constants)};
}

std::optional<std::vector<BoundKernel>> bind_kernels(const Model& m, const PartDefinition& part,
                                                     const KernelTable& table) {
  std::vector<BoundKernel> result;
  for (const PartDefinition& group : split_by_group(m, part)) {
    std::optional<BoundKernel> bound = bind_kernel(m, group, table);
    if (!bound) return std::nullopt;
    result.push_back(std::move(*bound));
  }
  return result;
}

SymbolicEquations::SymbolicEquations(const Model& m, const PartDefinition& part,
                                     std::vector<BoundKernel> kernels) {
  std::vector<JacobianEntry> entries;
  int row = 0;
  for (BoundKernel& bound : kernels) {
    Block block{std::move(bound), row, {}, false};
    const Kernel& k = *block.bound.kernel;
    for (const auto& list : {k.constant_entries, k.dependent_entries, k.known_entries})
      for (const KernelEntry& e : list) {
        // position in `entries`, replaced below
        block.slots.push_back(static_cast<int>(entries.size()));
        entries.push_back({row + e.row, block.bound.inputs[e.input]});
      }
    row += k.rows;
    blocks_.push_back(std::move(block));
  }

  PatternWithSlots made = make_pattern(m, part, entries);
  pattern_ = std::move(made.pattern);
  for (Block& block : blocks_) {
    for (int& slot : block.slots) slot = made.slots[slot];
    const std::size_t known = block.bound.kernel->known_entries.size();
    block.known_is_unknown = std::any_of(block.slots.end() - known, block.slots.end(),
                                         [&](int s) { return s < pattern_.dependent_entries(); });
  }
}

void SymbolicEquations::constant_jacobian(double* values) const {
  for (const Block& b : blocks_)
    b.bound.kernel->constant(b.bound.constants.data(), b.slots.data(), values);
}

void SymbolicEquations::residual(const double* state, double* phi) const {
  for (const auto& [bound, first_row, slots, known] : blocks_)
    bound.kernel->residual(state, bound.inputs.data(), bound.constants.data(), phi + first_row);
}

void SymbolicEquations::jacobian(const double* state, double* values) const {
  for (const auto& [bound, first_row, slots, known_is_unknown] : blocks_) {
    const int* in = bound.inputs.data();
    const double* c = bound.constants.data();
    bound.kernel->dependent(state, in, c, slots.data(), values);
    if (known_is_unknown) bound.kernel->known(state, in, c, slots.data(), values);
  }
}

void SymbolicEquations::known_jacobian(const double* state, double* values) const {
  for (const auto& [bound, first_row, slots, known_is_unknown] : blocks_)
    if (!known_is_unknown)
      bound.kernel->known(state, bound.inputs.data(), bound.constants.data(), slots.data(), values);
}

void SymbolicEquations::quadratic(const double* state, const double* rate, double* gamma) const {
  for (const auto& [bound, first_row, slots, known] : blocks_)
    bound.kernel->quadratic(state, rate, bound.inputs.data(), bound.constants.data(),
                            gamma + first_row);
}

}  // namespace desmo
