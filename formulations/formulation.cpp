#include "formulations/formulation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "formulations/diagnosis.h"
#include "formulations/guess.h"

namespace desmo {

void drive(const Mechanism& m, double t, State& state) {
  for (const Driver& d : m.drivers) {
    const int i = m.entities[d.coordinate].first;
    const MotionSample<double> z = sample(d.motion, t);
    state.q[i] = z.position;
    state.qd[i] = z.velocity;
    state.qdd[i] = z.acceleration;
  }
}

std::string describe(const Summary& s, const Mechanism& m) {
  char text[160];
  if (s.ok()) {
    std::snprintf(text, sizeof text, "converged: %ld instants, %ld iterations, residual %.2e",
                  s.instants, s.iterations, s.residual);
    return text;
  }
  const char* reason = s.status == Status::singular        ? "singular Jacobian"
                       : s.status == Status::not_converged ? "no convergence"
                                                           : "the equations are not finite";
  std::snprintf(text, sizeof text, "%s at t = %.9g s, residual %.2e", reason, s.time, s.residual);
  std::string result = text;
  if (s.group >= 0) result += ", group '" + m.groups[s.group].name + "'";
  if (s.constraint >= 0) result += ", constraint '" + m.constraints[s.constraint].name + "'";
  return result;
}

Formulation::Formulation(const Mechanism& mechanism, std::vector<DefinedPart> parts,
                         const Settings& settings)
    : mechanism_(mechanism), parts_(std::move(parts)), settings_(settings) {
  state_.q.resize(mechanism_.state_size());
  state_.qd.resize(mechanism_.state_size());
  state_.qdd.resize(mechanism_.state_size());
  start_.resize(mechanism_.state_size());
}

void Formulation::solve_only(std::span<const Level> needed) {
  for (DefinedPart& part : parts_) {
    part.level = Level::position;
    for (const int i : part.definition.unknowns) part.level = std::max(part.level, needed[i]);
  }
}

void Formulation::guess(double t) {
  const Level needed = level_needed(settings_.guess);
  if (solved_level_ < needed) return;
  for (const auto& [definition, solver, as_named, part_level] : parts_)
    if (!definition.constant && part_level >= needed)
      extrapolate(settings_.guess, definition.unknowns, t - time_, state_);
}

Summary Formulation::solve_parts(double t, Level level, bool constant) {
  Summary summary;
  summary.time = t;
  double residual2 = 0;
  for (const auto& [definition, solver, as_named, part_level] : parts_) {
    if (definition.constant != constant) continue;
    const PartResult r = solver->solve(state_, std::min(level, part_level));
    residual2 += r.residual * r.residual;
    summary.iterations = std::max<long>(summary.iterations, r.iterations);
    if (r.status != Status::converged) {
      summary.status = r.status;
      for (const int i : definition.unknowns) state_.q[i] = start_[i];
      const Culprit c = find_culprit(mechanism_, definition.groups, state_.q, settings_);
      summary.group = c.group;
      summary.constraint = c.constraint;
      break;
    }
  }
  summary.residual = std::sqrt(residual2);
  summary.instants = summary.ok();
  return summary;
}

Summary Formulation::assemble(double t, Level level) {
  std::ranges::copy(mechanism_.estimate, state_.q.begin());
  std::ranges::copy(mechanism_.fixed_values, state_.q.begin() + mechanism_.coordinates());
  std::ranges::fill(state_.qd, 0.0);
  std::ranges::fill(state_.qdd, 0.0);
  start_ = state_.q;
  assembled_ = false;
  solved_level_ = Level::position;  // nothing to extrapolate from
  Summary summary = solve_parts(t, level, true);
  if (!summary.ok()) return summary;
  assembled_ = true;
  summary = step(t, level);
  assembled_ = summary.ok();
  return summary;
}

Summary Formulation::step(double t, Level level) {
  if (!assembled_) return assemble(t, level);
  std::ranges::copy(state_.q, start_.begin());
  guess(t);
  drive(mechanism_, t, state_);
  const Summary summary = solve_parts(t, level, false);
  if (!summary.ok()) std::ranges::copy(start_, state_.q.begin());
  time_ = t;
  solved_level_ = summary.ok() ? level : Level::position;
  return summary;
}

Summary Formulation::run(const TimeGrid& grid, const Request& request, Sink& sink) {
  Summary total;
  for (int i = 0; i < grid.instants; ++i) {
    const double t = grid.time(i);
    const Summary s = i == 0 ? assemble(t, request.level) : step(t, request.level);
    total.time = t;
    total.iterations += s.iterations;
    if (!s.ok()) {
      total.status = s.status;
      total.group = s.group;
      total.constraint = s.constraint;
      total.residual = s.residual;
      return total;
    }
    ++total.instants;
    total.residual = std::max(total.residual, s.residual);
    sink.accept({i, t, q(), request.level >= Level::velocity ? qd() : std::span<const double>{},
                 request.level >= Level::acceleration ? qdd() : std::span<const double>{}});
  }
  return total;
}

}  // namespace desmo
