#include "formulations/verification/branch/left_out_equations.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/numbers/compensated.h"
#include "formulations/constraints/kind_functions.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/modelling/independence/linearisation.h"
#include "formulations/verification/branch/file_variation.h"
#include "formulations/verification/certificate/hermite.h"
#include "formulations/verification/certificate/table_enclosure.h"
#include "formulations/verification/certificate/taylor_model.h"

namespace desmo {

namespace {

using Number = Compensated<double>;

/// Values of s in a step at which misfits are looked for. The ends s = −1 and 1 are instants, which
/// check() looks at. Values next to the ends are left out: a misfit of an end reaches there, and
/// CheckedMotion would then follow the whole step by other equations.
constexpr std::array looks{-0.875, -0.75, -0.625, -0.5, -0.375, -0.25, -0.125, 0.,
                           0.125,  0.25,  0.375,  0.5,  0.625,  0.75,  0.875};

std::vector<Equation> left_out_of(const Model& m) {
  std::vector<Equation> all;
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c)
    for (int row = 0; row < rows(m.constraints[c]); ++row)
      if (m.constraints[c].left_out >> row & 1) all.push_back({c, row});
  return all;
}

/// Memory for the equations of a constraint. It is kept from one to the next, since setting it to
/// zero costs about as much as an evaluation.
template <class S>
struct Workspace {
  std::array<std::array<S, max_components>, max_operands> components;
  std::array<S, max_constants> constants;
  std::array<S, max_rows> phi;
};

/// Evaluates Φ of an equation in the scalar S. coordinate(i): coordinate i in S.
template <class S>
S value_of(const Model& m, const Equation& equation, const auto& coordinate, Workspace<S>& work) {
  const Constraint& c = m.constraints[equation.constraint];
  const KindDescription& kind = description_of(c.kind);
  auto& [components, constants, phi] = work;
  std::array<const S*, max_operands> x{};
  for (std::size_t k = 0; k < c.operands.size(); ++k) {
    const Entity& e = m.entities[c.operands[k]];
    for (int i = 0; i < e.size; ++i)
      components[k][i] = e.fixed ? S(m.fixed_value(e.first + i)) : coordinate(e.first + i);
    x[k] = components[k].data();
  }
  for (int k = 0; k < (kind.table < 0 ? kind.constants : kind.table); ++k)
    constants[k] = S(c.constants[k]);
  if (kind.table >= 0)
    set_table_constants(constants.data(), x.data(), [&](int, int k) { return c.constants[k]; });
  KindFunctions<S>::residual(c.kind, x.data(), constants.data(), phi.data());
  return phi[equation.row];
}

/// Returns an interval that holds Φ of an equation for all dimensions of the varied model and all
/// positions within `radius` of q.
Interval residual(const Model& varied, const Equation& equation, std::span<const double> q,
                  std::span<const double> radius, Workspace<Number>& work) {
  const auto coordinate = [&](int i) { return Number(q[i], 0, radius[i]); };
  Interval phi = value_of<Number>(varied, equation, coordinate, work).enclosure();
  const Constraint& c = varied.constraints[equation.constraint];
  if (!c.slack.empty()) phi.radius += c.slack[equation.row];
  return phi;
}

}  // namespace

LeftOutEquations::LeftOutEquations(const Model& m) : m_(m), equations_(left_out_of(m)) {
  if (equations_.empty()) return;
  varied_ = with_file_variation(m);
  certifier_.emplace(varied_);
  refinement_.emplace(m);
  drivers_.resize(m.drivers.size());
  const CharacteristicLengths lengths(m);
  for (std::size_t i = 0; i < equations_.size(); ++i) {
    const Constraint& c = m.constraints[equations_[i].constraint];
    length_.push_back(lengths.of(c));
    if (!is_constant(m, c)) changing_.push_back(i);
  }
  state_ = m.state_of(m.estimate);
}

std::optional<Misfit> LeftOutEquations::check(const RefinedInstant& refined,
                                              const LiveRow* drivers) {
  const std::span<const double> q = refined.instant.q;
  const auto fails = [](const Interval& phi) { return std::abs(phi.mid) > phi.radius; };
  Workspace<Number> work;
  const auto fails_here = [&](const Equation& e) {
    return fails(residual(varied_, e, q, refined.radius.position, work));
  };
  if (!refined.proven || std::ranges::none_of(equations_, fails_here)) return {};
  const Instant positions = instant_of(refined.instant.time, {q});
  const Certificate varied =
      drivers ? certifier_->certify(positions, *drivers) : certifier_->certify(positions);
  std::ranges::copy(q, state_.begin());
  std::optional<Misfit> worst;
  for (std::size_t i = 0; i < equations_.size(); ++i) {
    const Interval phi = residual(varied_, equations_[i], q, varied.radius.position, work);
    if (!fails(phi)) continue;
    const Misfit found = misfit(i, phi.mid);
    if (found.relative > (worst ? worst->relative : 0)) worst = found;
  }
  return worst;
}

Misfit LeftOutEquations::misfit(std::size_t i, double residual) const {
  const auto& [constraint, row] = equations_[i];
  Misfit result = misfit_of(m_, constraint, row, residual, state_);
  result.relative = result.over(length_[i]);
  return result;
}

bool LeftOutEquations::look_along(const PathProof& step) {
  using Path = TaylorModel<double, path_degree>;
  if (changing_.empty()) return true;  // for the others, check() is enough
  go_to(step, 0);
  const auto path = [&](int k) {
    Path x;
    x.c = step.path(k);
    x.rest = step.radius(k);
    return x;
  };
  Workspace<Path> work;
  for (const std::size_t i : changing_) {
    const Path phi = value_of<Path>(varied_, equations_[i], path, work);
    const bool is_long = !(misfit(i, phi.magnitude()).relative <= max_misfit);
    const auto is_missed = [&](double s) { return std::abs(value_at(phi.c, s)) > phi.rest; };
    if (!is_long && std::ranges::none_of(looks, is_missed)) continue;
    if (!is_told_at(i, step, worst_place(i, step)) && is_long) return false;
  }
  return true;
}

/// Sets `state_` to the positions of a step's path at s.
void LeftOutEquations::go_to(const PathProof& step, double s) {
  for (int k = 0; k < m_.coordinates(); ++k) state_[k] = value_at(step.path(k), s);
}

/// Returns the s among `looks` at which |Φ| of equation i is largest on the path of a step.
double LeftOutEquations::worst_place(std::size_t i, const PathProof& step) {
  double largest = -1, place = 0;
  Workspace<Number> work;
  for (const double s : looks) {
    go_to(step, s);
    const auto coordinate = [&](int k) { return Number(state_[k]); };
    const double phi =
        std::abs(value_of<Number>(varied_, equations_[i], coordinate, work).enclosure().mid);
    if (phi > largest) largest = phi, place = s;
  }
  return place;
}

/// Looks at a point of a step for the sake of equation i. If any equation has a misfit there, notes
/// the largest. Returns false if a shorter step, whose enclosure is tighter, may tell more.
bool LeftOutEquations::is_told_at(std::size_t i, const PathProof& step, double s) {
  go_to(step, s);
  const std::span<const double> q = std::span(state_).first(m_.coordinates());
  const RefinedInstant& point = refinement_->refine(instant_of(step.time_at(s), {q}));
  if (!point.proven) return false;
  // Next to a singular position, corrections may lead to another solution.
  for (int k = 0; k < m_.coordinates(); ++k)
    if (!(std::abs(point.instant.q[k] - state_[k]) <= step.radius(k) + point.radius.position[k]))
      return false;
  for (std::size_t k = 0; k < drivers_.size(); ++k)
    drivers_[k] = point.instant.q[m_.entities[m_.drivers[k].coordinate].first];
  const LiveRow drivers{.time = point.instant.time, .z = drivers_};
  if (const std::optional<Misfit> found = check(point, &drivers)) {
    note(Between{*found, point.instant.time});
    return true;
  }
  // No misfit is proven at the point. If one may exceed half of max_misfit even over the point's
  // own box, shorter steps are given up: they would hardly prove more.
  Workspace<Number> work;
  const Interval phi =
      residual(varied_, equations_[i], point.instant.q, point.radius.position, work);
  return !(misfit(i, phi.magnitude()).relative <= max_misfit / 2);
}

}  // namespace desmo
