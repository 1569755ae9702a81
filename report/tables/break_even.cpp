// Where solving all of a mechanism at once costs the same with dense and with sparse matrices.
#include "report/statistics/break_even.h"

#include <array>
#include <map>
#include <set>
#include <string_view>

#include "report/statistics/variants.h"
#include "report/tables/size.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

/// What the paper says: near 60 variables, comparing LAPACK with MA27.
constexpr const char* published_break_even = "60";

constexpr std::array<std::string_view, 2> dense{"lapack", "eigen"};

std::string id_of(std::string_view algebra) { return "global_automatic_" + std::string(algebra); }

/// The curves of a case, by algebra; empty ones of what was not measured.
class CaseCurves {
 public:
  CaseCurves(const std::vector<Curve>& curves, const std::string& case_name) : name_(case_name) {
    for (const Curve& curve : curves)
      if (curve.case_name == case_name) by_id_[curve.id] = curve;
  }
  Curve of(std::string_view algebra) const {
    const auto found = by_id_.find(id_of(algebra));
    return found == by_id_.end() ? Curve{name_, id_of(algebra), {}, false} : found->second;
  }
  Curve faster_dense() const { return faster_of(of(dense[0]), of(dense[1])); }

 private:
  std::string name_;
  std::map<std::string, Curve> by_id_;
};

/// "66 [61, 76]"; in words where there is none.
Entry break_even_entry(const CurveComparison& r) {
  if (r.sizes == 0) return note_entry(missing_mark);
  if (!r.second_faster_at_largest)
    return note_entry("dense at the largest, " + write_shortest(r.largest));
  if (!r.break_even) return note_entry("sparse from the smallest, " + write_shortest(r.smallest));
  const std::string value = write_fixed(r.break_even->unknowns, 0),
                    low = write_shortest(r.break_even->low),
                    high = write_shortest(r.break_even->high);
  return {value + " [" + low + ", " + high + "]", {value, low, high}, {}};
}

/// Families of which something was measured in the case.
std::vector<std::string_view> measured_families(const CaseCurves& of_case) {
  std::vector<std::string_view> families;
  for (const std::string_view family : sparse_families)
    if (!of_case.of(family).points.empty()) families.push_back(family);
  return families;
}

Table break_even_sizes(const std::vector<Curve>& curves, const std::set<std::string>& cases) {
  const std::vector<std::string> quantities{"unknowns", "low", "high"};
  Table table{
      .name = "break_even",
      .title = "Unknowns from which on sparse matrices are faster than dense ones",
      .notes = {"All unknowns at once, the same equations (global_automatic_…), least times "
                "of a whole step; interpolated in log t over log n between the sizes "
                "measured [the neighbours; the outermost where the curves cross more than "
                "once]. The paper compares LAPACK with MA27."},
      .columns = {{"case", {}},
                  {"sparse", {}},
                  {"lapack", quantities},
                  {"eigen", quantities},
                  {"the faster of both", quantities},
                  {"the paper, about", {"unknowns"}}},
      .rows = {}};
  for (const std::string& name : cases) {
    const CaseCurves of_case(curves, name);
    for (const std::string_view family : measured_families(of_case)) {
      const Curve sparse = of_case.of(family);
      table.rows.push_back({text_entry(name),
                            text_entry(std::string(family)),
                            break_even_entry(compare(of_case.of(dense[0]), sparse)),
                            break_even_entry(compare(of_case.of(dense[1]), sparse)),
                            break_even_entry(compare(of_case.faster_dense(), sparse)),
                            {published_break_even, {published_break_even}, {}}});
    }
  }
  return table;
}

}  // namespace

Section dense_or_sparse(const Record& record) {
  const std::vector<Curve> curves = curves_of(record.break_even);
  std::set<std::string> cases;
  for (const Curve& curve : curves) cases.insert(curve.case_name);
  Section section{"Dense or sparse", {}, {break_even_sizes(curves, cases)}};
  for (const std::string& name : cases) section.tables.push_back(break_even_times(record, name));
  return section;
}

}  // namespace desmo::report
