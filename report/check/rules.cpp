#include "report/check/rules.h"

namespace desmo::report {
namespace {

// 1 slower, -1 faster, 0 neither.
int direction(const Change& c) {
  if (c.ratio > alarming_change && c.low > certain_change) return 1;
  if (c.ratio < 1 / alarming_change && c.high < 1 / certain_change) return -1;
  return 0;
}

bool beyond(double ratio, double limit) { return ratio > limit || ratio < 1 / limit; }

bool is_wide(const Change& c) { return c.high / c.low > max_interval; }

// Not alarming, but not to be trusted either.
bool is_undecided(const Change& c) { return is_wide(c) || beyond(c.ratio, alarming_change); }

}  // namespace

Outcome outcome_of_time(const Change& first, const std::optional<Change>& second) {
  const int seen = direction(first);
  if (seen == 0) return is_undecided(first) ? Outcome::noisy : Outcome::same;
  if (!second) return Outcome::unconfirmed;
  if (direction(*second) == seen) return seen > 0 ? Outcome::regression : Outcome::improvement;
  return is_undecided(*second) ? Outcome::noisy : Outcome::refuted;
}

bool is_unsteady(const Change& control) {
  return is_wide(control) || beyond(control.ratio, steady_control);
}

Outcome outcome_of_work(double percent) {
  if (percent >= alarming_percent) return Outcome::regression;
  if (percent <= -alarming_percent) return Outcome::improvement;
  return Outcome::same;
}

}  // namespace desmo::report
