// From which number of unknowns on solving all at once is faster with sparse matrices than with
// dense ones.
#include <map>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

/// What the paper says: near 60 variables, comparing LAPACK with MA27.
constexpr const char* published_break_even = "60";

/// "66 [61, 76]"; in words where there is none.
Entry break_even_entry(const Curve& dense, const Curve& sparse) {
  const CurveComparison r = compare(dense, sparse);
  if (r.sizes == 0) return note_entry(missing_mark);
  if (!r.second_faster_at_largest)
    return note_entry(sentence("break_even.dense", {{"unknowns", write_shortest(r.largest)}}));
  if (!r.break_even)
    return note_entry(sentence("break_even.sparse", {{"unknowns", write_shortest(r.smallest)}}));
  const std::string value = write_fixed(r.break_even->unknowns, 0),
                    low = write_shortest(r.break_even->low),
                    high = write_shortest(r.break_even->high);
  return {value + " [" + low + ", " + high + "]", {value, low, high}, {}};
}

}  // namespace

Section dense_or_sparse(const Record& record) {
  std::map<std::string, std::map<std::string, Curve>> cases;  // curves by formulation
  for (Curve& curve : curves_of(record.break_even))
    cases[curve.case_name][curve.id] = std::move(curve);
  Table table = headed_table("break_even");
  for (auto& [name, curves] : cases) {
    const Curve &lapack = curves["global_automatic_lapack"],
                &eigen = curves["global_automatic_eigen"], faster = faster_of(lapack, eigen);
    for (const std::string_view family : sparse_families) {
      const Curve& sparse = curves["global_automatic_" + std::string(family)];
      if (sparse.points.empty()) continue;
      table.rows.push_back({name, std::string(family), break_even_entry(lapack, sparse),
                            break_even_entry(eigen, sparse), break_even_entry(faster, sparse),
                            digits_entry(published_break_even)});
    }
  }
  Section section = headed_section("break_even_section");
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace desmo::report
