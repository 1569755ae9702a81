#include "report/read/tuning_reader.h"

#include <set>

#include "report/read/time_reader.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

TunedChoice read_tuned_choice(const JsonNode& node) {
  return {node["id"].text(), node["error"].not_negative(), read_cpu_seconds(node["time_per_step"])};
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
          .choice = read_tuned_choice(node["choice"]),
          .best = read_tuned_choice(node["best"])};
}

}  // namespace

void read_tuning(Record& record, const JsonNode& section) {
  const auto promises = section.find("tuning");
  if (!promises) return;
  std::set<std::pair<std::string, double>> seen;
  for (const JsonNode& node : promises->elements()) {
    record.tuning.push_back(read_promise(node));
    const Promise& promise = record.tuning.back();
    if (!seen.emplace(promise.mechanism, promise.allowed).second)
      node.complain("the promise of " + write_shortest(promise.allowed) + " for " +
                    promise.mechanism + " is given twice");
  }
}

}  // namespace desmo::report
