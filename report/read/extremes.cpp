// The experiment extremes.
#include <algorithm>
#include <set>
#include <tuple>

#include "report/read/readers.h"

namespace desmo::report {
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
                  .reason = node.maybe("reason", &RecordValue::text).value_or(""),
                  .worst = {}};
  if (r.reason.empty() && r.verdict != ExtremeResult::Verdict::as_expected)
    node.complain("what is not as expected needs a reason");
  if (const auto worst = node.find("worst"))
    r.worst = {read_extreme_error((*worst)["position"]), read_extreme_error((*worst)["velocity"]),
               read_extreme_error((*worst)["acceleration"])};
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
