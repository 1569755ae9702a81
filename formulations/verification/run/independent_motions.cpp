#include "formulations/verification/run/independent_motions.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "formulations/model/scales.h"
#include "formulations/variants.h"
#include "formulations/verification/run/submodels.h"

namespace desmo {

namespace {

/// Copies the numbers of a mechanism's coordinates out of those of all.
void gather(const Submodel& s, std::span<const double> all, std::vector<double>& own) {
  own.clear();
  if (all.empty()) return;
  for (const int i : s.coordinates) own.push_back(all[i]);
}

/// Writes the numbers of a mechanism's coordinates into those of all.
void scatter(const Submodel& s, std::span<const double> own, std::span<double> all) {
  for (std::size_t k = 0; k < own.size(); ++k) all[s.coordinates[k]] = own[k];
}

/// Returns whether a flag calls for following the mechanisms one by one. Followed together, one
/// that is blocked leaves the others unproven, too. A misfit blocks none: the motion goes on by the
/// other equations.
bool concerns_one(const std::optional<RowFlag>& flag) {
  return flag && flag->kind != RowFlag::Kind::misfit;
}

}  // namespace

/// The motion of a mechanism that depends on no other one.
struct IndependentMotions::SubmodelMotion {
  explicit SubmodelMotion(Submodel s)
      : submodel(std::move(s)), motion(submodel.model, submodel.levels) {}

  const CheckedInstant* take(const Instant& at, bool is_solved) {
    const CertifiedInstant own = part_of({.values = {at.q, at.qd, at.qdd}});
    const Instant instant = with_values(at, own.values);
    last_passed = passed;
    const CheckedInstant* row = is_solved ? &motion.check(instant) : motion.solve(instant);
    if (row && row->flag && row->flag->is_of_change_point() && !passed) passed = row->flag;
    return row;
  }

  /// Returns to the state before the last take().
  void return_to_last() {
    motion.return_to_last();
    passed = last_passed;
  }

  /// Returns the flag of a row that was taken. If rows before it were left out, a change point that
  /// was passed there flags this row, unless its own flag is as bad.
  std::optional<RowFlag> flag_of(const CheckedInstant& row) const {
    if (!passed || (row.flag && row.flag->kind <= passed->kind)) return row.flag;
    RowFlag flag = *passed;
    flag.kind = RowFlag::Kind::crossing;
    flag.time = row.instant.time;
    if (row.flag) flag.misfit = row.flag->misfit;
    return flag;
  }

  /// Returns a copy of the mechanism's numbers, which is valid until the next call.
  CertifiedInstant part_of(const CertifiedInstant& whole) {
    handed_in.time = whole.time;
    for (const Level level : all_levels)
      gather(submodel, whole.values[level], handed_in.values[level]);
    gather(submodel, whole.radius, handed_in.radius);
    return handed_in.view();
  }

  /// Goes on to a row, or begins again there. Returns whether the motion leads there.
  bool try_again(const Instant& wanted) {
    if (!is_blocked && take(wanted, false)) return true;
    is_blocked = true;  // no path from the last row leads to later rows either
    if (!can_be_assembled(wanted.time)) return false;
    motion.begin(wanted.time);
    is_blocked = !take(wanted, false);
    return !is_blocked;
  }

  Submodel submodel;
  CheckedMotion motion;
  InstantCopy handed_in;
  /// First flag of a change point since the last delivered row; last_passed: before the last
  /// take().
  std::optional<RowFlag> passed, last_passed;
  /// No path leads on from the last row: try_again() begins at the drawing for each row, until
  /// begin_again().
  bool is_blocked = false;

 private:
  /// Returns whether a formulation assembles the mechanism at a time [s]. To begin the motion
  /// there, only to find its way from the drawing blocked, costs a hundred times as much.
  bool can_be_assembled(double time) {
    if (!formulation)
      formulation = make_formulation(find_variant("group_automatic_lapack"), submodel.model);
    return formulation->assemble(time, Level::position).ok();
  }

  std::unique_ptr<Formulation> formulation;
};

IndependentMotions::IndependentMotions(const Model& m, std::span<const Level> levels,
                                       double tolerance)
    : m_(m), levels_(levels), tolerances_(nominal_magnitudes(m)), together_(m, levels) {
  for (double& t : tolerances_) t *= tolerance;
}

IndependentMotions::~IndependentMotions() = default;

void IndependentMotions::begin(double time) {
  together_.begin(time);
  state_ = {};
  begin_ = time;
}

bool IndependentMotions::try_again(const Instant& wanted) {
  if (state_.together && !separate()) return false;
  last_ = state_;
  bool all = true;
  for (const auto& each : *each_) all &= each->try_again(wanted);
  return all;
}

void IndependentMotions::begin_again(double time) {
  if (state_.together) return begin(time);
  for (const auto& each : *each_) each->is_blocked = false;
  return_to_last();
}

bool IndependentMotions::is_on_step(const Instant& instant) const {
  return state_.together && together_.is_on_step(instant, tolerances_);
}

void IndependentMotions::return_to_last() {
  state_ = last_;
  if (state_.together)
    together_.return_to_last();
  else
    for (const auto& each : *each_) each->return_to_last();
}

std::vector<double> IndependentMotions::followed_to() const {
  if (state_.together) return together_.followed_to();
  std::vector<double> all(m_.coordinates());
  for (const auto& each : *each_) {
    const std::vector<double> q = each->motion.followed_to();
    if (q.empty()) return {};
    scatter(each->submodel, q, all);
  }
  return all;
}

FoundStart::Stage IndependentMotions::start() const {
  if (state_.together) return together_.start();
  FoundStart::Stage stage = FoundStart::Stage::reached;
  for (const auto& each : *each_) stage = std::max(stage, each->motion.start());
  return stage;
}

const CheckedInstant* IndependentMotions::take(const Instant& at, bool is_solved) {
  last_ = state_;
  if (state_.together) {
    const CheckedInstant* row = is_solved ? &together_.check(at) : together_.solve(at);
    if ((row && !concerns_one(row->flag)) || !separate()) {
      state_.has_begun = true;
      return row;
    }
  }
  if (!take_each(at, is_solved)) return nullptr;
  state_.has_begun = true;
  if (!concerns_one(result_.flag)) join();
  return &result_;
}

/// Goes back to the last row, and follows each mechanism by itself from there. Returns false, and
/// does nothing, if there is only one.
bool IndependentMotions::separate() {
  if (!each_) {
    each_.emplace();
    for (Submodel& s : independent_submodels(m_, levels_))
      each_->push_back(std::make_unique<SubmodelMotion>(std::move(s)));
  }
  if (each_->empty()) return false;
  together_.return_to_last();
  state_.together = false;
  for (const auto& each : *each_)
    if (state_.has_begun)
      each->motion.continue_from(each->part_of(together_.present()));
    else
      each->motion.begin(begin_);
  return true;
}

/// Follows all mechanisms together again, from the present row, in which each is proven.
void IndependentMotions::join() {
  state_.together =
      together_.continue_from({result_.instant.time,
                               {result_.instant.q, result_.instant.qd, result_.instant.qdd},
                               radius_.position,
                               levels_});
}

/// Makes the result from the rows of all mechanisms. Returns false if one of them has no row.
bool IndependentMotions::take_each(const Instant& at, bool is_solved) {
  flags_.clear();
  for (const Level level : all_levels) {
    values_[level].resize(m_.coordinates());
    radius_[level].assign(m_.coordinates(), INFINITY);
  }
  const auto& [q, qd, qdd] = values_;
  result_ = {.instant = with_values(at, {q, qd, qdd}),
             .radius = {radius_.position, radius_.velocity, radius_.acceleration}};
  for (const auto& each : *each_) {
    const CheckedInstant* row = each->take(at, is_solved);
    if (!row) return false;
    add(each->submodel, *row, each->flag_of(*row));
  }
  for (const auto& each : *each_) each->passed.reset();
  if (flags_.empty()) return true;
  std::ranges::stable_sort(flags_, {}, &RowFlag::kind);
  result_.flag = flags_.front();
  result_.other_flags = std::span(flags_).subspan(1);
  return true;
}

void IndependentMotions::add(const Submodel& s, const CheckedInstant& row,
                             const std::optional<RowFlag>& own_flag) {
  scatter(s, row.instant.q, values_.position);
  scatter(s, row.instant.qd, values_.velocity);
  scatter(s, row.instant.qdd, values_.acceleration);
  for (const Level level : all_levels) scatter(s, row.radius[level], radius_[level]);
  result_.condition = std::max(result_.condition, row.condition);
  result_.is_elsewhere |= row.is_elsewhere;
  result_.is_on_point |= row.is_on_point;
  if (!own_flag) return;
  RowFlag& flag = flags_.emplace_back(*own_flag);
  if (flag.group != no_position) flag.group = s.groups[flag.group];
  if (flag.misfit) flag.misfit->constraint = s.members.constraints[flag.misfit->constraint];
}

}  // namespace desmo
