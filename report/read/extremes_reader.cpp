#include "report/read/extremes_reader.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace desmo::report {
namespace {

using Verdict = ExtremeResult::Verdict;

Verdict read_verdict(const JsonNode& node) {
  const std::string verdict = node.text();
  if (verdict == "as_expected") return Verdict::as_expected;
  if (verdict == "missed") return Verdict::missed;
  if (verdict == "defect") return Verdict::defect;
  if (verdict == "not_applicable") return Verdict::not_applicable;
  node.complain("\"" + verdict +
                "\" is none of \"as_expected\", \"missed\", \"defect\", \"not_applicable\"");
}

ExtremeError read_error(const JsonNode& node) {
  return {node["error"].not_negative(), node["floor"].not_negative(),
          node["allowed"].not_negative()};
}

ExtremeResult read_result(const JsonNode& node) {
  ExtremeResult r{.row = node["row"].integer(1),
                  .case_name = node["case"].text(),
                  .id = node["id"].text(),
                  .outcome = node["outcome"].text(),
                  .verdict = read_verdict(node["verdict"]),
                  .reason = {},
                  .worst = {}};
  if (const auto reason = node.find("reason")) r.reason = reason->text();
  if (r.reason.empty() && r.verdict != Verdict::as_expected)
    node.complain("what is not as expected needs a reason");
  if (const auto instants = node.find("instants")) {
    r.instants = instants->integer(1);
    r.iterations = node["iterations"].integer(0);
  }
  if (const auto worst = node.find("worst"))
    r.worst = {read_error((*worst)["position"]), read_error((*worst)["velocity"]),
               read_error((*worst)["acceleration"])};
  return r;
}

}  // namespace

void read_extremes(Record& record, const JsonNode& section) {
  if (const auto rows = section.find("rows"))
    for (const JsonNode& node : rows->elements()) {
      record.extreme_rows.push_back({node["row"].integer(1), node["name"].text(),
                                     node["extreme"].text(), node["expected"].text()});
      if (std::ranges::count(record.extreme_rows, record.extreme_rows.back().number,
                             &ExtremeRow::number) > 1)
        node.complain("row " + std::to_string(record.extreme_rows.back().number) +
                      " is given twice");
    }
  const auto results = section.find("results");
  if (!results) return;
  std::set<std::tuple<std::int64_t, std::string, std::string>> seen;
  for (const JsonNode& node : results->elements()) {
    record.extremes.push_back(read_result(node));
    const ExtremeResult& r = record.extremes.back();
    if (!std::ranges::count(record.extreme_rows, r.row, &ExtremeRow::number))
      node["row"].complain("\"rows\" has no row " + std::to_string(r.row));
    if (!seen.emplace(r.row, r.case_name, r.id).second)
      node.complain(r.id + " in \"" + r.case_name + "\" is given twice");
  }
}

}  // namespace desmo::report
