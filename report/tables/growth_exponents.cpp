// How the time of a step grows with the number of coordinates, and up to where.
#include <optional>

#include "report/statistics/curves.h"
#include "report/tables/entries.h"
#include "report/tables/size.h"
#include "report/tables/slope.h"
#include "report/text/digits.h"

namespace desmo::report {

SizedTimes fitted_times(const Curve& curve) {
  SizedTimes times;
  for (const CurvePoint& point : curve.points)
    if (point.coordinates <= max_linear_coordinates) {
      times.sizes.push_back(static_cast<double>(point.coordinates));
      times.seconds.push_back(point.seconds);
    }
  if (curve.failed) times.mark = failed_mark;
  return times;
}

namespace {

/// "8.28 at 558"
Entry cost_entry(const CurvePoint* point) {
  if (!point) return note_entry(missing_mark);
  const std::string cost = write_significant(point->nanoseconds(), 3),
                    size = std::to_string(point->coordinates);
  return {cost + " at " + size, {cost, size}, {}};
}

/// "22203, 17620", in KiB.
Entry end_entry(const CurvePoint* end) {
  if (!end) return note_entry("nowhere");
  const std::string size = std::to_string(end->coordinates);
  if (!end->entry->bytes) return {size, {size, ""}, {}};
  const std::string memory = write_significant(*end->entry->bytes / 1024, 4);
  return {size + ", " + memory, {size, memory}, {}};
}

/// "3.00 – 2.73", of the smallest and the largest size.
Entry iterations_entry(const Curve& curve) {
  if (curve.points.empty()) return note_entry(missing_mark);
  const std::string first = write_fixed(curve.points.front().entry->iterations_per_step, 2),
                    last = write_fixed(curve.points.back().entry->iterations_per_step, 2);
  return {first + " – " + last, {first, last}, {}};
}

}  // namespace

Table growth_exponents(const std::vector<Curve>& curves) {
  Table table{
      .name = "growth_exponents",
      .title = "Growth of the time of a step: log-log slope up to " +
               std::to_string(max_linear_coordinates) + " coordinates",
      .notes = {"Slope: least squares through the least times, n sizes [95 % interval of Student's "
                "t, n − 2 degrees of freedom]; " +
                    linear_note() + ".",
                "Dearer: the first size from which on a coordinate costs more than " +
                    write_shortest(dearer) +
                    " times its least, and the KiB that the formulation keeps in memory there. "
                    "Times the least: at the largest size.",
                "The tolerance grows with the size as rounding does, so that Newton's method may "
                "take a little less at the largest: iterations a step from the smallest size to "
                "the largest."},
      .columns = {{"case", {}},
                  {"id", {}},
                  {"slope", slope_quantities},
                  {"ns/coordinate, least", {"nanoseconds", "coordinates"}},
                  {"dearer from, KiB", {"coordinates", "kibibytes"}},
                  {"times the least", {"ratio"}},
                  {"iterations/step", {"smallest", "largest"}}},
      .rows = {}};
  for (const Curve& curve : curves) {
    const CurvePoint* const least = cheapest(curve);
    table.rows.push_back(
        {text_entry(curve.case_name), text_entry(curve.id), slope_entry(fitted_times(curve)),
         cost_entry(least), least ? end_entry(end_of_growth(curve)) : note_entry(missing_mark),
         number_entry(least
                          ? std::optional(curve.points.back().nanoseconds() / least->nanoseconds())
                          : std::nullopt,
                      3),
         iterations_entry(curve)});
  }
  return table;
}

}  // namespace desmo::report
