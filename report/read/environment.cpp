
#include <cmath>
#include <string>

#include "report/read/readers.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

std::vector<double> read_numbers(const std::optional<RecordValue>& node) {
  std::vector<double> result;
  if (node)
    for (const RecordValue& element : node->elements()) result.push_back(element.not_negative());
  return result;
}

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
                  .kernel = node["kernel"].text(),
                  .governor = node["governor"].text(),
                  .turbo = node.find_text("turbo"),
                  .load_before = read_numbers(node.find("load_before")),
                  .load_after = read_numbers(node.find("load_after"))};
  for (const RecordValue& cache : node["caches"].elements()) machine.caches.push_back(cache.text());
  return machine;
}

Build read_build(const RecordValue& node) {
  Build build{.type = node["type"].text(),
              .compiler = node["compiler"].text(),
              .flags = node["flags"].text(),
              .link = std::nullopt,
              .binary = node.find_text("binary")};
  if (const auto link = node.find("link")) {
    build.link = Link{(*link)["type"].text(), (*link)["flags"].text(), {}};
    for (const RecordValue& library : (*link)["libraries"].elements())
      build.link->libraries.push_back(library.text());
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
  record.command = node["command"].text();
  record.machine = read_machine(node["machine"]);
  record.build = read_build(node["build"]);
  for (const auto& [name, version] : node["libraries"].members())
    record.libraries.emplace(name, version.text());
  record.blas = {blas["core"].text(), blas["threads"].integer(1)};
  record.settings = read_settings(node["settings"]);
  return record;
}

}  // namespace desmo::report
