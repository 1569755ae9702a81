#include "report/check/verdict.h"

#include "report/text/digits.h"

namespace desmo::report {
namespace {

/// To the tenth; rounded to nothing, it has no sign.
std::string signed_percent(double percent) {
  const std::string digits = write_fixed(percent, 1);
  return (percent > 0 && digits != "0.0" ? "+" : "") + digits;
}

std::string percent_of(double ratio) { return signed_percent(100 * (ratio - 1)); }

Entry change_entry(const std::optional<Change>& c) {
  if (!c) return {missing_mark, {"", "", ""}, missing_mark};
  const std::string middle = percent_of(c->ratio), low = percent_of(c->low),
                    high = percent_of(c->high);
  return {middle + " % [" + low + ", " + high + "]", {middle, low, high}, {}};
}

std::string outcome_word(Outcome outcome) {
  switch (outcome) {
    case Outcome::same:
      return "same";
    case Outcome::gain:
      return "gain";
    case Outcome::regression:
      return "REGRESSION";
    case Outcome::unconfirmed:
      return "alarm, not yet confirmed";
    case Outcome::refuted:
      return "same: the second pass refutes the first";
    case Outcome::noisy:
      return "too noisy";
  }
  return {};
}

Entry milliseconds(double seconds) {
  if (seconds <= 0) return note_entry(missing_mark);
  const std::string text = write_significant(1e3 * seconds, 4);
  return {text, {text}, {}};
}

Table time_table(const TimeFindings& time) {
  const bool against_baseline = !time.control;
  Table table{.name = "time",
              .title = "Time: the median over rounds of head's least time over base's",
              .notes = {},
              .columns = {{"cell", {}},
                          {"base, ms", {"base_ms"}},
                          {"head, ms", {"head_ms"}},
                          {"change", {"percent", "low", "high"}},
                          {"second pass", {"percent", "low", "high"}},
                          {"outcome", {}}},
              .rows = {}};
  if (against_baseline)
    table.title = "Time: each over that of its case's global_automatic_klu, beside the baseline's";
  std::size_t rounds = 0;
  for (const TimeFinding& f : time.candidates) {
    rounds = std::max(rounds, f.first.rounds);
    table.rows.push_back({text_entry(f.candidate), milliseconds(f.base_seconds),
                          milliseconds(f.head_seconds), change_entry(f.first),
                          change_entry(f.second), text_entry(outcome_word(f.outcome))});
  }
  table.notes.push_back(
      "Up to " + std::to_string(rounds) +
      " rounds; 99 % bootstrap intervals. An alarm: more than 5 %, its lower end above 2 %, in two "
      "passes.");
  if (time.control)
    table.notes.push_back(
        "The control kernel, which must not change: " + change_entry(time.control).shown + ".");
  return table;
}

Table work_table(const WorkFindings& work, const Work& counted) {
  Table table{.name = "work",
              .title = "Work: instructions of " + std::to_string(counted.steps) + " steps with " +
                       std::to_string(counted.iterations) + " iterations each",
              .notes = {"Counted by " + counted.tool +
                        "; repeatable to the last one. An alarm: 1.0 % or more."},
              .columns = {{"cell", {}},
                          {"base", {"base"}},
                          {"head", {"head"}},
                          {"change", {"percent"}},
                          {"outcome", {}}},
              .rows = {}};
  for (const WorkFinding& f : work.candidates) {
    const std::string base = std::to_string(f.base), head = std::to_string(f.head),
                      percent = signed_percent(f.percent);
    table.rows.push_back({text_entry(f.candidate),
                          {base, {base}, {}},
                          {head, {head}, {}},
                          {percent + " %", {percent}, {}},
                          text_entry(outcome_word(f.outcome))});
  }
  return table;
}

template <class Findings>
std::string candidates_with(const Findings& findings, Outcome outcome) {
  std::string list;
  for (const auto& f : findings)
    if (f.outcome == outcome) list += (list.empty() ? "" : ", ") + f.candidate;
  return list;
}

void say(std::vector<std::string>& paragraphs, const std::string& what,
         const std::string& candidates) {
  if (!candidates.empty()) paragraphs.push_back(what + ": " + candidates + ".");
}

void say_differences(std::vector<std::string>& paragraphs, const std::string& what,
                     const std::vector<Difference>& differences) {
  for (const Difference& d : differences)
    paragraphs.push_back(what + " cannot be compared, " + d.what + ": " + d.first + " in base, " +
                         d.second + " in head.");
}

std::vector<std::string> summary(const CheckOutcome& j) {
  std::vector<std::string> text;
  for (const Excluded& candidate : j.invalid)
    text.push_back("Wrong numerics, not timed: " + candidate.candidate + " (" + candidate.reason +
                   ").");
  for (const std::string& candidate : j.missing)
    text.push_back("Not measured, but in the baseline: " + candidate + ".");
  say(text, "Slower", candidates_with(j.time.candidates, Outcome::regression));
  say(text, "More work", candidates_with(j.work.candidates, Outcome::regression));
  say(text, "Faster", candidates_with(j.time.candidates, Outcome::gain));
  say(text, "Less work", candidates_with(j.work.candidates, Outcome::gain));
  say(text, "An alarm that needs its second pass",
      candidates_with(j.time.candidates, Outcome::unconfirmed));
  say(text, "Too noisy to tell", candidates_with(j.time.candidates, Outcome::noisy));
  say_differences(text, "Times", j.differences);
  say_differences(text, "Instruction counts", j.work.differences);
  if (j.verdict == Verdict::incomparable && j.differences.empty() && j.work.differences.empty())
    text.push_back("There is nothing to compare with.");
  for (const Excluded& candidate : j.excluded)
    text.push_back("Not compared: " + candidate.candidate + " (" + candidate.reason + ").");
  if (text.empty()) text.push_back("No cell has changed.");
  return text;
}

std::string side(const char* name, const Record& r) {
  return std::string(name) + " is " + r.commit.substr(0, 12) +
         (r.dirty ? " with uncommitted changes" : "");
}

std::string provenance(const CheckRecord& check) {
  const Record& head = check.head;
  std::string text = (check.base ? side("Base", *check.base) + ", h" : std::string("H")) +
                     side("ead", head) + "; measured " + head.date + " on " + head.machine.cpu +
                     ", " + std::to_string(head.machine.cores) + " cores, " + head.build.compiler +
                     ", BLAS core " + head.blas.core + ".";
  if (!check.slowed.empty()) text += " On purpose slower: " + check.slowed + " %.";
  return text;
}

}  // namespace

const char* verdict_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "PASS";
    case Verdict::regression:
      return "REGRESSION";
    case Verdict::invalid:
      return "INVALID";
    case Verdict::inconclusive:
      return "INCONCLUSIVE";
    case Verdict::incomparable:
      return "INCOMPARABLE";
  }
  return "";
}

Document verdict_document(const CheckRecord& check, const CheckOutcome& j) {
  Section section{std::string("Verdict: ") + verdict_word(j.verdict), summary(j), {}};
  if (!j.time.candidates.empty()) section.tables.push_back(time_table(j.time));
  if (!j.work.candidates.empty()) section.tables.push_back(work_table(j.work, *check.work));
  section.paragraphs.push_back(provenance(check));
  return {"Regression check", {std::move(section)}};
}

}  // namespace desmo::report
