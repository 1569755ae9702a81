#include "bench/cli/solve/proof.h"

#include <algorithm>
#include <cmath>

#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"

namespace desmo::cli {

Proof::Proof(const Model& m, const TimeGrid& grid, std::span<const Level> levels)
    : m_(m), certifier_(m, levels), scales_(m, grid) {}

void Proof::add(const Instant& instant) {
  scales_.take(instant);
  const Certificate c = certifier_.certify(instant);
  ++instants_;
  if (!c.proven) {
    if (group_ < 0) first_ = instant.time, group_ = c.group;
    return;
  }
  ++proven_;
  for (const Level level : all_levels)
    for (const Entity& e : m_.entities) {
      if (e.fixed) continue;
      double squares = 0;
      for (const double r : c.radius[level].subspan(e.first, e.size)) squares += r * r;
      double& largest = (is_length(e.kind) ? length_ : rotation_)[level];
      if (std::isfinite(squares)) largest = std::max(largest, std::sqrt(squares));
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
