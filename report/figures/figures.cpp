#include "report/figures/figures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/figures/growth.h"
#include "report/figures/work_precision.h"
#include "report/statistics/selection.h"
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

// No line in the legend for a family that was not recorded; the others keep their colours.
Json design_of_speed_ups(const Table& table) {
  Json spec = Json::parse(embedded::figure6);
  Json& scale = spec["layer"][0]["encoding"]["color"]["scale"];
  Json domain = Json::array(), range = Json::array();
  for (std::size_t i = 0; i < scale["domain"].size(); ++i) {
    const std::string solver = scale["domain"][i];
    if (std::none_of(table.columns.begin(), table.columns.end(),
                     [&](const Column& column) { return column.name == solver; }))
      continue;
    domain.push_back(solver);
    range.push_back(scale["range"][i]);
  }
  scale["domain"] = domain;
  scale["range"] = range;
  spec["params"][0]["value"] = domain;
  spec["encoding"]["xOffset"]["sort"] = domain;
  return spec;
}

Rendered filled(const Table& table, Json spec, Json data) {
  spec["title"]["text"] = table.title;
  spec["title"]["subtitle"] = table.notes;
  spec["data"] = {{"values", std::move(data)}};
  return {table.name + ".vl.json", spec.dump(1) + "\n"};
}

}  // namespace

std::vector<Rendered> figures(const Record& record) {
  std::vector<Rendered> files;
  if (has_paper(record)) {
    const Table times = figure_of_times(record), speed_ups = figure_of_speed_ups(record);
    files = {filled(times, design_of_times(times), time_points(times)),
             filled(speed_ups, design_of_speed_ups(speed_ups), speed_up_bars(speed_ups))};
  }
  for (const std::string& name : drawn_cases(record))
    files.push_back(work_precision_figure(record, name));
  if (!record.growth.empty()) files.push_back(growth_figure(record));
  return files;
}

}  // namespace desmo::report
