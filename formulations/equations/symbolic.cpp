#include "formulations/equations/symbolic.h"

#include <algorithm>
#include <stdexcept>

#include "formulations/group_type.h"

namespace desmo {

const Kernel* find_kernel(std::string_view fingerprint) {
  const auto it = std::ranges::find(kernels(), fingerprint, &Kernel::fingerprint);
  return it == kernels().end() ? nullptr : &*it;
}

BoundKernel bind_kernel(const Mechanism& m, GroupId group) {
  GroupType type = describe_group(m, group);
  const Kernel* kernel = find_kernel(type.fingerprint);
  if (!kernel)
    throw std::invalid_argument(m.name + ", group '" + m.groups[group].name +
                                "': no symbolic equations were generated for its type");
  std::vector<int> inputs;
  for (const GroupType::Input& input : type.inputs) inputs.push_back(input.state);
  return {kernel, std::move(inputs), std::move(type.constants)};
}

SymbolicEquations::SymbolicEquations(const Mechanism& m, const PartDefinition& part) {
  std::vector<JacobianEntry> entries;
  int row = 0;
  for (const GroupId g : part.groups) {
    Block block{bind_kernel(m, g), row, {}, false};
    const Kernel& k = *block.bound.kernel;
    for (const auto& list : {k.constant_entries, k.dependent_entries, k.known_entries})
      for (const KernelEntry& e : list) {
        block.slots.push_back(static_cast<int>(entries.size()));  // its place in `entries`, for now
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
