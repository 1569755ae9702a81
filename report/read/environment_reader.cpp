#include "report/read/environment_reader.h"

#include <cmath>
#include <string>

#include "report/text/digits.h"

namespace desmo::report {
namespace {

std::vector<double> read_numbers(const std::optional<JsonNode>& node) {
  std::vector<double> result;
  if (node)
    for (const JsonNode& element : node->elements()) result.push_back(element.not_negative());
  return result;
}

std::optional<Allowed> read_allowed(const JsonNode& settings) {
  const auto node = settings.find("allowed");
  if (!node) return std::nullopt;
  Allowed allowed{(*node)["position"].positive(), (*node)["velocity"].positive(),
                  (*node)["acceleration"].positive(), std::nullopt};
  if (const auto request = node->find("request")) allowed.request = request->positive();
  return allowed;
}

std::optional<std::int64_t> read_windows(const JsonNode& settings) {
  const auto node = settings.find("windows");
  return node ? std::optional(node->integer(2)) : std::nullopt;
}

}  // namespace

Machine read_machine(const JsonNode& node) {
  Machine machine{.cpu = node["cpu"].text(),
                  .cores = node["cores"].integer(1),
                  .caches = {},
                  .kernel = node["kernel"].text(),
                  .governor = node["governor"].text(),
                  .turbo = node.find_text("turbo"),
                  .load_before = read_numbers(node.find("load_before")),
                  .load_after = read_numbers(node.find("load_after"))};
  for (const JsonNode& cache : node["caches"].elements()) machine.caches.push_back(cache.text());
  return machine;
}

Build read_build(const JsonNode& node) {
  Build build{.type = node["type"].text(),
              .compiler = node["compiler"].text(),
              .flags = node["flags"].text(),
              .link = std::nullopt,
              .binary = node.find_text("binary")};
  if (const auto link = node.find("link")) {
    build.link = Link{(*link)["type"].text(), (*link)["flags"].text(), {}};
    for (const JsonNode& library : (*link)["libraries"].elements())
      build.link->libraries.push_back(library.text());
  }
  return build;
}

Settings read_settings(const JsonNode& node) {
  const Settings settings{.tolerance = node["tolerance"].positive(),
                          .max_iterations = node["max_iterations"].integer(1),
                          .guess = node["guess"].text(),
                          .step_seconds = node["step_seconds"].positive(),
                          .duration_seconds = node["duration_seconds"].positive(),
                          .instants = node["instants"].integer(1),
                          .allowed = read_allowed(node),
                          .windows = read_windows(node)};
  const double steps = settings.duration_seconds / settings.step_seconds;
  if (std::abs(steps - static_cast<double>(settings.instants - 1)) > 0.01)
    node["instants"].complain(std::to_string(settings.instants) + " instants do not make " +
                              write_shortest(settings.duration_seconds) + " s in steps of " +
                              write_shortest(settings.step_seconds) + " s");
  return settings;
}

}  // namespace desmo::report
