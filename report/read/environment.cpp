// The head of a record: what was measured on, built and set.
#include <cmath>

#include "report/read/readers.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

Allowed read_allowed(const RecordValue& node) {
  return {read_levels(node, &RecordValue::positive), node.maybe("request", &RecordValue::positive)};
}

Machine read_machine(const RecordValue& node) {
  const auto loads = node.maybe(
      "load_before", [](const RecordValue& list) { return list.list(&RecordValue::not_negative); });
  return {.cpu = node["cpu"].text(),
          .cores = node["cores"].integer(1),
          .caches = node["caches"].list(&RecordValue::text),
          .governor = node["governor"].text(),
          .load_before = loads && !loads->empty() ? loads->front() : 0};
}

Build read_build(const RecordValue& node) {
  Build build{node["type"].text(), node["compiler"].text(), node["flags"].text(), std::nullopt};
  if (const auto link = node.find("link")) {
    const std::string flags = (*link)["flags"].text();
    build.link = (*link)["type"].text() + (flags.empty() ? "" : " " + flags);
  }
  return build;
}

Settings read_settings(const RecordValue& node) {
  Settings settings{.tolerance = node["tolerance"].positive(),
                    .max_iterations = node["max_iterations"].integer(1),
                    .guess = node["guess"].text(),
                    .step_seconds = node["step_seconds"].positive(),
                    .duration_seconds = node["duration_seconds"].positive(),
                    .instants = node["instants"].integer(1),
                    .allowed = node.maybe("allowed", read_allowed),
                    .windows = node.maybe(
                        "windows", [](const RecordValue& windows) { return windows.integer(2); })};
  const double steps = settings.duration_seconds / settings.step_seconds;
  if (std::abs(steps - static_cast<double>(settings.instants - 1)) > 0.01)
    node["instants"].complain(std::to_string(settings.instants) + " instants do not make " +
                              write_shortest(settings.duration_seconds) + " s in steps of " +
                              write_shortest(settings.step_seconds) + " s");
  return settings;
}

}  // namespace

Record read_environment(const RecordValue& node) {
  const RecordValue blas = node["blas"];
  Record record;
  record.date = node["date"].utc();
  record.commit = node["commit"].text();
  record.dirty = node["dirty"].boolean();
  record.machine = read_machine(node["machine"]);
  record.build = read_build(node["build"]);
  for (const auto& [name, version] : node["libraries"].members())
    record.libraries.emplace(name, version.text());
  record.blas = {blas["core"].text(), blas["threads"].integer(1)};
  record.settings = read_settings(node["settings"]);
  record.provenance = node.leaves();
  return record;
}

}  // namespace desmo::report
