#include "report/figures/figures.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "report/tables/tables.h"
#include "report/text/embedded.h"

namespace desmo::report {
namespace {

using Json = nlohmann::ordered_json;

// A place of the table: its numbers, none other than those printed, and the text for the hover.
Json datum(const Column& column, const Entry& entry) {
  Json json;
  for (std::size_t i = 0; i < column.quantities.size(); ++i) {
    const bool known = i < entry.digits.size() && !entry.digits[i].empty();
    if (known || i == 0) json[column.quantities[i]] = known ? Json::parse(entry.digits[i]) : Json();
  }
  json["shown"] = entry.shown;
  if (!entry.note.empty()) json["note"] = entry.note;
  return json;
}

Json time_points(const Table& table) {
  Json points = Json::array();
  for (std::size_t i = 2; i < table.columns.size(); ++i)
    for (const auto& row : table.rows) {
      points.push_back({{"panel", row[0].shown},
                        {"analysis", table.columns[i].name},
                        {"coordinates", Json::parse(row[1].shown)}});
      points.back().update(datum(table.columns[i], row[i]));
    }
  return points;
}

Json speed_up_bars(const Table& table) {
  Json bars = Json::array();
  for (const auto& row : table.rows)
    for (std::size_t i = 1; i < row.size(); ++i) {
      const bool incomplete = row[i].note.find("incomplete") != std::string::npos;
      bars.push_back({{"solver", table.columns[i].name}, {"variant", row[0].shown}});
      bars.back().update(datum(table.columns[i], row[i]));
      bars.back()["label"] =
          row[i].has_number() ? row[i].digits[0] + (incomplete ? "*" : "") : "n/a";
    }
  return bars;
}

// The order of the panels; the design knows those of equal motions only.
Json design_of_times(const Table& table) {
  Json spec = Json::parse(embedded::figure5);
  Json order = Json::array();
  for (const auto& row : table.rows)
    if (order.empty() || order.back() != row[0].shown) order.push_back(row[0].shown);
  spec["facet"]["sort"] = std::move(order);
  return spec;
}

/// Leaves in the legend only the families recorded.
Json design_of_speed_ups(const Table& table) {
  Json spec = Json::parse(embedded::figure6);
  std::set<std::string> solvers;
  for (std::size_t i = 1; i < table.columns.size(); ++i) solvers.insert(table.columns[i].name);
  keep_measured(spec, {&spec["layer"][0]["encoding"]}, solvers);
  spec["encoding"]["xOffset"]["sort"] = spec["params"][0]["value"];
  return spec;
}

}  // namespace

std::vector<NewFile> figures(const Record& record) {
  std::vector<NewFile> files;
  if (has_paper(record)) {
    const Table times = figure_of_times(record), speed_ups = figure_of_speed_ups(record);
    files = {filled_figure(times, design_of_times(times), time_points(times)),
             filled_figure(speed_ups, design_of_speed_ups(speed_ups), speed_up_bars(speed_ups))};
  }
  for (const std::string& name : drawn_cases(record))
    files.push_back(work_precision_figure(record, name));
  if (!record.growth.empty()) files.push_back(growth_figure(record));
  return files;
}

}  // namespace desmo::report
