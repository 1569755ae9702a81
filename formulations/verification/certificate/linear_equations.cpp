#include "formulations/verification/certificate/linear_equations.h"

#include <algorithm>
#include <array>

#include "formulations/constraints/constraints.h"
#include "formulations/verification/certificate/table_enclosure.h"

namespace desmo {

namespace {

LaneInterval about_double(const Compensated<LaneNumbers>& x) { return {x.value, rest_of(x)}; }

}  // namespace

LinearEquations::LinearEquations(const BlockShape& shape,
                                 const std::vector<Compensated<LaneNumbers>>& constants,
                                 const std::vector<Compensated<LaneNumbers>>& remainders)
    : offsets_(shape.unknowns) {
  for (const BlockShape::Object& o : shape.objects) add(o, &constants[o.first_constant]);
  std::ranges::stable_sort(terms_, {}, &Term::row);
  for (const auto& offset : offsets_) at_origin_.push_back(about_double(offset));
  add_remainders(remainders);
}

void LinearEquations::add(const BlockShape::Object& o, const Compensated<LaneNumbers>* constants) {
  visit_kind(o.kind, [&]<class Kind>(Kind) {
    if constexpr (Kind::linear) {
      using S = Compensated<LaneNumbers>;
      const int* slot = o.slots.data();
      const std::array<S, max_components> zero{};
      std::array<const S*, Kind::operand_sizes.size()> origin;
      origin.fill(zero.data());
      std::array<S, Kind::rows> at_origin;
      Kind::residual(origin.data(), constants, at_origin.data());
      for (int r = 0; r < Kind::rows; ++r)
        if (o.rows[r] >= 0) offsets_[o.rows[r]] = at_origin[r];
      Kind::jacobian(origin.data(), constants, [&](int r, int operand, int i, const S& factor) {
        const int state = o.operands[operand] + i;
        if (o.rows[r] >= 0)
          terms_.push_back({o.rows[r], state, *slot, factor, about_double(factor)});
        ++slot;
      });
    }
  });
}

/// Adds what fixed states lack to Φ(0), or leaves out offsets that are all zero.
void LinearEquations::add_remainders(const std::vector<Compensated<LaneNumbers>>& remainders) {
  const auto is_some = [](const Compensated<LaneNumbers>& x) {
    return (!is_zero(abs(x.value) + abs(x.correction) + x.radius)).any();
  };
  const auto has_remainder = [&](const Term& t) { return is_some(remainders[t.state]); };
  if (std::ranges::none_of(terms_, has_remainder) && std::ranges::none_of(offsets_, is_some))
    return offsets_.clear();
  for (const Term& t : terms_) offsets_[t.row] = offsets_[t.row] + t.factor * remainders[t.state];
}

void LinearEquations::motion(const PerLevel<const LaneInterval*>& x, Level level,
                             const PerLevel<LaneInterval*>& phi) const {
  for_each_row([&](int row, std::span<const Term> terms) {
    for (const Level l : all_levels) {
      Compensated<LaneNumbers> sum;
      for (const Term& t : terms) sum.add_product(t.factor, x[l][t.state].mid);
      if (l == Level::position && !offsets_.empty()) sum = sum + offsets_[row];
      phi[l][row] = sum.enclosure();
      if (l == level) break;
    }
  });
}

void LinearEquations::jacobian(LaneMatrix& to) const {
  for (std::vector<LaneNumbers>* part : {&to.mid, &to.radius})
    std::ranges::fill(*part, LaneNumbers(0));
  for (const Term& t : terms_) to.set(t.slot, t.factor.enclosure());
}

}  // namespace desmo
