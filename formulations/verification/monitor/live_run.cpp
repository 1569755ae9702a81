#include "formulations/verification/monitor/live_run.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <variant>

#include "formulations/planning/plan.h"
#include "formulations/stepping/diagnosis.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/verification/monitor/accuracy_monitor.h"
#include "formulations/verification/monitor/branch_monitor.h"

namespace desmo {

namespace {

bool are_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double x) { return std::isfinite(x); });
}

LiveSteps& steps_of(Formulation& f) { return *core_of(f).live(); }

/// Everything, up to a level, of a model whose motions are polynomials of degree 5. Velocities are
/// monitored in any case: from positions alone nobody can tell which branch they are on.
Plan whole_plan(const Model& m, const LiveOptions& options) {
  Plan plan{m, {options.levels.begin(), options.levels.end()}, {}, {}};
  plan.levels.resize(m.coordinates(), options.level);
  for (Level& level : plan.levels) level = std::max(level, Level::velocity);
  for (Driver& d : plan.model.drivers) d.motion = Polynomial{std::vector<double>(6)};
  return plan;
}

}  // namespace

/// The monitors of the rows.
struct LiveRun::Monitors {
  /// Drivers follow the polynomial from the row tried last, at time 0, to the last good one.
  Plan plan;
  std::vector<Level> asked;  // of each coordinate
  /// ż of a run of positions alone, made up: of the row tried last, and of the last good one.
  std::vector<double> rates, last_rates;
  std::optional<AccuracyMonitor> accuracy{};
  std::optional<BranchMonitor> branch{};
  std::optional<OneMoreCorrection> corrections{};
};

std::string unsupported_live_reason(const Formulation& f) {
  if (!core_of(f).needs_known_motion()) return {};
  return "segments, threads and a stride need a motion known in advance; live drivers are known "
         "one step at a time";
}

LiveRun::LiveRun(Formulation& f, const LiveOptions& options)
    : formulation_(f),
      options_(options),
      monitors_(std::make_unique<Monitors>(
          whole_plan(f.model(), options),
          std::vector<Level>(options.levels.begin(), options.levels.end()),
          std::vector<double>(f.model().drivers.size()),
          std::vector<double>(f.model().drivers.size()))),
      tried_(f.model().drivers.size()) {
  const std::vector<double> magnitudes = natural_magnitudes(f.model());
  for (const Driver& d : f.model().drivers)
    unit_.push_back(magnitudes[f.model().entities[d.coordinate].first]);
  if (const std::string reason = unsupported_live_reason(f); !reason.empty())
    throw std::invalid_argument(reason);
  if (options.max_sub_steps < 0)
    throw std::invalid_argument("the number of sub-steps must not be negative");
  for (const Level level : all_levels)
    if (options.scales && level <= options.level &&
        !(options.scales->length[level] > 0 && options.scales->rotation[level] > 0))
      throw std::invalid_argument("scales must be positive, for bounds are relative to them");
  const std::size_t n = f.model().coordinates();
  good_.position.resize(n);
  if (options.level >= Level::velocity) good_.velocity.resize(n);
  if (options.level >= Level::acceleration) good_.acceleration.resize(n);
  if (!options.levels.empty() && options.levels.size() != n)
    throw std::invalid_argument("a live run is not given one level for each coordinate");
  monitors_->asked.resize(n, options.level);
  if (!options.levels.empty()) f.solve_only(monitors_->plan.levels);
  options_.levels = {};  // the caller's memory may be gone from here on
  monitors_->corrections.emplace(parts_of(f));
  restart();
}

LiveRun::~LiveRun() = default;

RowFault LiveRun::fault_of(const LiveRow& row) const {
  if (!std::isfinite(row.time)) return RowFault::not_finite;
  const auto fault = [&](std::span<const double> values, Level level) {
    if (level > options_.level) return RowFault::none;
    return values.size() != tried_.size() ? RowFault::wrong_size
           : are_finite(values)           ? RowFault::none
                                          : RowFault::not_finite;
  };
  for (const RowFault f : {fault(row.z, Level::position), fault(row.zd, Level::velocity),
                           fault(row.zdd, Level::acceleration)})
    if (f != RowFault::none) return f;
  return has_position_ && row.time <= time_ ? RowFault::time_not_later : RowFault::none;
}

/// Makes up the rates of a row of positions alone: those of the straight way to it. Drivers rest at
/// the last row where they would not go straight on from there: the cubic would leave the way.
std::span<const double> LiveRun::rates_of(const LiveRow& row) {
  const Model& m = formulation_.model();
  std::vector<double>&rates = monitors_->rates, &last = monitors_->last_rates;
  std::ranges::fill(rates, 0.0);
  if (!has_position_) return rates;
  bool goes_on = true;
  for (std::size_t d = 0; d < rates.size(); ++d) {
    const double start = good_.position[m.entities[m.drivers[d].coordinate].first],
                 rate = (row.z[d] - start) / (row.time - time_);
    if (std::isfinite(rate)) rates[d] = rate;
    goes_on = goes_on && rates[d] * last[d] >= 0 && std::abs(last[d]) <= 3 * std::abs(rates[d]);
  }
  if (!goes_on) {
    std::ranges::fill(last, 0.0);
    monitors_->accuracy->rest();
  }
  return rates;
}

LiveSummary LiveRun::step(const LiveRow& given) {
  LiveSummary summary;
  summary.time = given.time;
  summary.fault = fault_of(given);
  if (summary.fault != RowFault::none) {
    summary.status =
        summary.fault == RowFault::not_finite ? Status::not_finite : Status::not_converged;
    return summary;
  }
  LiveRow row = given;
  if (options_.level < Level::velocity) row.zd = rates_of(given);
  std::ranges::copy(row.z, tried_.begin());
  const Summary step =
      steps_of(formulation_)
          .step_to_row(row, std::max(options_.level, Level::velocity), options_.max_sub_steps);
  static_cast<BasicSummary&>(summary) = step;
  if (step.ok()) assess(row, summary);
  return summary;
}

std::string describe(const LiveSummary& s, const Model& m) {
  switch (s.fault) {
    case RowFault::none:
      return s.violated >= 0 ? "another branch: constraint '" + m.constraints[s.violated].name + "'"
                             : describe(Summary{s}, m);
    case RowFault::wrong_size:
      return "refused: there is not one value for each driver";
    case RowFault::not_finite:
      return "refused: a value or the time is not a finite number";
    case RowFault::time_not_later:
      return "refused: the time is not after the last good row";
  }
  return {};
}

/// Assesses a row that was solved, and makes it the last good one if it is good.
void LiveRun::assess(const LiveRow& row, LiveSummary& summary) {
  const std::span<const double> none;
  if (!set_drivers(row)) monitors_->accuracy->doubt_next();
  const double since = has_position_ ? row.time - time_ : 0;
  monitors_->accuracy->shift_time(-since);
  const long corrected = monitors_->accuracy->corrected();
  const MonitoredInstant j =
      monitors_->accuracy->examine({.index = 0,
                                    .time = 0,
                                    .q = formulation_.q(),
                                    .qd = formulation_.qd(),
                                    .qdd = good_.acceleration.empty() ? none : formulation_.qdd(),
                                    .updates = summary.updates,
                                    .residual = summary.residual});
  const Instant& found = j.instant;
  summary.assessment = j.assessment;
  if (j.assessment.singular) {
    summary.status = Status::singular;
    summary.group = j.assessment.group;
  } else if (!are_finite(found.q) || !are_finite(found.qd) || !are_finite(found.qdd)) {
    summary.status = Status::not_finite;
  } else if (const int c = monitors_->branch->violated(found, j.angles_follow); c >= 0) {
    summary.status = Status::not_converged;
    summary.violated = c;
  }
  if (summary.status != Status::solved) {
    summary.instants = 0;
    go_back();
    return;
  }
  summary.corrected = monitors_->accuracy->corrected() > corrected;
  summary.degraded = j.degraded;
  if ((summary.crossing = j.crossing)) {
    summary.crossing->after += row.time;
    summary.crossing->before += row.time;
    if (!first_crossing_) first_crossing_ = summary.crossing;
  }
  summary.first_crossing = first_crossing_;
  std::ranges::copy(found.q, good_.position.begin());
  if (!good_.velocity.empty()) std::ranges::copy(found.qd, good_.velocity.begin());
  std::ranges::copy(found.qdd, good_.acceleration.begin());
  std::ranges::copy(monitors_->rates, monitors_->last_rates.begin());
  time_ = row.time;
  has_position_ = true;
  if (j.solved_anew) steps_of(formulation_).return_to(good_.position, time_);
}

/// Sets the motions that are monitored: Taylor's polynomial from the row, at time 0, exactly, and
/// terms that take it to the last good row, at time h. Returns whether the rates of both lead from
/// one to the other, about as well as a motion's do that AccuracyMonitor does not doubt.
bool LiveRun::set_drivers(const LiveRow& row) {
  const Model& m = formulation_.model();
  const double h = time_ - row.time;
  double moved = 0, missed = 0;  // by any driver
  for (std::size_t d = 0; d < tried_.size(); ++d) {
    std::vector<double>& c =
        std::get<Polynomial>(monitors_->plan.model.drivers[d].motion).coefficients;
    const int i = m.entities[m.drivers[d].coordinate].first;
    const double z = row.z[d], v = row.zd[d],
                 a = options_.level < Level::acceleration ? 0 : row.zdd[d];
    std::ranges::fill(c, 0.0);
    c[0] = z, c[1] = v, c[2] = a / 2;
    if (!has_position_) continue;
    const double v0 = good_.velocity.empty() ? monitors_->last_rates[d] : good_.velocity[i];
    moved = std::max({moved, std::abs(h * v) / unit_[d], std::abs(h * v0) / unit_[d]});
    missed = std::max(missed, std::abs(good_.position[i] - z - h / 2 * (v + v0)) / unit_[d]);
    const double off = (good_.position[i] - z - h * (v + h * a / 2)) / (h * h * h),
                 rate_off = (v0 - v - h * a) / (h * h);
    if (good_.acceleration.empty()) {
      c[2] = h * (3 * off - rate_off), c[3] = rate_off - 2 * off;
      continue;
    }
    const double second_off = (good_.acceleration[i] - a) / h;
    c[3] = 10 * off - 4 * rate_off + second_off / 2;
    c[4] = (-15 * off + 7 * rate_off - second_off) / h;
    c[5] = (6 * off - 3 * rate_off + second_off / 2) / (h * h);
  }
  constexpr double smooth = 0.02, negligible = 1e-9;
  return missed <= smooth * moved + negligible;
}

void LiveRun::go_back() {
  const std::span<const double> none;
  steps_of(formulation_).return_to(has_position_ ? good_.position : none, time_);
  monitors_->accuracy->resume();
}

void LiveRun::set_time(double t) {
  if (!has_position_) return;
  time_ = t;
  go_back();
}

const Scales& LiveRun::scales() const { return monitors_->accuracy->scales(); }

void LiveRun::restart() {
  has_position_ = false;
  time_ = 0;
  first_crossing_.reset();
  steps_of(formulation_).return_to({}, 0);
  const auto reuses = [](const DefinedPart& part) {
    return part.solver->pivots().may_spoil_rates();
  };
  monitors_->accuracy.emplace(
      monitors_->plan.model, TimeGrid{},
      AccuracyMonitorOptions{.tolerance = formulation_.settings().tolerance,
                             .levels = monitors_->plan.levels,
                             .asked = monitors_->asked,
                             .assesses_all = options_.assesses_all,
                             .reuses_pivots = std::ranges::any_of(parts_of(formulation_), reuses),
                             .scales = options_.scales,
                             .max_steps = options_.max_sub_steps,
                             .max_degradations = 0,
                             .may_allocate = false});
  monitors_->branch.emplace(monitors_->plan.model, monitors_->plan.levels,
                            formulation_.settings().tolerance);
}

LiveRun::Obstacle LiveRun::explain() const {
  const Model& m = formulation_.model();
  std::vector<double> state = has_position_ ? good_.position : m.estimate;
  state.insert(state.end(), m.fixed_values.begin(), m.fixed_values.end());
  for (std::size_t d = 0; d < tried_.size(); ++d)
    state[m.entities[m.drivers[d].coordinate].first] = tried_[d];
  std::vector<GroupId> groups(m.groups.size());
  std::iota(groups.begin(), groups.end(), 0);
  const Settings& settings = formulation_.settings();
  const Culprit culprit = find_culprit(m, groups, state, settings);
  return {culprit.group, culprit.constraint, find_assembly_error(m, state, settings)};
}

}  // namespace desmo
