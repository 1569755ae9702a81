// The head of a record: what was measured on, built and set.
#include <cmath>

#include "report/read/readers.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

std::optional<Allowed> read_allowed(const RecordValue& settings) {
  const auto node = settings.find("allowed");
  if (!node) return std::nullopt;
  Allowed allowed{(*node)["position"].positive(), (*node)["velocity"].positive(),
                  (*node)["acceleration"].positive(), std::nullopt};
  if (const auto request = node->find("request")) allowed.request = request->positive();
  return allowed;
}

Machine read_machine(const RecordValue& node) {
  Machine machine{.cpu = node["cpu"].text(),
                  .cores = node["cores"].integer(1),
                  .caches = {},
                  .governor = node["governor"].text(),
                  .load_before = std::nullopt};
  for (const RecordValue& cache : node["caches"].elements()) machine.caches.push_back(cache.text());
  if (const auto loads = node.find("load_before"))
    for (const RecordValue& load : loads->elements())
      if (const double value = load.not_negative(); !machine.load_before)
        machine.load_before = value;
  return machine;
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
                    .allowed = read_allowed(node),
                    .windows = std::nullopt};
  if (const auto windows = node.find("windows")) settings.windows = windows->integer(2);
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
