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

/// Copies the components that belong to the part to their places.
template <std::size_t N>
void pick(const std::array<int, N>& rows, const std::array<double, N>& all, double* to) {
  for (std::size_t r = 0; r < N; ++r)
    if (rows[r] >= 0) to[rows[r]] = all[r];
}

}  // namespace

AutomaticEquations::AutomaticEquations(const Mechanism& m, const PartDefinition& part) {
  std::vector<JacobianEntry> entries;
  const int n = static_cast<int>(part.equations.size());
  for (int row = 0; row < n;) {
    const int position = part.equations[row].constraint;
    const Constraint& constraint = m.constraints[position];
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      typename Batch<Kind>::Object o;
      for (std::size_t k = 0; k < o.operands.size(); ++k)
        o.operands[k] = m.state_index(constraint.operands[k]);
      std::ranges::copy(constraint.constants, o.constants.begin());
      o.row = row;
      o.rows.fill(-1);
      for (; row < n && part.equations[row].constraint == position; ++row)
        o.rows[part.equations[row].row] = row;

      int i = 0;
      static constexpr std::array<double, 3> any{1, 1, 1};  // the pattern is that of all values
      Operands<Kind> x;
      x.fill(any.data());
      Kind::jacobian(x.data(), o.constants.data(), [&](int r, int operand, int component, double) {
        o.slots[i++] = static_cast<int>(entries.size());  // its place in `entries`, for now
        entries.push_back({o.rows[r], o.operands[operand] + component,
                           m.rests(constraint.operands[operand])});
      });
      Batch<Kind>& batch = std::get<Batch<Kind>>(batches_);
      (row - o.row == Kind::rows ? batch.whole : batch.cut).push_back(o);
    });
  }

  PatternWithSlots made = make_pattern(m, part, entries);
  pattern_ = std::move(made.pattern);
  const auto assign = [&](auto& batch) {
    for (auto* objects : {&batch.whole, &batch.cut})
      for (auto& o : *objects)
        for (int& slot : o.slots) slot = made.slots[slot];
  };
  std::apply([&](auto&... batch) { (assign(batch), ...); }, batches_);
}

void AutomaticEquations::constant_jacobian(double* values) const {
  const auto write = [&]<class Kind>(const Batch<Kind>& batch) {
    if constexpr (Kind::linear)
      for (const auto* objects : {&batch.whole, &batch.cut})
        for (const auto& o : *objects)
          write_jacobian<Kind>(o, Operands<Kind>{}, values);  // they read no state
  };
  std::apply([&](const auto&... batch) { (write(batch), ...); }, batches_);
}

void AutomaticEquations::residual(const double* state, double* phi) const {
  const auto evaluate = [&]<class Kind>(const Batch<Kind>& batch) {
    for (const auto& o : batch.whole) {
      const auto x = pointers(state, o.operands);
      Kind::residual(x.data(), o.constants.data(), phi + o.row);
    }
    for (const auto& o : batch.cut) {
      std::array<double, Kind::rows> all;
      const auto x = pointers(state, o.operands);
      Kind::residual(x.data(), o.constants.data(), all.data());
      pick(o.rows, all, phi);
    }
  };
  std::apply([&](const auto&... batch) { (evaluate(batch), ...); }, batches_);
}

void AutomaticEquations::jacobian(const double* state, double* values) const {
  const auto evaluate = [&]<class Kind>(const Batch<Kind>& batch) {
    if constexpr (!Kind::linear)
      for (const auto* objects : {&batch.whole, &batch.cut})
        for (const auto& o : *objects)
          write_jacobian<Kind>(o, pointers(state, o.operands), values);
  };
  std::apply([&](const auto&... batch) { (evaluate(batch), ...); }, batches_);
}

void AutomaticEquations::quadratic(const double* state, const double* rate, double* gamma) const {
  const auto evaluate = [&]<class Kind>(const Batch<Kind>& batch) {
    for (const auto& o : batch.whole) {
      const auto x = pointers(state, o.operands);
      const auto v = pointers(rate, o.operands);
      Kind::quadratic(x.data(), v.data(), o.constants.data(), gamma + o.row);
    }
    for (const auto& o : batch.cut) {
      std::array<double, Kind::rows> all;
      const auto x = pointers(state, o.operands);
      const auto v = pointers(rate, o.operands);
      Kind::quadratic(x.data(), v.data(), o.constants.data(), all.data());
      pick(o.rows, all, gamma);
    }
  };
  std::apply([&](const auto&... batch) { (evaluate(batch), ...); }, batches_);
}

}  // namespace desmo
