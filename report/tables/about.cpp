// How it was measured, what a reader must not conclude, and what failed.
#include <algorithm>

#include "report/tables/record_words.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
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
