#include "report/check/time_findings.h"

#include <functional>
#include <map>

#include "report/statistics/statistics.h"

namespace desmo::report {
namespace {

using Pass = std::map<std::string, Rounds>;  // by cell, with the control
using FindChange = std::function<Change(const Pass& pass, const std::string& cell)>;

Pass first_pass(const CheckRecord& check) {
  Pass pass;
  for (const auto& [key, head] : check.head.cells) {
    if (head.status != Status::ok) continue;
    if (!check.base) {
      pass[name_of(key)] = {{}, head.time.seconds};
    } else if (const Cell& base = check.base->cells.at(key); base.status == Status::ok) {
      pass[name_of(key)] = {base.time.seconds, head.time.seconds};
    }
  }
  if (!pass.empty()) pass[control_name] = check.control;
  return pass;
}

double middle(const std::vector<double>& samples) {
  return samples.empty() ? 0 : summarise(samples).median;
}

using FindReference = std::function<std::string(const std::string& cell)>;

std::vector<TimeFinding> judge_cells(const Pass& first, const Pass& second,
                                     const FindReference& reference, const FindChange& change) {
  std::vector<TimeFinding> findings;
  for (const auto& [cell, rounds] : first) {
    if (cell == control_name) continue;
    TimeFinding finding{
        cell, reference(cell), middle(rounds.base), middle(rounds.head), change(first, cell), {},
        {}};
    if (second.contains(cell) && (finding.reference.empty() || second.contains(finding.reference)))
      finding.second = change(second, cell);
    finding.outcome = judge_time(finding.first, finding.second);
    findings.push_back(std::move(finding));
  }
  return findings;
}

/// "<case>/.../global_automatic_klu" of the same case; of that one, the control.
std::string reference_of(const std::string& cell, const Pass& pass) {
  const std::string case_name = cell.substr(0, cell.find('/') + 1);
  for (const auto& [other, ignored] : pass)
    if (other != cell && other.starts_with(case_name) && other.ends_with("/global_automatic_klu"))
      return other;
  return control_name;
}

}  // namespace

TimeFindings find_times(const CheckRecord& check) {
  const Pass first = first_pass(check);
  if (first.empty()) return {};
  const FindChange paired = [](const Pass& pass, const std::string& cell) {
    return median_change(log_ratios(pass.at(cell).head, pass.at(cell).base));
  };
  const FindReference none = [](const std::string&) { return std::string(); };
  TimeFindings findings{paired(first, control_name),
                        judge_cells(first, check.second, none, paired)};
  const bool first_unsteady = is_unsteady(*findings.control);
  const bool second_unsteady =
      !check.second.empty() && is_unsteady(paired(check.second, control_name));
  for (TimeFinding& finding : findings.cells)
    if (first_unsteady || (second_unsteady && finding.second)) finding.outcome = Outcome::noisy;
  return findings;
}

TimeFindings find_times(const CheckRecord& check, const CheckRecord& baseline) {
  const Pass then = first_pass(baseline);
  Pass now = first_pass(check);
  std::erase_if(now, [&](const auto& entry) { return !then.contains(entry.first); });
  const FindReference reference = [&](const std::string& cell) { return reference_of(cell, now); };
  const FindChange unpaired = [&](const Pass& pass, const std::string& cell) {
    const auto ratios = [&](const Pass& run) {
      return log_ratios(run.at(cell).head, run.at(reference(cell)).head);
    };
    return median_change(ratios(pass), ratios(then));
  };
  return {std::nullopt, judge_cells(now, check.second, reference, unpaired)};
}

}  // namespace desmo::report
