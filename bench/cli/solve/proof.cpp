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
    : m_(m), refinement_(m, levels), scales_(m, grid) {}

Instant Proof::refine(const Instant& instant) {
  scales_.take(instant);
  const RefinedInstant& r = refinement_.refine(instant);
  ++instants_;
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
  if (!is_complete())
    note += "proof: none for " + count(instants_ - proven_, "instant") + ", the first at " +
            reason() + '\n';
  return note;
}

std::string Proof::reason() const {
  return "group '" + m_.groups[group_].name + "' (" + enumerate(m_.groups[group_].bodies, 8) +
         formatted("), t = %.9g s: ", first_) + reason_text(failure_);
}

}  // namespace desmo::cli
