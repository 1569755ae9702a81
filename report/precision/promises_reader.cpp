#include "report/precision/promises_reader.h"

#include <set>

#include "report/digits.h"

namespace desmo::report {
namespace {

Rival read_rival(const JsonNode& node) {
  Rival rival{
      .id = node["id"].text(), .error = node["error"].not_negative(), .seconds_per_step = {}};
  const JsonNode samples = node["seconds_per_step"];
  for (const JsonNode& sample : samples.elements())
    rival.seconds_per_step.push_back(sample.sample());
  if (rival.seconds_per_step.empty()) samples.complain("at least one sample was expected");
  return rival;
}

Promise read_promise(const JsonNode& node) {
  return {.mechanism = node["mechanism"].name(),
          .coordinates = node["coordinates"].integer(1),
          .step_seconds = node["step_seconds"].positive(),
          .instants = node["instants"].integer(2),
          .allowed = node["allowed"].positive(),
          .promised = node["promised"].not_negative(),
          .compared = node["compared"].integer(2),
          .tried = node["tried"].integer(1),
          .choice = read_rival(node["choice"]),
          .best = read_rival(node["best"])};
}

}  // namespace

void read_promises(Record& record, const JsonNode& root) {
  const auto promises = root.find("promises");
  if (!promises) return;
  std::set<std::pair<std::string, double>> seen;
  for (const JsonNode& node : promises->elements()) {
    record.promises.push_back(read_promise(node));
    const Promise& promise = record.promises.back();
    if (!seen.emplace(promise.mechanism, promise.allowed).second)
      node.complain("the promise of " + write_shortest(promise.allowed) + " for " +
                    promise.mechanism + " is given twice");
  }
}

}  // namespace desmo::report
