// Does CPU time grow linearly? The slope of log t over log n is one when it does.
#include "report/statistics/measurements.h"
#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/tables/slope.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"

namespace desmo::report {
namespace {

SizedTimes published_points(const Variant& variant) {
  SizedTimes points;
  for (const std::int64_t size : published_sizes())
    if (const auto seconds =
            published_cpu_seconds().number(std::to_string(size), variant.paper_name)) {
      points.sizes.push_back(static_cast<double>(size));
      points.seconds.push_back(*seconds);
    }
  return points;
}

SizedTimes measured_points(const Record& record, const Variant& variant, std::string_view family) {
  SizedTimes points;
  for (const std::int64_t size : recorded_sizes(record, variant.case_name)) {
    const Measured found = measured(record, family_key(variant, size, family));
    if (found.mark == failed_mark) points.mark = failed_mark;
    if (!found.seconds) continue;
    points.sizes.push_back(static_cast<double>(size));
    points.seconds.push_back(found.seconds->value);
  }
  return points;
}

}  // namespace

Table scaling(const Record& record) {
  Table table{
      .name = "scaling",
      .title = "Growth of CPU time: log-log slope over the number of coordinates",
      .notes = {"Least squares through the " + time_words(record).times +
                ", one point per size (n sizes, all that "
                "were recorded); [95 % interval of Student's t, n − 2 degrees of freedom]; " +
                linear_note() + "."},
      .columns = {{"analysis", {}}},
      .rows = {}};
  table.columns.push_back({"paper (MA27)", slope_quantities});
  for (const std::string_view family : recorded_families(record))
    table.columns.push_back({std::string(family), slope_quantities});
  for (const Variant& variant : variants) {
    std::vector<Entry> row{text_entry(family_name(variant, "<sparse>")),
                           slope_entry(published_points(variant))};
    for (const std::string_view family : recorded_families(record))
      row.push_back(slope_entry(measured_points(record, variant, family)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
