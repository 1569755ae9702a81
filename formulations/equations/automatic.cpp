#include "formulations/equations/automatic.h"

#include <algorithm>

namespace desmo {

namespace {

template <class Kind>
using Operands = std::array<const double*, Kind::operand_sizes.size()>;

template <std::size_t N>
std::array<const double*, N> pointers(const double* state, const std::array<int, N>& positions) {
  std::array<const double*, N> result;
  for (std::size_t k = 0; k < N; ++k) result[k] = state + positions[k];
  return result;
}

/// Writes the partial derivatives of one constraint to their places.
template <class Kind, class Object, class Operands>
inline void write_jacobian(const Object& o, const Operands& x, double* values) {
  int i = 0;
  Kind::jacobian(x.data(), o.constants.data(),
                 [&](int, int, int, double value) { values[o.slots[i++]] = value; });
}

}  // namespace

AutomaticEquations::AutomaticEquations(const Mechanism& m, const PartDefinition& part) {
  std::vector<JacobianEntry> entries;
  const std::vector<double> any(m.state_size(), 1.0);  // the pattern does not depend on the values
  int row = 0;
  for (const int c : part.equations) {
    const Constraint& constraint = m.constraints[c];
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      typename Batch<Kind>::Object o;
      for (std::size_t k = 0; k < o.operands.size(); ++k)
        o.operands[k] = m.state_index(constraint.operands[k]);
      std::ranges::copy(constraint.constants, o.constants.begin());
      o.row = row;
      row += Kind::rows;

      int i = 0;
      const auto x = pointers(any.data(), o.operands);
      Kind::jacobian(x.data(), o.constants.data(), [&](int r, int operand, int component, double) {
        o.slots[i++] = static_cast<int>(entries.size());  // its place in `entries`, for now
        entries.push_back({o.row + r, o.operands[operand] + component});
      });
      std::get<Batch<Kind>>(batches_).objects.push_back(o);
    });
  }

  PatternWithSlots made = make_pattern(m, part, entries);
  pattern_ = std::move(made.pattern);
  const auto assign = [&](auto& batch) {
    for (auto& o : batch.objects)
      for (int& slot : o.slots) slot = made.slots[slot];
  };
  std::apply([&](auto&... batch) { (assign(batch), ...); }, batches_);
}

void AutomaticEquations::constant_jacobian(double* values) const {
  const auto write = [&]<class Kind>(const Batch<Kind>& batch) {
    if constexpr (Kind::linear)
      for (const auto& o : batch.objects)
        write_jacobian<Kind>(o, Operands<Kind>{}, values);  // they read no state
  };
  std::apply([&](const auto&... batch) { (write(batch), ...); }, batches_);
}

void AutomaticEquations::residual(const double* state, double* phi) const {
  const auto evaluate = [&]<class Kind>(const Batch<Kind>& batch) {
    for (const auto& o : batch.objects) {
      const auto x = pointers(state, o.operands);
      Kind::residual(x.data(), o.constants.data(), phi + o.row);
    }
  };
  std::apply([&](const auto&... batch) { (evaluate(batch), ...); }, batches_);
}

void AutomaticEquations::jacobian(const double* state, double* values) const {
  const auto evaluate = [&]<class Kind>(const Batch<Kind>& batch) {
    if constexpr (!Kind::linear)
      for (const auto& o : batch.objects)
        write_jacobian<Kind>(o, pointers(state, o.operands), values);
  };
  std::apply([&](const auto&... batch) { (evaluate(batch), ...); }, batches_);
}

void AutomaticEquations::quadratic(const double* state, const double* rate, double* gamma) const {
  const auto evaluate = [&]<class Kind>(const Batch<Kind>& batch) {
    for (const auto& o : batch.objects) {
      const auto x = pointers(state, o.operands);
      const auto v = pointers(rate, o.operands);
      Kind::quadratic(x.data(), v.data(), o.constants.data(), gamma + o.row);
    }
  };
  std::apply([&](const auto&... batch) { (evaluate(batch), ...); }, batches_);
}

}  // namespace desmo
