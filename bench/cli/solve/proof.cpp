#include "bench/cli/solve/proof.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"

namespace desmo::cli {

namespace {

/// A radius of this part of a scale proves no digit.
constexpr double no_digit = 0.5;

/// Covers the few roundings of a norm, and of a ratio.
constexpr double above = 1 + 0x1p-48;

/// Returns a bound with two digits, not below it.
std::string rounded_up(double bound) {
  for (double shown = bound;; shown *= 1.01) {
    std::string text = formatted("%.1e", shown);
    if (!(std::strtod(text.c_str(), nullptr) < bound)) return text;
  }
}

const char* reason_text(ProofFailure failure) {
  switch (failure) {
    case ProofFailure::drivers:
      return "rounding of the drivers' values, so large, leaves too few digits to prove that a "
             "solution is near";
    case ProofFailure::time:
      return "the drivers' motions have too few digits at this time to prove that a solution is "
             "near";
    case ProofFailure::origin:
      return "rounding of the coordinates, so far from the origin, leaves too few digits to prove "
             "that a solution is near";
    case ProofFailure::sizes:
      return "rounding, with lengths of so different sizes, leaves too few digits to prove that a "
             "solution is near";
    case ProofFailure::budget:
      return "the position is too far off to prove that a solution is near";
    case ProofFailure::singular:
    case ProofFailure::none:
      break;
  }
  return "the position is too near a singular one to prove that a solution is near";
}

}  // namespace

Proof::Proof(const Model& m, const TimeGrid& grid, std::span<const Level> levels)
    : m_(m), levels_(levels), refinement_(m, levels), path_(m), scales_(m, grid) {}

/// Follows the motion from the last instant to this one.
void Proof::follow(const RefinedInstant& r) {
  const CertifiedInstant to{
      r.instant.time, {r.instant.q, r.instant.qd, r.instant.qdd}, r.radius.position, levels_};
  const bool first = instants_++ == 0;
  FollowedStep step;
  if (on_path_ && r.proven) step = path_.follow(to);
  steps_ += !first;
  if (step.end == PathEnd::same) {
    ++followed_;
    return;
  }
  if (!first && !broken_) broken_ = step, broken_at_ = r.instant.time;
  on_path_ = r.proven && path_.start_at(to);  // what is beyond a break is a motion of its own
}

Instant Proof::refine(const Instant& instant) {
  scales_.take(instant);
  const RefinedInstant& r = refinement_.refine(instant);
  follow(r);
  PerLevel<double> length{}, rotation{};
  GroupId group = r.last.group;
  ProofFailure failure = r.last.failure;
  bool proven = r.proven;
  for (const Level level : all_levels)
    for (const Entity& e : m_.entities) {
      if (e.fixed || !r.proven) continue;
      double squares = 0;
      for (const double x : r.radius[level].subspan(e.first, e.size)) squares += x * x;
      if (!std::isfinite(squares)) continue;  // of a level that is not solved
      const double radius = std::sqrt(squares) * above;
      double& largest = (is_length(e.kind) ? length : rotation)[level];
      largest = std::max(largest, radius);
      if (radius <= no_digit * scales_.current().of(e.kind, level)) continue;
      if (proven) group = e.group, failure = ProofFailure::singular;
      proven = false;
    }
  if (!proven) {
    if (group_ < 0) first_ = instant.time, group_ = group, failure_ = failure;
    return instant;
  }
  ++proven_;
  for (const Level level : all_levels) {
    length_[level] = std::max(length_[level], length[level]);
    rotation_[level] = std::max(rotation_[level], rotation[level]);
  }
  return r.instant;
}

std::string Proof::note(Level level) const {
  std::string note = formatted("proof: %ld of %ld instants", proven_, instants_);
  const char* before[] = {"; errors at most ", ", ", ", "};
  const char* after[] = {"", " in velocity", " in acceleration"};
  for (const Level l : all_levels) {
    if (proven_ == 0 || l > level) break;
    const double bound = std::max(relative(length_[l], scales_.current().length[l]),
                                  relative(rotation_[l], scales_.current().rotation[l]));
    const int k = static_cast<int>(l);
    note += before[k] + rounded_up(bound * above) + after[k];
  }
  note += '\n';
  if (proven_ < instants_)
    note += "proof: none for " + count(instants_ - proven_, "instant") + ", the first at " +
            reason_of_instant() + '\n';
  if (steps_ == 0) return note;
  note += formatted("path: %ld of %ld steps stay on one branch\n", followed_, steps_);
  if (followed_ < steps_) note += "path: none for " + reason_of_step() + '\n';
  return note;
}

std::string Proof::reason() const {
  return proven_ < instants_ ? reason_of_instant() : reason_of_step();
}

std::string Proof::reason_of_instant() const {
  return "group '" + m_.groups[group_].name + "' (" + enumerate(m_.groups[group_].bodies, 8) +
         formatted("), t = %.9g s: ", first_) + reason_text(failure_);
}

std::string Proof::reason_of_step() const {
  const std::string step = formatted("the step to t = %.9g s: ", broken_at_);
  if (broken_->end == PathEnd::other) return step + "it ends on another branch";
  if (broken_->group < 0) return step + "one of its ends is not proven";
  return step + formatted("beyond t = %.9g s, ", broken_->time) + "group '" +
         m_.groups[broken_->group].name + "' (" + enumerate(m_.groups[broken_->group].bodies, 8) +
         ") is too near a singular position to be followed";
}

}  // namespace desmo::cli
