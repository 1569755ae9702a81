#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "report/figures/figures.h"
#include "report/statistics/selection.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/embedded.h"

namespace desmo::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double min_drawn = 1e-18;  // where an error stands that is less, or 0
constexpr double max_drawn = 10;     // likewise, that is more
constexpr double margin = 0.7;       // decades between the labels of the front
constexpr std::size_t id = 0, family = 1, time = 2, error = 3, iterations = 8, front = 9, why = 10;

double drawn(double value) { return std::clamp(value, min_drawn, max_drawn); }

Json solved(const std::vector<Entry>& row) {
  return {{"id", row[id].shown},
          {"family", row[family].shown},
          {"microseconds", Json::parse(row[time].digits[0])},
          {"shown", row[time].shown},
          {"drawn_at", drawn(Json::parse(row[error].digits[0]).get<double>())},
          {"shown_error", row[error].shown},
          {"iterations", row[iterations].shown},
          {"front", !row[front].shown.empty()}};
}

Json failed(const std::vector<Entry>& row, int place) {
  return {{"id", row[id].shown},
          {"family", row[family].shown},
          {"reason", kind_of_failure(row[why].shown)},
          {"message", row[why].shown},
          {"place", place}};
}

/// Of the front, whose marks come with the error falling, as many as have margin.
void label(Json& all) {
  double last = 100 * max_drawn;
  for (Json& mark : all)
    if (mark.value("front", false)) {
      const double at = mark["drawn_at"].get<double>();
      if (std::log10(last / at) < margin) continue;
      mark["label"] = mark["iterations"];
      last = at;
    }
}

Json marks(const Table& table) {
  Json all = Json::array();
  std::map<std::string, int> places;
  for (const auto& row : table.rows)
    all.push_back(row[time].has_number() ? solved(row)
                                         : failed(row, ++places[kind_of_failure(row[why].shown)]));
  label(all);
  return all;
}

/// What stands further left than anything drawn is drawn at the edge, and says so.
Json lines(const Floor& floor, double left) {
  Json all = Json::array();
  const auto add = [&](const std::string& what, double value) {
    const bool outside = value < left;
    all.push_back(
        {{"at", outside ? left : value},
         {"what", what + " " + error_entry(value).shown + (outside ? ", further left" : "")},
         {"value", value}});
  };
  add("floor of the reference", floor.reference.position);
  if (floor.in_double) add("κ u, double", floor.in_double->position);
  if (floor.in_float) add("κ u, float", floor.in_float->position);
  return all;
}

/// Whole decades around what is drawn.
Json domain(const Json& all) {
  double least = 1e-16, largest = 1;
  for (const Json& mark : all)
    if (mark.contains("drawn_at")) {
      least = std::min(least, mark["drawn_at"].get<double>());
      largest = std::max(largest, mark["drawn_at"].get<double>());
    }
  return {std::pow(10, std::floor(std::log10(least)) - 1),
          std::pow(10, std::ceil(std::log10(largest)))};
}

std::set<std::string> families(const Table& table) {
  std::set<std::string> measured;
  for (const auto& row : table.rows) measured.insert(row[family].shown);
  return measured;
}

}  // namespace

NewFile work_precision_figure(const Record& record, const std::string& case_name) {
  const Table table = work_precision(record, case_name);
  Json spec = Json::parse(embedded::work_precision), data = marks(table);
  Json& layers = spec["vconcat"][0]["layer"];
  keep_measured(spec, {&layers[0]["encoding"]}, families(table));
  const Json ends = domain(data);
  layers[0]["encoding"]["x"]["scale"]["domain"] = ends;
  const Json rules =
      lines(record.floors.at(*main_series(record, case_name)), ends[0].get<double>());
  for (const std::size_t layer : {3, 4}) layers[layer]["data"]["values"] = rules;
  if (std::ranges::none_of(data, [](const Json& mark) { return mark.contains("reason"); }))
    spec["vconcat"].erase(1);
  return filled_figure(table, std::move(spec), std::move(data));
}

}  // namespace desmo::report
