// What a coordinate costs a step, by the cache that holds the memory of a formulation.
#include <optional>

#include "report/statistics/caches.h"
#include "report/statistics/curves.h"
#include "report/tables/entries.h"
#include "report/tables/size.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

/// "9.13 at 225 … 447": the mean cost of a coordinate while memory is held so, and the sizes.
Entry held_entry(const Curve& curve, const std::vector<Cache>& caches, const std::string& holder) {
  std::vector<const CurvePoint*> held;
  for (const CurvePoint& point : curve.points)
    if (point.entry->bytes && held_by(caches, *point.entry->bytes) == holder)
      held.push_back(&point);
  if (held.empty()) return note_entry(missing_mark);
  double sum = 0;
  for (const CurvePoint* point : held) sum += point->nanoseconds();
  const std::string mean = write_significant(sum / static_cast<double>(held.size()), 3),
                    from = std::to_string(held.front()->coordinates),
                    to = std::to_string(held.back()->coordinates);
  return {mean + " at " + from + " … " + to, {mean, from, to}, {}};
}

}  // namespace

Table growth_caches(const Record& record, const std::vector<Curve>& curves) {
  const std::vector<Cache> caches = data_caches(record.machine);
  Table table{.name = "growth_caches",
              .title = "What a coordinate costs a step while memory is held by a cache",
              .notes = {"ns/coordinate, the mean over the sizes at which all that the formulation "
                        "keeps in memory (libraries included; a step touches less) is held by the "
                        "cache, and these sizes. Bytes/coordinate: at the largest size."},
              .columns = {{"case", {}}, {"id", {}}, {"bytes/coordinate", {"bytes"}}},
              .rows = {}};
  if (caches.empty()) table.notes.front() += " This machine does not tell its caches.";
  for (const Cache& cache : caches)
    table.notes.front() += " " + cache.name + ": " + write_shortest(cache.bytes / 1024) + " KiB.";
  for (const std::string& holder : holders(caches))
    table.columns.push_back({holder, {"nanoseconds", "from", "to"}});
  for (const Curve& curve : curves) {
    std::optional<double> bytes;
    if (!curve.points.empty() && curve.points.back().entry->bytes)
      bytes =
          *curve.points.back().entry->bytes / static_cast<double>(curve.points.back().coordinates);
    std::vector<Entry> row{text_entry(curve.case_name), text_entry(curve.id),
                           number_entry(bytes, 3)};
    for (const std::string& holder : holders(caches))
      row.push_back(held_entry(curve, caches, holder));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
