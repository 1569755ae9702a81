#include "report/figures/growth.h"

#include <nlohmann/json.hpp>
#include <set>

#include "report/digits.h"
#include "report/embedded.h"
#include "report/figures/legend.h"
#include "report/sizes/caches.h"
#include "report/tables/sizes.h"

namespace desmo::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t panel = 0, id = 1, coordinates = 2, time = 3, cost = 4, memory = 5;

Json number(const Entry& entry) {
  return entry.has_number() ? Json::parse(entry.digits[0]) : Json();
}

Json mark(const std::vector<Entry>& row) {
  return {{"panel", row[panel].shown},
          {"id", row[id].shown},
          {"coordinates", Json::parse(row[coordinates].shown)},
          {"kibibytes", number(row[memory])},
          {"nanoseconds", number(row[cost])},
          {"shown", row[time].shown},
          {"shown_cost", row[cost].shown},
          {"shown_memory", row[memory].shown}};
}

}  // namespace

Rendered growth_figure(const Record& record) {
  const Table table = growth_data(record);
  Json spec = Json::parse(embedded::growth), data = Json::array();
  std::set<std::string> measured, panels;
  for (const auto& row : table.rows) {
    measured.insert(row[id].shown);
    panels.insert(row[panel].shown);
    if (row[time].has_number()) data.push_back(mark(row));
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
  spec["title"]["text"] = table.title;
  spec["title"]["subtitle"] = table.notes;
  spec["data"]["values"] = std::move(data);
  return {table.name + ".vl.json", spec.dump(1) + "\n"};
}

}  // namespace desmo::report
