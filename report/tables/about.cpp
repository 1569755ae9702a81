// How it was measured, what a reader must not conclude, and what failed.
#include <algorithm>

#include "report/tables/record_words.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text.empty() ? missing_mark : text;
}

std::string loads(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(write_fixed(value, 2));
  return joined(items);
}

bool is_unsteady(const Machine& machine) {
  const bool busy = !machine.load_before.empty() &&
                    machine.load_before.front() > 0.5 * static_cast<double>(machine.cores);
  return busy || machine.governor.empty() || machine.governor == "unknown";
}

}  // namespace

Table provenance(const Record& record) {
  Table table = headed_table("provenance");
  const auto add = [&table](const std::string& what, const std::string& value) {
    table.rows.push_back({what, value});
  };
  const Machine& machine = record.machine;
  const Settings& settings = record.settings;
  add("date", record.date);
  add("commit", commit_of(record));
  add("command", record.command);
  add("CPU", machine.cpu + ", " + std::to_string(machine.cores) + " cores");
  add("caches", joined(machine.caches));
  add("kernel", machine.kernel);
  add("frequency governor", machine.governor);
  if (machine.turbo) add("turbo", *machine.turbo);
  add("load before", loads(machine.load_before));
  add("load after", loads(machine.load_after));
  add("compiler", record.build.compiler);
  add("build type", record.build.type);
  add("flags", record.build.flags);
  if (const auto& link = record.build.link)
    add("linking", link->type + (link->flags.empty() ? "" : ", " + link->flags) + ": " +
                       joined(link->libraries));
  if (const auto& binary = record.build.binary) add("SHA-256 of the program", *binary);
  for (const auto& [name, version] : record.libraries) add(name, version);
  add("BLAS core", record.blas.core);
  add("BLAS threads", std::to_string(record.blas.threads));
  add("tolerance", write_shortest(settings.tolerance));
  add("iterations at most", std::to_string(settings.max_iterations));
  add("first guess", settings.guess);
  add("step", write_shortest(settings.step_seconds) + " s");
  add("duration", write_shortest(settings.duration_seconds) + " s, " +
                      std::to_string(settings.instants) + " instants");
  if (const auto& allowed = settings.allowed)
    add("errors allowed", "q " + write_shortest(allowed->position) + ", q' " +
                              write_shortest(allowed->velocity) + ", q'' " +
                              write_shortest(allowed->acceleration));
  add("schema version", record.version);
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
