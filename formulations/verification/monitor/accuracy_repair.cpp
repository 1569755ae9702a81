#include <algorithm>
#include <cmath>
#include <numbers>

#include "formulations/verification/assessment/nominal_continuation.h"
#include "formulations/verification/monitor/accuracy_state.h"

namespace desmo {

/// Goes the step again in shorter ones. Where they lead elsewhere it takes what they lead to, if
/// that is a solution. Returns the jump otherwise.
std::optional<Continuity::Jump> AccuracyMonitor::State::find_jump(MonitoredInstant& j,
                                                                  bool from_noise) {
  const auto jump = continuity.find_jump(with_known_rates(j.instant), means());
  if (!jump || jump->crossing.kind == SingularityCrossing::Kind::passed) return jump;
  if (from_noise || !has(Monitor::repair)) return jump;  // from where shorter steps lead anywhere
  if (const auto solved = solve_anew(j.instant); solved && !continuity.passed()) {
    const Instant found = kept(*solved);
    Assessment a = assessor(found, scales.with(found));
    measure(a, found);
    if (!a.singular && !exceeds(a.bound, {unusable_rate, unusable_rate, unusable_rate})) {
      j.instant = found;
      j.solved_anew = true;
      ++corrected;
      return {};
    }
  }
  return jump;
}

std::optional<MonitoredInstant> AccuracyMonitor::State::solve(const Instant& instant) {
  const auto solved = continuity.is_known() ? solve_from_last(instant) : solve_alone(instant);
  if (!solved) return {};
  MonitoredInstant j{kept(*solved)};
  j.solved_anew = true;
  const auto passed = continuity.is_known() ? continuity.passed() : std::nullopt;
  assess(j, signals_of(j.instant, {}), false);
  if (j.assessment.singular) return {};
  if (!j.crossing) j.crossing = passed;
  ++corrected;
  if (!is_poor(j)) deliver(j, true);
  return j;
}

std::optional<Instant> AccuracyMonitor::State::solve_from_last(const Instant& instant) {
  continuity.expect(instant);
  return solve_anew(instant);
}

/// Forgets the instant delivered last.
void AccuracyMonitor::State::take_back(const Instant& instant) {
  RecentInstants& recent = continuity.recent();
  if (recent.count() > 0 && recent[0].is_assessed) signs.take_back();
  recent.drop();
  degradations.take_back(instant.index);
  worst = worst_before;
  const Scales before = scales.current();
  scales.take_back(instant.time);
  follow_scales(before);
}

/// Solves an instant anew that looks singular where it is: it may be off. Returns whether it is
/// regular after all.
bool AccuracyMonitor::State::solve_singular(MonitoredInstant& j,
                                            const Expectation::Signals& signals) {
  const auto solved = continuity.is_known() ? solve_anew(j.instant) : solve_declared(j.instant);
  if (!solved) return false;
  MonitoredInstant other{kept(*solved)};
  other.solved_anew = true;
  const auto passed = continuity.is_known() ? continuity.passed() : std::nullopt;
  assess(other, signals, false);
  if (other.assessment.singular) return false;
  if (!other.crossing) other.crossing = passed;
  ++corrected;
  j = other;
  return true;
}

/// Solves an instant anew whose determinants have other signs than the last one's. A small part
/// that is carried fast may have been assembled as its mirror image, which rates hardly show. So
/// the drivers go there from the last instant in steps in which determinants hardly change.
void AccuracyMonitor::State::solve_crossed(MonitoredInstant& j,
                                           const Expectation::Signals& signals) {
  if (j.crossing->kind != SingularityCrossing::Kind::passed || !continuity.is_known()) return;
  const RecentInstants::Node& from = continuity.recent()[0];
  const Instant target = continuity.driven(j.instant);
  const bool turns = std::ranges::any_of(model.drivers, [&](const Driver& d) {
    const Entity& e = model.entities[d.coordinate];
    return e.kind == EntityKind::angle &&
           std::abs(target.q[e.first] - from.state.q[e.first]) > std::numbers::pi;
  });
  NominalContinuation way(model, assessor.system());
  if (turns || !way.begin_at(from.state.q) || !way.go_to(target)) return;
  const desmo::State given{{j.instant.q.begin(), j.instant.q.end()},
                           {j.instant.qd.begin(), j.instant.qd.end()},
                           {j.instant.qdd.begin(), j.instant.qdd.end()}};
  Instant there = target;
  there.q = way.q();
  MonitoredInstant other{kept(assessor.corrected(there))};
  other.solved_anew = true;
  assess(other, signals, false);
  if (other.assessment.singular || other.crossing) {  // what is kept is to be of the instant
    Instant again = j.instant;
    again.q = given.q, again.qd = given.qd, again.qdd = given.qdd;
    j.instant = kept(again);
    assess(j, signals, false);
    return;
  }
  ++corrected;
  j = other;
}

/// Goes to the first instant from the nominal position. Where that leads elsewhere, the instant is
/// what it leads to.
void AccuracyMonitor::State::declare(MonitoredInstant& j) {
  if (!has(Monitor::orientation) || !has(Monitor::continuation)) return;
  NominalContinuation way(model, assessor.system());
  is_declared = way.begin() && way.go_to(continuity.driven(j.instant));
  if (!is_declared) return;
  declared.assign(way.q().begin(), way.q().end());
  if (way.leads_to(j.instant.q)) return;
  j.instant = kept(*solve_declared(j.instant));
  j.solved_anew = true;
  ++corrected;
}

/// Solves the first instant from where the nominal position leads.
std::optional<Instant> AccuracyMonitor::State::solve_declared(const Instant& instant) {
  if (!is_declared) return {};
  Instant there = instant;
  there.q = declared;
  return assessor.corrected(continuity.driven(there));
}

/// Corrects positions that have hardly missed their tolerance, as in single precision.
std::optional<Instant> AccuracyMonitor::State::solve_alone(const Instant& instant) {
  MonitoredInstant j{continuity.driven(instant)};
  if (!started) declare(j);
  const Instant solved = j.solved_anew ? j.instant : assessor.corrected(j.instant);
  const Assessment a = assessor(solved, scales.with(solved));
  if (a.singular || exceeds(a.bound, limits.degraded)) return {};
  return solved;
}

std::optional<MonitoredInstant> AccuracyMonitor::State::pass(const Instant& singular) {
  if (!has(Monitor::passage)) return {};
  const auto p = continuity.pass(singular, means());
  if (!p) return {};
  MonitoredInstant j{p->instant};
  j.degraded = j.solved_anew = true;
  j.assessment = p->assessment;
  j.assessment.limit = Limit::singular_position;
  j.assessment.bound = difference(p->instant, p->wide);
  j.crossing = {p->after, p->before, last.group, SingularityCrossing::Kind::passed};
  deliver(j, true);
  degraded = true;  // so the next is assessed
  beyond = {p->beyond, p->before};
  ++corrected;
  return j;
}

/// The largest difference of two instants over outputs, relative to the scales.
PerLevel<double> AccuracyMonitor::State::difference(const Instant& a, const Instant& b) const {
  PerLevel<double> result{};
  const auto add = [&](Level level, std::span<const double> x, std::span<const double> y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double scale = scales.current().of(model.entities[entity[i]].kind, level);
      if (asked[i] >= level && scale > 0)
        result[level] = std::max(result[level], std::abs(x[i] - y[i]) / scale);
    }
  };
  add(Level::position, a.q, b.q);
  add(Level::velocity, a.qd, b.qd);
  add(Level::acceleration, a.qdd, b.qdd);
  return result;
}

/// Solves an instant in short steps from the last one, as far as rates are known there.
std::optional<Instant> AccuracyMonitor::State::solve_anew(const Instant& instant) {
  const Level known = known_rates();
  const auto solved = continuity.solve_anew(instant, means(), known);
  return solved && known < Level::acceleration ? assessor.corrected(*solved) : solved;
}

/// Returns the level up to which rates of the last instant lead on. Accelerations that are noise do
/// not, where velocities do.
Level AccuracyMonitor::State::known_rates() {
  if (!continuity.is_known()) return Level::acceleration;
  const PerLevel<double>& stated = continuity.recent()[0].stated;
  return stated.acceleration <= unusable_rate || !(stated.velocity <= unusable_rate)
             ? Level::acceleration
             : Level::velocity;
}

Instant AccuracyMonitor::State::with_known_rates(const Instant& instant) {
  Instant known = instant;
  if (known_rates() < Level::acceleration) known.qdd = {};
  return known;
}

}  // namespace desmo
