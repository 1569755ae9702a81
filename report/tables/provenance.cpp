// When, on what and how it was measured.
#include "report/tables/tables.h"
#include "report/text/digits.h"

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

}  // namespace

Table provenance(const Record& record) {
  Table table{.name = "provenance",
              .title = "Machine, build and settings",
              .notes = {},
              .columns = {{"what", {}}, {"value", {}}},
              .rows = {}};
  const auto add = [&table](const std::string& what, const std::string& value) {
    table.rows.push_back({text_entry(what), text_entry(value)});
  };
  const Machine& machine = record.machine;
  const Settings& settings = record.settings;
  add("date", record.date);
  add("commit", record.commit + (record.dirty ? " with uncommitted changes" : ""));
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
  add("BLAS", record.blas.core + ", " + std::to_string(record.blas.threads) +
                  (record.blas.threads == 1 ? " thread" : " threads"));
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

}  // namespace desmo::report
