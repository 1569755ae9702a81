// How exact the reference is, and what conditioning lets expect.
#include <algorithm>

#include "report/statistics/selection.h"
#include "report/tables/entries.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

namespace desmo::report {

std::string max_floor(const Record& record) {
  double largest = 0;
  for (const auto& [series, floor] : record.floors)
    largest = std::max({largest, floor.reference.position, floor.reference.velocity,
                        floor.reference.acceleration});
  return "The two solutions in quadruple precision that the reference consists of differ by " +
         error_entry(largest).shown + " at most, at every level of every motion.";
}

Table floors(const Record& record) {
  Table table{
      .name = "floors",
      .title = "How exact the reference is, and what conditioning lets expect",
      .notes =
          {"Reference: how far its two solutions in quadruple precision differ. κ: the largest "
           "condition number at the instants compared; predicted: κ u, κ² u and κ³ u with the "
           "unit roundoff u of double and float. All relative, as the errors."},
      .columns = {{"case", {}},
                  {"coordinates", {}},
                  {"step s", {}},
                  {"instants", {}},
                  {"reference q", {"error"}},
                  {"reference q'", {"error"}},
                  {"reference q''", {"error"}},
                  {"κ", {"condition"}}},
      .rows = {}};
  for (const char* scalar : {"double", "float"})
    for (const char* level : {"q", "q'", "q''"})
      table.columns.push_back({std::string(scalar) + " " + level, {"error"}});
  for (const auto& [series, floor] : record.floors) {
    std::vector<Entry> row{text_entry(series.case_name),
                           text_entry(std::to_string(series.coordinates)),
                           text_entry(write_shortest(series.step_seconds)),
                           text_entry(std::to_string(series.instants)),
                           error_entry(floor.reference.position),
                           error_entry(floor.reference.velocity),
                           error_entry(floor.reference.acceleration),
                           number_entry(floor.condition, 2)};
    for (const auto& limit : {floor.in_double, floor.in_float})
      for (double PerLevel::*level :
           {&PerLevel::position, &PerLevel::velocity, &PerLevel::acceleration})
        row.push_back(error_entry(limit ? std::optional((*limit).*level) : std::nullopt));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
