#include "bench/cli/solve/proof.h"

#include <algorithm>
#include <cmath>

#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"

namespace desmo::cli {

namespace {

/// A radius of this part of a scale proves no digit.
constexpr double no_digit = 0.5;

}  // namespace

Proof::Proof(const Model& m, const TimeGrid& grid, std::span<const Level> levels)
    : m_(m), certifier_(m, levels), scales_(m, grid) {}

void Proof::add(const Instant& instant) {
  scales_.take(instant);
  const Certificate c = certifier_.certify(instant);
  ++instants_;
  PerLevel<double> length{}, rotation{};
  GroupId group = c.group;
  bool proven = c.proven;
  for (const Level level : all_levels)
    for (const Entity& e : m_.entities) {
      if (e.fixed || !c.proven) continue;
      double squares = 0;
      for (const double r : c.radius[level].subspan(e.first, e.size)) squares += r * r;
      if (!std::isfinite(squares)) continue;  // of a level that is not solved
      const double radius = std::sqrt(squares);
      double& largest = (is_length(e.kind) ? length : rotation)[level];
      largest = std::max(largest, radius);
      if (radius <= no_digit * scales_.current().of(e.kind, level)) continue;
      if (proven) group = e.group;
      proven = false;
    }
  if (!proven) {
    if (group_ < 0) first_ = instant.time, group_ = group;
    return;
  }
  ++proven_;
  for (const Level level : all_levels) {
    length_[level] = std::max(length_[level], length[level]);
    rotation_[level] = std::max(rotation_[level], rotation[level]);
  }
}

std::string Proof::note(Level level) const {
  std::string note = formatted("proof: %ld of %ld instants", proven_, instants_);
  const char* names[] = {"; errors at most %.1e", ", %.1e in velocity", ", %.1e in acceleration"};
  for (const Level l : all_levels) {
    if (proven_ == 0 || l > level) break;
    const double bound = std::max(relative(length_[l], scales_.current().length[l]),
                                  relative(rotation_[l], scales_.current().rotation[l]));
    note += formatted(names[static_cast<int>(l)], bound);
  }
  note += '\n';
  if (!is_complete())
    note += "proof: none for " + count(instants_ - proven_, "instant") + ", the first at " +
            reason() + '\n';
  return note;
}

std::string Proof::reason() const {
  return "group '" + m_.groups[group_].name + "' (" + enumerate(m_.groups[group_].bodies, 8) +
         formatted("), t = %.9g s", first_) +
         ": the position is too near a singular one, or too far off, to prove that a solution is "
         "near";
}

}  // namespace desmo::cli
