// The experiments size, modelling, instructions and extremes.
#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "report/read/readers.h"

namespace desmo::report {
namespace {

/// Returns the largest errors allowed: those of the settings, times tolerance / the record's
/// tolerance where that is above 1.
LevelNumbers allowed_of(const TimedSize& entry, const RecordSettings& settings) {
  const double times = std::max(1.0, entry.tolerance / settings.tolerance);
  const LevelNumbers& allowed = *settings.allowed;
  return {times * allowed.position, times * allowed.velocity, times * allowed.acceleration};
}

TimedSize read_entry(const RecordValue& node, const RecordSettings& settings) {
  TimedSize entry;
  entry.status = read_status(node["status"]);
  entry.message = node.maybe("message", &RecordValue::text).value_or("");
  entry.unknowns = node["unknowns"].integer(1);
  entry.tolerance = node["tolerance"].positive();
  if (entry.status == Status::not_run) node["status"].complain("everything here is run");
  if (entry.status != Status::ok) return entry;
  entry.checked_against = node["checked_against"].text();
  entry.verification = read_levels(node["verification"], &RecordValue::not_negative);
  entry.iterations_per_step = node["iterations_per_step"].not_negative();
  entry.state_bytes = node["state_bytes"].positive();
  entry.bytes = node.maybe("bytes", &RecordValue::positive);
  entry.time = read_step_time(node["time_per_step"]);
  if (settings.allowed) fail(entry, excess(*entry.verification, allowed_of(entry, settings)));
  return entry;
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

void read_modelling(Record& record, const RecordValue& experiment) {
  read_each(experiment, "times", [&](const RecordValue& node) {
    const CandidateKey key = read_key(node);
    add_once(record.modelled, node, key,
             {{read_entry(node, record.settings)},
              node.maybe("entries", [](const RecordValue& n) { return n.integer(1); }),
              node.maybe("condensation", [](const RecordValue& n) { return n.integer(0); }),
              node["condition"].positive()},
             name_of(key));
  });
}

void read_instructions(Record& record, const RecordValue& experiment) {
  for (const RecordValue node : experiment["counts"].elements()) {
    const CandidateKey key = read_key(node);
    add_once(
        record.instructions, node, key,
        {node["instructions_per_step"].integer(1), node["steps"].integer(1), node["tool"].text()},
        name_of(key));
  }
}

namespace {

ExtremeError read_extreme_error(const RecordValue& node) {
  return {node["error"].not_negative(), node["floor"].not_negative()};
}

ExtremeResult read_result(const RecordValue& node) {
  ExtremeResult r{.row = node["row"].integer(1),
                  .case_name = node["case"].text(),
                  .id = node["id"].text(),
                  .verdict = static_cast<ExtremeResult::Verdict>(node["verdict"].one_of(
                      {"as_expected", "missed", "defect", "not_applicable"})),
                  .reason = node.maybe("reason", &RecordValue::text).value_or("")};
  if (r.reason.empty() && r.verdict != ExtremeResult::Verdict::as_expected)
    node.complain("what is not as expected needs a reason");
  if (const auto worst = node.find("worst")) r.worst = read_levels(*worst, read_extreme_error);
  return r;
}

}  // namespace

void read_extremes(Record& record, const RecordValue& experiment) {
  const auto rows_of = [&](std::int64_t number) {
    return std::ranges::count(record.extreme_rows, number, &ExtremeRow::number);
  };
  read_each(experiment, "rows", [&](const RecordValue& node) {
    record.extreme_rows.push_back({node["row"].integer(1), node["name"].text(),
                                   node["extreme"].text(), node["expected"].text()});
    const std::int64_t number = record.extreme_rows.back().number;
    if (rows_of(number) > 1) node.complain("row " + std::to_string(number) + " is given twice");
  });
  std::set<std::tuple<std::int64_t, std::string, std::string>> seen;
  read_each(experiment, "results", [&](const RecordValue& node) {
    record.extremes.push_back(read_result(node));
    const ExtremeResult& r = record.extremes.back();
    if (rows_of(r.row) == 0) node["row"].complain("\"rows\" has no row " + std::to_string(r.row));
    if (!seen.emplace(r.row, r.case_name, r.id).second)
      node.complain(r.id + " in \"" + r.case_name + "\" is given twice");
  });
}

}  // namespace desmo::report
