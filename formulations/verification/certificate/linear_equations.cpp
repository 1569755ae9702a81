#include "formulations/verification/certificate/linear_equations.h"

#include <algorithm>
#include <array>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/verification/certificate/table_enclosure.h"

namespace desmo {

namespace {

/// Returns a number as an interval whose midpoint is the number's leading double.
LaneInterval about_double(const Compensated<LaneNumbers>& x) { return {x.value, rest_of(x)}; }

/// Returns whether a number is not exactly 0 in some lane.
bool is_some(const Compensated<LaneNumbers>& x) {
  return (!is_zero(abs(x.value) + abs(x.correction) + x.radius)).any();
}

}  // namespace

LinearEquations::LinearEquations(const BlockShape& shape,
                                 const std::vector<Compensated<LaneNumbers>>& constants,
                                 const std::vector<Compensated<LaneNumbers>>& fixed) {
  for (const BlockShape::Object& o : shape.objects) add(o, &constants[o.first_constant]);
  for (Equation& e : equations_) {
    has_offsets_ |= is_some(e.offset);
    for (const Term& t : e.terms) {
      const auto& [value, correction, radius] = fixed[t.state];
      const Compensated<LaneNumbers> remainder(0, correction, radius);
      e.offset = e.offset + t.factor * remainder;
      has_offsets_ |= is_some(remainder);
    }
  }
}

void LinearEquations::add(const BlockShape::Object& o, const Compensated<LaneNumbers>* constants) {
  visit_kind(o.kind, [&]<class Kind>(Kind) {
    if constexpr (Kind::linear) {
      using S = Compensated<LaneNumbers>;
      const std::array<S, max_components> zero{};
      std::array<const S*, Kind::operand_sizes.size()> origin;
      origin.fill(zero.data());
      std::array<S, Kind::rows> phi;
      Kind::residual(origin.data(), constants, phi.data());
      std::array<Equation, Kind::rows> rows;
      for (int r = 0; r < Kind::rows; ++r) rows[r] = {o.rows[r], about_double(phi[r]), phi[r], {}};
      const int* slot = o.slots.data();
      Kind::jacobian(origin.data(), constants, [&](int r, int operand, int i, const S& factor) {
        rows[r].terms.push_back({o.operands[operand] + i, *slot++, factor, about_double(factor)});
      });
      for (Equation& e : rows)
        if (e.row >= 0) equations_.push_back(std::move(e));
    }
  });
}

void LinearEquations::motion(const PerLevel<std::vector<LaneInterval>>& x, Level level,
                             PerLevel<std::vector<LaneInterval>>& phi) const {
  for (const Equation& e : equations_)
    for (const Level l : all_levels) {
      Compensated<LaneNumbers> sum;
      for (const Term& t : e.terms) sum.add_product(t.factor, x[l][t.state].mid);
      if (l == Level::position && has_offsets_) sum = sum + e.offset;
      phi[l][e.row] = sum.enclosure();
      if (l == level) break;
    }
}

void LinearEquations::residual(const PathValue* x, PathValue* phi) const {
  for (const Equation& e : equations_) {
    PathValue sum;
    sum.c[0] = e.at_origin.mid;
    sum.rest = e.at_origin.radius;
    for (const Term& t : e.terms) sum.add_product(t.enclosed, x[t.state]);
    phi[e.row] = sum;
  }
}

void LinearEquations::jacobian(LaneMatrix& to) const {
  for (std::vector<LaneNumbers>* part : {&to.mid, &to.radius})
    std::ranges::fill(*part, LaneNumbers(0));
  for (const Equation& e : equations_)
    for (const Term& t : e.terms) to.set(t.slot, t.factor.enclosure());
}

}  // namespace desmo
