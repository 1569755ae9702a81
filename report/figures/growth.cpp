#include <nlohmann/json.hpp>
#include <set>

#include "report/figures/figures.h"
#include "report/statistics/curves.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/embedded.h"

namespace desmo::report {
namespace {

using Json = nlohmann::ordered_json;

/// Columns of the table that is drawn.
enum GrowthColumn : std::size_t {
  panel_column,
  id_column,
  coordinates_column,
  time_column,
  cost_column,
  memory_column,
};

Json number(const Entry& entry) {
  return entry.has_number() ? Json::parse(entry.digits[0]) : Json();
}

Json mark(const std::vector<Entry>& row) {
  return {{"panel", row[panel_column].shown},
          {"id", row[id_column].shown},
          {"coordinates", Json::parse(row[coordinates_column].shown)},
          {"kibibytes", number(row[memory_column])},
          {"nanoseconds", number(row[cost_column])},
          {"shown", row[time_column].shown},
          {"shown_cost", row[cost_column].shown},
          {"shown_memory", row[memory_column].shown}};
}

}  // namespace

NewFile growth_figure(const Record& record) {
  const Table table = growth_data(record);
  Json spec = Json::parse(embedded::growth), data = Json::array();
  std::set<std::string> measured, panels;
  for (const auto& row : table.rows) {
    measured.insert(row[id_column].shown);
    panels.insert(row[panel_column].shown);
    if (row[time_column].has_number()) data.push_back(mark(row));
  }
  for (const std::string& name : panels)
    for (const Cache& cache : data_caches(record.machine)) {
      const double kibibytes = cache.bytes / 1024;
      data.push_back({{"panel", name},
                      {"cache", cache.name + " " + write_shortest(kibibytes) + " KiB"},
                      {"at", kibibytes}});
    }
  Json& layers = spec["spec"]["layer"];
  keep_measured(spec, {&layers[0]["encoding"], &layers[1]["encoding"]}, measured);
  return filled_figure(table, std::move(spec), std::move(data));
}

}  // namespace desmo::report
