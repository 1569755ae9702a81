// Does CPU time grow linearly? The slope of log t over log n is one when it does.
#include "report/digits.h"
#include "report/measurements.h"
#include "report/paper.h"
#include "report/tables/tables.h"
#include "report/variants.h"

namespace desmo::report {
namespace {

constexpr double least_linear = 0.9, largest_linear = 1.15;

struct Points {
  std::vector<double> sizes;
  std::vector<double> seconds;
  std::string mark;  // of a size that has no number
};

Points published_points(const Variant& variant) {
  Points points;
  for (const std::int64_t size : published_sizes())
    if (const auto seconds =
            published_cpu_seconds().number(std::to_string(size), variant.paper_name)) {
      points.sizes.push_back(static_cast<double>(size));
      points.seconds.push_back(*seconds);
    }
  return points;
}

Points measured_points(const Record& record, const Variant& variant, std::string_view family) {
  Points points;
  for (const std::int64_t size : recorded_sizes(record, variant.case_name)) {
    const Measured found = measured(record, family_key(variant, size, family));
    if (found.mark == failed_mark) points.mark = failed_mark;
    if (!found.seconds) continue;
    points.sizes.push_back(static_cast<double>(size));
    points.seconds.push_back(found.seconds->value);
  }
  return points;
}

std::string linearity(const Slope& slope) {
  const auto linear = [](double value) { return least_linear <= value && value <= largest_linear; };
  if (!linear(slope.value)) return "OUTSIDE";
  return linear(slope.low) && linear(slope.high) ? "inside" : "inside, interval not";
}

Entry slope_entry(const Points& points) {
  const auto slope = fit_slope(points.sizes, points.seconds);
  const std::string count = std::to_string(points.sizes.size());
  const std::string gap = points.mark.empty() ? "" : ", a size " + points.mark;
  if (!slope && points.sizes.empty())
    return note_entry(points.mark.empty() ? missing_mark : points.mark);
  if (!slope) return note_entry("too few sizes: " + count + gap);
  const std::string value = write_fixed(slope->value, 3), low = write_fixed(slope->low, 3),
                    high = write_fixed(slope->high, 3);
  const std::string note = linearity(*slope) + gap;
  return {value + " [" + low + ", " + high + "] n=" + count + " " + note,
          {value, low, high, count},
          note};
}

}  // namespace

Table scaling(const Record& record) {
  const std::string band = write_shortest(least_linear) + " ... " + write_shortest(largest_linear);
  Table table{.name = "scaling",
              .title = "Growth of CPU time: log-log slope over the number of coordinates",
              .notes = {"Least squares through the " + time_words(record).times +
                        ", one point per size (n sizes, all that "
                        "were recorded); [95 % interval of Student's t, n − 2 degrees of freedom]; "
                        "inside or outside " +
                        band + "."},
              .columns = {{"analysis", {}}},
              .rows = {}};
  const std::vector<std::string> quantities{"slope", "low", "high", "sizes"};
  table.columns.push_back({"paper (MA27)", quantities});
  for (const std::string_view family : recorded_families(record))
    table.columns.push_back({std::string(family), quantities});
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
