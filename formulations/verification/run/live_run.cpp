#include "formulations/verification/run/live_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "formulations/motion/diagnosis.h"
#include "formulations/motion/internals.h"
#include "formulations/verification/run/assembly_error.h"
#include "formulations/verification/run/follower.h"
#include "formulations/verification/run/relative_radius.h"
#include "formulations/verification/run/row_motions.h"
#include "formulations/verification/run/running_scales.h"

namespace desmo {

/// What proves rows, and what is kept from one row to the next.
struct LiveRun::Checks {
  RowMotions motions;
  std::vector<Level> levels;  // of each coordinate
  std::optional<RunningScales> scales{};
  std::optional<Follower> follower{};
  InstantCopy begin{};            // the last proven row
  std::optional<RowFlag> lost{};  // flag of all rows since the branch became unknown
};

std::string unsupported_live_reason(const Formulation& f) {
  const Settings& s = f.settings();
  if (s.segments == 1 && s.threads == 1 && s.stride == 1) return {};
  return "segments, threads and a stride need a motion known in advance; live drivers are known "
         "one step at a time";
}

LiveRun::LiveRun(Formulation& f, const LiveOptions& options)
    : formulation_(f), options_(options), tried_(f.model().drivers.size()) {
  if (const std::string reason = unsupported_live_reason(f); !reason.empty())
    throw std::invalid_argument(reason);
  if (options.max_sub_steps < 0)
    throw std::invalid_argument("the number of sub-steps must not be negative");
  if (options.check != CheckMode::none && options.check != CheckMode::proof)
    throw std::invalid_argument("live rows are checked by a proof of each, or not at all");
  if (options.check == CheckMode::none)
    stepping_of(f).assemble_in_short_steps();
  else
    require_natural(f.model());
  for (const Level level : all_levels)
    if (options.scales && level <= options.level &&
        !(options.scales->length[level] > 0 && options.scales->rotation[level] > 0))
      throw std::invalid_argument("scales must be positive, for radii are relative to them");
  const std::size_t n = f.model().coordinates();
  if (!options.levels.empty() && options.levels.size() != n)
    throw std::invalid_argument("a live run is not given one level for each coordinate");
  checks_ =
      std::make_unique<Checks>(RowMotions(f.model(), options.level),
                               std::vector<Level>(options.levels.begin(), options.levels.end()));
  checks_->levels.resize(n, options.level);
  if (!options.levels.empty()) f.solve_only(checks_->levels);
  options_.levels = {};  // the caller's memory may be gone once this returns
  for (const Level level : all_levels) {
    radius_[level].resize(n, INFINITY);
    if (level <= options.level) good_[level].resize(n);
  }
  checks_->begin = InstantCopy(n);
  if (options.check == CheckMode::proof)
    checks_->follower.emplace(
        nullptr, checks_->motions.model(), checks_->levels,
        std::min(options.max_sub_steps, std::numeric_limits<int>::max() - 1) + 1);
  restart();
}

LiveRun::~LiveRun() = default;

RowFault LiveRun::fault_of(const LiveRow& row) const {
  if (!std::isfinite(row.time)) return RowFault::not_finite;
  const PerLevel<std::span<const double>> values{row.z, row.zd, row.zdd};
  for (const Level level : all_levels) {
    if (level > options_.level) break;
    if (values[level].size() != tried_.size()) return RowFault::wrong_size;
    if (!std::ranges::all_of(values[level], [](double x) { return std::isfinite(x); }))
      return RowFault::not_finite;
  }
  return has_position_ && row.time <= time_ ? RowFault::time_not_later : RowFault::none;
}

LiveSummary LiveRun::step(const LiveRow& row) {
  LiveSummary summary;
  summary.time = row.time;
  summary.fault = fault_of(row);
  if (summary.fault != RowFault::none) {
    summary.status =
        summary.fault == RowFault::not_finite ? Status::not_finite : Status::not_converged;
    return summary;
  }
  std::ranges::copy(row.z, tried_.begin());
  static_cast<BasicSummary&>(summary) =
      stepping_of(formulation_).step_to_row(row, options_.level, options_.max_sub_steps);
  const bool is_solved = summary.status == Status::solved;
  if (options_.check == CheckMode::proof)
    check(row, summary);
  else if (is_solved)
    keep(row.time, solved());
  if (is_solved && summary.status != Status::solved) go_back();
  return summary;
}

/// Returns the row that the formulation has solved, at time 0 as RowMotions counts.
Instant LiveRun::solved() const {
  return instant_of(0, {formulation_.q(), formulation_.qd(), formulation_.qdd()}, options_.level);
}

/// Checks a row, solved or not by the formulation. Makes it the last good row unless it fails.
void LiveRun::check(const LiveRow& row, LiveSummary& summary) {
  Checks& c = *checks_;
  c.begin.time = c.motions.lead_to(row);
  c.follower->left_out.take_between();  // of a way that led to no row
  const RefinedInstant* found = c.motions.has_begun() ? follow(row, summary) : start(row, summary);
  if (!found) return;
  summary.condition = found->last.condition;
  if (!options_.scales && found->proven) c.scales->take(found->instant);
  keep(row.time, found->instant);
  for (const Level level : all_levels)
    std::ranges::copy(found->radius[level], radius_[level].begin());
  if (found->proven) {
    c.motions.begin_at(row);
    c.begin.assign(certified(*found));
    const RelativeRadius radius = relative_radius(formulation_.model(), found->radius, scales());
    summary.radius = radius.largest;
    if (radius.proves_no_digit())
      summary.flag = {.kind = RowFlag::Kind::unproven,
                      .group = radius.group,
                      .failure = ProofFailure::singular};
    else if (c.lost)
      summary.flag = c.lost;
    c.follower->flag_misfit(*found, summary.flag, &row);
  } else {
    summary.radius = {INFINITY, INFINITY, INFINITY};
    summary.flag = {.kind = RowFlag::Kind::unproven,
                    .group = found->last.group,
                    .failure = found->last.failure};
  }
  if (summary.flag) summary.flag->time = row.time;
}

/// Finds the instant of a row while no row is proven. Without a good row, tries the way from the
/// drawing, and notes that the branch is lost if it leads to no proven instant. Then, and after
/// good rows without a proof, takes what the formulation has found. Returns null if that is
/// nothing.
const RefinedInstant* LiveRun::start(const LiveRow& row, LiveSummary& summary) {
  Checks& c = *checks_;
  const bool is_solved = summary.status == Status::solved;
  if (!has_position_) {
    c.lost.reset();
    const FoundStart way = find_start(c.motions.model(), 0);
    if (way.stage == FoundStart::Stage::reached) {
      const std::vector<double> zeros(way.q.size());
      const RefinedInstant& found =
          c.follower->refinement.refine(instant_of(0, {way.q, zeros, zeros}, options_.level));
      if (!way.passed.empty()) summary.flag = start_flag(RowFlag::Kind::crossing, way, row.time);
      if (found.proven) return return_to(row.time, found, summary);
      summary.flag.reset();
    }
    c.lost = start_flag(RowFlag::Kind::branch, way, row.time);
  }
  return is_solved ? &c.follower->refinement.refine(solved()) : nullptr;
}

/// Follows the motion from the last proven row to this one. If the formulation is on another branch
/// or has found nothing, takes the end of the path. Returns null if the motion does not lead there.
const RefinedInstant* LiveRun::follow(const LiveRow& row, LiveSummary& summary) {
  Checks& c = *checks_;
  const bool is_solved = summary.status == Status::solved;
  const RefinedInstant* found = is_solved ? &c.follower->refinement.refine(solved()) : nullptr;
  BranchPath& path = c.follower->path;
  summary.path.time = c.begin.time;
  if (path.start_at(c.begin.view(c.levels)))
    summary.path =
        found && found->proven ? path.follow(certified(*found, c.levels)) : path.go_to(0);
  summary.path.time += row.time;
  if (summary.path.end == PathEnd::stuck) {
    if (summary.group < 0) summary.group = summary.path.group;
    if (is_solved) summary.status = Status::singular;
    summary.instants = 0;
    return nullptr;
  }
  if (summary.path.end == PathEnd::same && found && found->proven) return found;
  const Instant end = instant_of(0, path.present().values, options_.level);
  return return_to(row.time, c.follower->refinement.refine(end), summary);
}

/// Makes a refined instant the row's result, and lets the formulation go on from its positions.
const RefinedInstant* LiveRun::return_to(double time, const RefinedInstant& found,
                                         LiveSummary& summary) {
  stepping_of(formulation_).return_to(found.instant.q, time);
  summary.status = Status::solved;
  summary.group = summary.constraint = no_position;
  summary.instants = 1;
  return &found;
}

/// Makes an instant the last good row.
void LiveRun::keep(double time, const Instant& instant) {
  std::ranges::copy(instant.q, good_.position.begin());
  std::ranges::copy(instant.qd, good_.velocity.begin());
  std::ranges::copy(instant.qdd, good_.acceleration.begin());
  time_ = time;
  has_position_ = true;
}

void LiveRun::go_back() {
  const std::span<const double> none;
  stepping_of(formulation_).return_to(has_position_ ? good_.position : none, time_);
}

void LiveRun::set_time(double t) {
  if (!has_position_) return;
  checks_->motions.shift_time(t - time_);
  time_ = t;
  go_back();
}

Scales LiveRun::scales() const {
  return options_.scales ? *options_.scales : checks_->scales->current();
}

void LiveRun::restart() {
  has_position_ = false;
  time_ = 0;
  checks_->motions.forget();
  checks_->scales.emplace(checks_->motions.model(), TimeGrid{});
  go_back();
}

LiveRun::Obstacle LiveRun::explain() const {
  const Model& m = formulation_.model();
  std::vector<double> state = m.state_of(has_position_ ? good_.position : m.estimate);
  for (std::size_t d = 0; d < tried_.size(); ++d)
    state[m.entities[m.drivers[d].coordinate].first] = tried_[d];
  std::vector<GroupId> groups(m.groups.size());
  std::iota(groups.begin(), groups.end(), 0);
  const Culprit culprit = find_culprit(m, groups, state, formulation_.settings());
  const std::span<const double> followed_to =
      checks_->motions.has_begun() ? checks_->follower->path.present().values.position
                                   : std::span<const double>();
  return {culprit.group, culprit.constraint, find_assembly_error(m, state),
          find_table_lock(m, culprit.constraint, followed_to)};
}

}  // namespace desmo
