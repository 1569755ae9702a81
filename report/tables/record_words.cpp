// Words about a record: how it was measured, what must not be concluded from it, and what failed.
#include "report/tables/record_words.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "report/read/record_file.h"
#include "report/statistics/measurements.h"
#include "report/statistics/paper.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

/// Returns the numbers of repetitions of what was timed in the paper's experiment.
std::set<std::size_t> repetition_counts(const Record& record) {
  std::set<std::size_t> counts;
  for (const auto& [key, candidate] : measurements(record))
    if (candidate->status == Status::ok) counts.insert(candidate->time.seconds.size());
  return counts;
}

/// Tells whether something was timed, and nothing often enough for an interval.
bool is_first_look(const std::set<std::size_t>& counts) {
  return !counts.empty() && *counts.rbegin() < min_for_interval;
}

/// Tells whether any candidate has samples of timing windows.
bool has_samples_of_windows(const Record& record) {
  return std::ranges::any_of(record.candidates, [](const auto& candidate) {
    return !candidate.second.time.windows.samples.empty();
  });
}

std::string definition_of_time(const Record& record, bool with_interval) {
  if (!record.settings.windows) return {};
  const std::string kind = has_samples_of_windows(record) ? "samples" : "least";
  return sentence("common.time_of_" + kind, {{"windows", *record.settings.windows}}) +
         (with_interval ? sentence("common.interval_of_" + kind) : "");
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

}  // namespace

TextValues timed_words(const Record& record, const TextValues& more) {
  const std::set<std::size_t> counts = repetition_counts(record);
  const bool windows = record.settings.windows.has_value(), intervals = !is_first_look(counts);
  TextValues words{{"time", sentence(windows ? "common.undisturbed" : "common.median")},
                   {"time_and_median", sentence(!windows    ? "common.median"
                                                : intervals ? "common.undisturbed_and_median"
                                                            : "common.undisturbed")},
                   {"definition", definition_of_time(record, intervals)},
                   {"cpu", record.machine.cpu},
                   {"date", record.date.substr(0, 10)},
                   {"duration", write_shortest(record.settings.duration_seconds)},
                   {"repetitions", repetitions(record)},
                   {"one_digit", intervals && !counts.empty() && *counts.begin() < min_for_interval
                                     ? "; " + sentence("common.one_digit")
                                     : ""}};
  for (const char* word : {"interval", "half_range", "range", "in_or_out", "inconclusive"})
    words.emplace_back(word, intervals ? sentence("intervals." + std::string(word)) : "");
  words.insert(words.end(), more.begin(), more.end());
  return words;
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
  const std::vector<std::string_view> families = recorded_families(record);
  const bool is_paper = has_paper(record), ma27 = std::ranges::count(families, papers_own) > 0;
  say(!ma27 && !(is_paper && families.empty()), "without_ma27");
  say(ma27, "with_ma27");
  say(!is_paper || recorded_sizes(record.candidates).contains(std::string(truck_case)), "truck");
  say(true, "machines");
  say(!is_first_look(repetition_counts(record)), "intervals");
  say(true, "errors");
  say(is_unsteady(record.machine), "unsteady");
  say(record.dirty, "dirty");
  if (std::string note = note_on_version(record.version); !note.empty())
    section.paragraphs.push_back(std::move(note));
  if (const Sources source = sources(record); !families.empty() && !source.warning.empty())
    section.paragraphs.push_back(source.warning);
  return section;
}

std::vector<std::string> failures(const Record& record) {
  std::vector<std::string> lines;
  for (const Clock clock : {Clock::cpu, Clock::wall})
    for (const auto& [key, candidate] : measurements_by(clock, record))
      if (candidate->status == Status::failed)
        lines.push_back(sentence("failures.line",
                                 {{"candidate", name_of(key)}, {"reason", remark(*candidate)}}));
  return lines;
}

}  // namespace desmo::report
