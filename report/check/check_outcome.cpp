#include "report/check/check_outcome.h"

#include <algorithm>

namespace desmo::report {
namespace {

/// Candidates whose answers are wrong, those that `then` does not have in order, and those that it
/// alone has.
void exclude(CheckOutcome& j, const CheckRecord& check, const Record& then) {
  for (const auto& [key, head] : check.head.candidates) {
    const std::string name = name_of(key);
    const auto before = then.candidates.find(key);
    if (head.status == Status::failed)
      j.invalid.push_back({name, head.message});
    else if (before == then.candidates.end())
      j.excluded.push_back({name, "new"});
    else if (before->second.status == Status::failed)
      j.excluded.push_back({name, "was wrong before: " + before->second.message});
    else if (!before->second.verification)
      j.excluded.push_back({name, "new: " + before->second.message});
  }
  for (const auto& [key, candidate] : then.candidates)
    if (!check.head.candidates.contains(key)) j.missing.push_back(name_of(key));
}

template <class Findings>
bool any(const Findings& findings, Finding outcome) {
  return std::ranges::any_of(findings, [&](const auto& f) { return f.outcome == outcome; });
}

/// The verdict, and nothing of what is wrong but that it is.
CheckVerdict overall(CheckOutcome& j) {
  for (const Excluded& wrong : j.invalid)
    std::erase_if(j.work.candidates,
                  [&](const WorkFinding& f) { return f.candidate == wrong.candidate; });

  const auto& times = j.time.candidates;
  const auto& works = j.work.candidates;
  if (!j.invalid.empty() || !j.missing.empty()) return CheckVerdict::invalid;
  if (any(times, Finding::regression) || any(works, Finding::regression))
    return CheckVerdict::regression;
  if (!j.differences.empty() || !j.work.differences.empty()) return CheckVerdict::incomparable;
  if (times.empty() && works.empty()) return CheckVerdict::incomparable;
  if (any(times, Finding::unconfirmed) || any(times, Finding::noisy))
    return CheckVerdict::inconclusive;
  return CheckVerdict::pass;
}

bool has_times(const Record& record) {
  return std::ranges::any_of(record.candidates, [](const auto& candidate) {
    return candidate.second.status == Status::ok;
  });
}

}  // namespace

CheckOutcome compare_sides(const CheckRecord& check, const CheckRecord* baseline) {
  CheckOutcome j;
  const Record& then = baseline ? baseline->head : check.base ? *check.base : check.head;
  exclude(j, check, then);
  if (&then != &check.head && has_times(check.head)) {
    j.differences = why_incomparable(then, check.head);
    if (j.differences.empty()) j.time = baseline ? find_times(check, *baseline) : find_times(check);
  }
  j.work = find_works(check, baseline);
  j.verdict = overall(j);
  return j;
}

std::vector<Pending> pending(const CheckOutcome& found) {
  std::vector<Pending> all;
  const auto& control = found.time.control;
  const bool first_unsteady = control && is_unsteady(*control);
  for (const TimeFinding& f : found.time.candidates) {
    if (f.outcome != Finding::unconfirmed && f.outcome != Finding::noisy) continue;
    const bool first = f.outcome == Finding::noisy && (first_unsteady || !f.second);
    all.push_back({first ? "first" : "second", f.candidate});
    // A ratio needs both its times in the same rounds; the control is in all of them.
    if (!f.reference.empty() && f.reference != control_name)
      all.push_back({all.back().pass, f.reference});
  }
  return all;
}

}  // namespace desmo::report
