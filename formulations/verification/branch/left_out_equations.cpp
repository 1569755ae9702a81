#include "formulations/verification/branch/left_out_equations.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/numbers/compensated.h"
#include "formulations/constraints/constraints.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/verification/branch/file_variation.h"
#include "formulations/verification/certificate/table_enclosure.h"

namespace desmo {

namespace {

using Number = Compensated<double>;

std::vector<Equation> left_out_of(const Model& m) {
  std::vector<Equation> all;
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c)
    for (int row = 0; row < rows(m.constraints[c]); ++row)
      if (m.constraints[c].left_out >> row & 1) all.push_back({c, row});
  return all;
}

}  // namespace

LeftOutEquations::LeftOutEquations(const Model& m) : m_(m), equations_(left_out_of(m)) {
  if (equations_.empty()) return;
  varied_ = with_file_variation(m);
  certifier_.emplace(varied_);
  const CharacteristicLengths lengths(m);
  for (const Equation& e : equations_) length_.push_back(lengths.of(m.constraints[e.constraint]));
  state_.resize(m.coordinates());
  state_.insert(state_.end(), m.fixed_values.begin(), m.fixed_values.end());
}

/// Returns an interval that holds Φ of an equation for all dimensions of the model and all
/// positions within their radii.
Interval LeftOutEquations::residual(const Equation& equation, std::span<const double> q,
                                    std::span<const double> radius) const {
  const Model& m = varied_;
  const Constraint& c = m.constraints[equation.constraint];
  Interval result;
  visit_kind(c.kind, [&]<class Kind>(Kind) {
    constexpr std::size_t operands = Kind::operand_sizes.size();
    std::array<std::array<Number, 3>, operands> components;
    std::array<const Number*, operands> x;
    for (std::size_t k = 0; k < operands; ++k) {
      const Entity& e = m.entities[c.operands[k]];
      for (int i = 0; i < e.size; ++i)
        components[k][i] = e.fixed ? Number(m.fixed_value(e.first + i))
                                   : Number(q[e.first + i], 0, radius[e.first + i]);
      x[k] = components[k].data();
    }
    std::array<Number, Kind::constants + 1> dimensions;
    for (int k = 0; k < Kind::constants; ++k) dimensions[k] = Number(c.dimension(k));
    if constexpr (has_table<Kind>)
      read_table<Kind>(dimensions, x.data(),
                       [&](int, int k) { return c.dimension(Kind::table + k); });
    std::array<Number, Kind::rows> phi;
    Kind::residual(x.data(), dimensions.data(), phi.data());
    result = phi[equation.row].enclosure();
    if (const std::size_t slack = c.constants.size() + equation.row; slack < c.remainders.size())
      result.radius += c.remainders[slack].radius;
  });
  return result;
}

bool LeftOutEquations::holds(const Equation& equation, std::span<const double> q,
                             std::span<const double> radius) const {
  const Interval phi = residual(equation, q, radius);
  return !(std::abs(phi.mid) > phi.radius);
}

std::optional<Misfit> LeftOutEquations::check(const RefinedInstant& refined,
                                              const LiveRow* drivers) {
  const std::span<const double> q = refined.instant.q;
  const auto all_hold = [&](std::span<const double> radius) {
    return std::ranges::all_of(equations_, [&](const Equation& e) { return holds(e, q, radius); });
  };
  if (!refined.proven || all_hold(refined.radius.position)) return {};
  const std::span<const double> known = radius(refined.instant, drivers);
  std::ranges::copy(q, state_.begin());
  std::optional<Misfit> worst;
  double largest = 0;  // of misfits over lengths
  for (std::size_t i = 0; i < equations_.size(); ++i) {
    const Equation& e = equations_[i];
    if (holds(e, q, known)) continue;
    const Misfit misfit = misfit_of(m_, e.constraint, e.row, residual(e, q, known).mid, state_);
    const double relative = misfit.is_length ? misfit.amount / length_[i] : misfit.amount;
    if (!(relative > largest)) continue;
    largest = relative;
    worst = misfit;
  }
  return worst;
}

std::span<const double> LeftOutEquations::radius(const Instant& instant, const LiveRow* drivers) {
  const Instant positions{
      .index = instant.index, .time = instant.time, .q = instant.q, .qd = {}, .qdd = {}};
  const Certificate c =
      drivers ? certifier_->certify(positions, *drivers) : certifier_->certify(positions);
  return c.radius.position;
}

}  // namespace desmo
