// A record in words: how it was measured, what a reader must not conclude, and what failed.
#include "report/tables/record_words.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "report/statistics/paper.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {

bool has_samples_of_windows(const Record& record) {
  return std::ranges::any_of(record.candidates, [](const auto& candidate) {
    return !candidate.second.time.windows.samples.empty();
  });
}

std::string commit_of(const Record& record) {
  return record.commit + (record.dirty ? " " + sentence("common.uncommitted") : "");
}

std::string time_word(const Record& record) {
  return sentence(record.settings.windows ? "common.undisturbed" : "common.median");
}

std::string time_and_median(const Record& record) {
  return sentence(record.settings.windows ? "common.undisturbed_and_median" : "common.median");
}

void define_time(Table& table, const Record& record) {
  if (record.settings.windows)
    table.notes.push_back(
        sentence(has_samples_of_windows(record) ? "common.time_of_samples" : "common.time_of_least",
                 {{"windows", *record.settings.windows}}));
}

std::string repetitions(const Record& record) {
  std::set<std::size_t> counts;
  for (const auto& [key, candidate] : record.candidates)
    if (candidate.status == Status::ok) counts.insert(candidate.time.seconds.size());
  if (counts.empty()) return sentence("common.no_repetitions");
  if (counts.size() > 1)
    return sentence("common.some_repetitions",
                    {{"least", *counts.begin()}, {"most", *counts.rbegin()}});
  return sentence(*counts.begin() == 1 ? "common.one_repetition" : "common.repetitions",
                  {{"count", *counts.begin()}});
}

Sources sources(const Record& record) {
  const double duration = record.settings.duration_seconds;
  if (std::abs(duration - published_duration) < 1e-9) return {"ours", "paper", {}, {}};
  const std::string ours = write_shortest(duration) + " s",
                    paper = write_shortest(published_duration) + " s";
  const TextValues motions{{"ours", ours}, {"paper", paper}};
  return {"ours, " + ours, "paper, " + paper, sentence("common.times_not_compared", motions),
          sentence("common.ratios_of_unequal", motions)};
}

namespace {

bool is_unsteady(const Machine& machine) {
  const bool busy = machine.load_before > 0.5 * static_cast<double>(machine.cores);
  return busy || machine.governor.empty() || machine.governor == "unknown";
}

}  // namespace

Table provenance(const Record& record) {
  Table table = headed_table("provenance");
  for (const auto& [what, value] : record.provenance) table.rows.push_back({what, value});
  table.rows.push_back({"schema version", record.version});
  return table;
}

Section limitations(const Record& record) {
  Section section = headed_section("limitations");
  const auto say = [&section](bool holds, const char* name) {
    if (holds) section.paragraphs.push_back(sentence(std::string("limitations.") + name));
  };
  const bool ma27 = std::ranges::count(recorded_families(record), papers_own) > 0;
  say(!ma27, "without_ma27");
  say(ma27, "with_ma27");
  for (const char* always : {"truck", "machines", "intervals", "errors"}) say(true, always);
  say(is_unsteady(record.machine), "unsteady");
  say(record.dirty, "dirty");
  if (const Sources source = sources(record); has_paper(record) && !source.warning.empty())
    section.paragraphs.push_back(source.warning);
  return section;
}

std::vector<std::string> failures(const Record& record) {
  std::vector<std::string> lines;
  for (const Clock clock : {Clock::cpu, Clock::wall})
    for (const auto& [key, timing] : timings(record, clock))
      if (timing.time.mark == failed_mark)
        lines.push_back(
            sentence("failures.line", {{"candidate", name_of(key)}, {"reason", timing.remark}}));
  return lines;
}

}  // namespace desmo::report
