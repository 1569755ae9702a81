// The experiments size and instructions.
#include <algorithm>
#include <utility>

#include "report/read/readers.h"

namespace desmo::report {
namespace {

TimedSize failed(TimedSize entry, std::string why) {
  entry.status = Status::failed;
  entry.message = std::move(why);
  entry.seconds_per_step.clear();
  return entry;
}

/// It grows as the tolerance does beyond the record's.
PerLevel allowed_of(const TimedSize& entry, const Settings& settings) {
  const double times = std::max(1.0, entry.tolerance / settings.tolerance);
  const PerLevel& allowed = settings.allowed->levels;
  return {times * allowed.position, times * allowed.velocity, times * allowed.acceleration};
}

TimedSize read_entry(const RecordValue& node, const Settings& settings) {
  TimedSize entry{.status = read_status(node["status"]),
                  .message = node.maybe("message", &RecordValue::text).value_or(""),
                  .unknowns = node["unknowns"].integer(1),
                  .tolerance = node["tolerance"].positive(),
                  .checked_against = {},
                  .verification = std::nullopt,
                  .bytes = std::nullopt,
                  .seconds_per_step = {}};
  if (entry.status == Status::not_run) node["status"].complain("everything here is run");
  if (entry.status != Status::ok) return entry;
  entry.checked_against = node["checked_against"].text();
  entry.verification = read_levels(node["verification"], &RecordValue::not_negative);
  entry.iterations_per_step = node["iterations_per_step"].not_negative();
  entry.state_bytes = node["state_bytes"].positive();
  entry.bytes = node.maybe("bytes", &RecordValue::positive);
  entry.seconds_per_step = read_cpu_seconds(node["time_per_step"]);
  if (!settings.allowed) return entry;
  std::string reason = excess(*entry.verification, allowed_of(entry, settings));
  return reason.empty() ? entry : failed(std::move(entry), std::move(reason));
}

}  // namespace

void read_sizes(Record& record, const RecordValue& experiment) {
  for (const auto& [list, entries] :
       {std::pair{"growth", &record.growth}, {"break_even", &record.break_even}})
    read_each(experiment, list, [&, &entries = entries](const RecordValue& node) {
      const CandidateKey key = read_key(node);
      add_once(*entries, node, key, read_entry(node, record.settings), name_of(key));
    });
}

void read_instructions(Record& record, const RecordValue& experiment) {
  for (const RecordValue& node : experiment["counts"].elements()) {
    const CandidateKey key = read_key(node);
    add_once(
        record.instructions, node, key,
        {node["instructions_per_step"].integer(1), node["steps"].integer(1), node["tool"].text()},
        name_of(key));
  }
}

}  // namespace desmo::report
