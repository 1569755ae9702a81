#include "report/check/check_outcome.h"

#include <algorithm>
#include <array>

#include "report/tables/entries.h"

namespace desmo::report {
namespace {

/// Fills the lists of candidates that are not compared. then: record that head is compared with.
/// - `invalid`: wrong in head
/// - `excluded`: new in head, or wrong or unverified in `then`
/// - `missing`: in `then` only
void exclude(CheckOutcome& outcome, const CheckRecord& check, const Record& then) {
  for (const auto& [key, head] : check.head.candidates) {
    const std::string name = name_of(key);
    const auto before = then.candidates.find(key);
    if (head.status == Status::failed)
      outcome.invalid.push_back({name, head.message});
    else if (before == then.candidates.end())
      outcome.excluded.push_back({name, "new"});
    else if (before->second.status == Status::failed)
      outcome.excluded.push_back({name, "was wrong before: " + before->second.message});
    else if (!before->second.verification)
      outcome.excluded.push_back({name, "new: " + before->second.message});
  }
  for (const auto& [key, candidate] : then.candidates)
    if (!check.head.candidates.contains(key)) outcome.missing.push_back(name_of(key));
}

template <class Findings>
bool any(const Findings& findings, Finding outcome) {
  return std::ranges::any_of(findings, [&](const auto& f) { return f.outcome == outcome; });
}

/// Removes the work of candidates whose answers are wrong: the verdict says nothing else of them
/// than that.
void remove_invalid_work(CheckOutcome& outcome) {
  for (const Excluded& wrong : outcome.invalid)
    std::erase_if(outcome.work.candidates,
                  [&](const WorkFinding& f) { return f.candidate == wrong.candidate; });
}

/// Returns the verdict on all findings.
CheckVerdict verdict_of(const CheckOutcome& outcome) {
  const auto& times = outcome.time.candidates;
  const auto& works = outcome.work.candidates;
  if (!outcome.invalid.empty() || !outcome.missing.empty()) return CheckVerdict::invalid;
  if (any(times, Finding::regression) || any(works, Finding::regression))
    return CheckVerdict::regression;
  if (!outcome.differences.empty() || !outcome.work.differences.empty())
    return CheckVerdict::incomparable;
  if (times.empty() && works.empty()) return CheckVerdict::incomparable;
  if (any(times, Finding::unconfirmed) || any(times, Finding::noisy))
    return CheckVerdict::inconclusive;
  return CheckVerdict::pass;
}

}  // namespace

CheckOutcome compare_sides(const CheckRecord& check, const CheckRecord* baseline) {
  CheckOutcome outcome;
  const Record& then = baseline ? baseline->head : check.base ? *check.base : check.head;
  exclude(outcome, check, then);
  if (!baseline && check.base && has_times(check.head)) {
    outcome.differences = incomparable_reasons(then, check.head);
    if (outcome.differences.empty()) outcome.time = find_times(check);
  }
  outcome.work = find_works(check, baseline);
  remove_invalid_work(outcome);
  outcome.verdict = verdict_of(outcome);
  return outcome;
}

std::vector<std::string> pending(const CheckOutcome& found) {
  std::vector<std::string> all;
  const auto& control = found.time.control;
  const bool first_unsteady = control && is_unsteady(*control);
  for (const TimeFinding& f : found.time.candidates) {
    if (f.outcome != Finding::unconfirmed && f.outcome != Finding::noisy) continue;
    const bool first = f.outcome == Finding::noisy && (first_unsteady || !f.second);
    all.push_back((first ? "first " : "second ") + f.candidate);
  }
  return all;
}

namespace {

std::string percent_of(double ratio) { return write_change(100 * (ratio - 1)); }

Entry change_entry(const std::optional<Change>& c) {
  if (!c) return {missing_mark, {"", "", ""}, missing_mark};
  return composed("{} % [{}, {}]", {percent_of(c->ratio), percent_of(c->low), percent_of(c->high)});
}

std::string outcome_word(Finding outcome) {
  constexpr std::array names{"outcomes.same",        "outcomes.gain",    "outcomes.regression",
                             "outcomes.unconfirmed", "outcomes.refuted", "outcomes.noisy"};
  return sentence(names[static_cast<std::size_t>(outcome)]);
}

Entry milliseconds(double seconds) { return number_entry(1e3 * seconds, 4); }

Table time_table(const TimeFindings& time) {
  std::size_t rounds = 0;
  for (const TimeFinding& f : time.candidates) rounds = std::max(rounds, f.first.rounds);
  Table table = headed_table("time", {{"rounds", rounds}});
  table.notes.push_back(sentence("time.control", {{"change", change_entry(time.control).shown}}));
  for (const TimeFinding& f : time.candidates)
    table.rows.push_back({f.candidate, milliseconds(f.base_seconds), milliseconds(f.head_seconds),
                          change_entry(f.first), change_entry(f.second), outcome_word(f.outcome)});
  return table;
}

Table work_table(const WorkFindings& work, const Work& counted) {
  Table table = headed_table(
      "work",
      {{"steps", counted.steps}, {"iterations", counted.iterations}, {"tool", counted.tool}});
  for (const WorkFinding& f : work.candidates)
    table.rows.push_back({f.candidate, f.base, f.head, composed("{} %", {write_change(f.percent)}),
                          outcome_word(f.outcome)});
  return table;
}

std::vector<std::string> summary(const CheckOutcome& outcome) {
  std::vector<std::string> lines;
  const auto say = [&](const char* name, const TextValues& values = {}) {
    lines.push_back(sentence(std::string("verdict.") + name, values));
  };
  const auto say_candidates = [&](const char* name, const auto& findings, Finding outcome) {
    std::string list;
    for (const auto& f : findings)
      if (f.outcome == outcome) list += (list.empty() ? "" : ", ") + f.candidate;
    if (!list.empty()) say(name, {{"candidates", list}});
  };
  const auto say_differences = [&](const char* name, const std::vector<Difference>& differences) {
    for (const Difference& d : differences)
      say(name, {{"what", d.what}, {"first", d.first}, {"second", d.second}});
  };
  const auto& times = outcome.time.candidates;
  const auto& works = outcome.work.candidates;
  for (const Excluded& e : outcome.invalid)
    say("wrong", {{"candidate", e.candidate}, {"reason", e.reason}});
  for (const std::string& name : outcome.missing) say("missing", {{"candidate", name}});
  say_candidates("slower", times, Finding::regression);
  say_candidates("more_work", works, Finding::regression);
  say_candidates("faster", times, Finding::improvement);
  say_candidates("less_work", works, Finding::improvement);
  say_candidates("unconfirmed", times, Finding::unconfirmed);
  say_candidates("noisy", times, Finding::noisy);
  say_differences("times_differ", outcome.differences);
  say_differences("counts_differ", outcome.work.differences);
  if (outcome.verdict == CheckVerdict::incomparable && outcome.differences.empty() &&
      outcome.work.differences.empty())
    say("nothing");
  for (const Excluded& e : outcome.excluded)
    say("not_compared", {{"candidate", e.candidate}, {"reason", e.reason}});
  if (lines.empty()) say("unchanged");
  return lines;
}

/// Returns the beginning of the commit, with a word where the tree had uncommitted changes.
std::string short_commit(const Record& record) {
  return record.commit.substr(0, 12) + (record.dirty ? " " + sentence("common.uncommitted") : "");
}

std::string provenance_line(const CheckRecord& check) {
  const Record& head = check.head;
  std::string text =
      check.base ? sentence("verdict.base", {{"commit", short_commit(*check.base)}}) + " " : "";
  text += sentence("verdict.measured", {{"commit", short_commit(head)},
                                        {"date", head.date},
                                        {"cpu", head.machine.cpu},
                                        {"cores", head.machine.cores},
                                        {"compiler", head.build.compiler},
                                        {"blas", head.blas.core}});
  if (!check.slowed.empty()) text += " " + sentence("verdict.slowed", {{"slowed", check.slowed}});
  return text;
}

}  // namespace

Document verdict_document(const CheckRecord& check, const CheckOutcome& outcome) {
  constexpr std::array names{"PASS", "REGRESSION", "INVALID", "INCONCLUSIVE", "INCOMPARABLE"};
  Section section =
      headed_section("verdict", {{"verdict", names[static_cast<std::size_t>(outcome.verdict)]}});
  section.paragraphs = summary(outcome);
  if (!outcome.time.candidates.empty()) section.tables.push_back(time_table(outcome.time));
  if (!outcome.work.candidates.empty())
    section.tables.push_back(work_table(outcome.work, *check.work));
  section.paragraphs.push_back(provenance_line(check));
  if (std::string note = note_on_version(check.head.version); !note.empty())
    section.paragraphs.push_back(std::move(note));
  return {sentence("verdict.document"), {std::move(section)}};
}

}  // namespace desmo::report
