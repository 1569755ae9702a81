// Tables of size: how the time of a step grows with the number of coordinates, and from how many
// unknowns on sparse matrices are faster than dense ones.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Break-even size in the paper: near 60 variables, for LAPACK and MA27.
constexpr const char* published_break_even = "60";

/// Returns the n between two sizes at which d, linear in log n, is zero.
double zero_between(const SizeOfBoth& a, const SizeOfBoth& b) {
  return a.n * std::pow(b.n / a.n, a.d / (a.d - b.d));
}

/// Returns the entry of a break-even size, such as "66 [61, 76]".
/// - 66: number n of unknowns from which on sparse matrices are faster, by interpolation of log t
///   as a function of log n
/// - 61, 76: the size before the first break-even, and the size after the last one
/// The entry has words where the sparse curve is faster at every size, or where the dense curve is
/// faster at the largest size.
Entry break_even_entry(const Curve& dense, const Curve& sparse) {
  const std::vector<SizeOfBoth> all = sizes_of_both(dense, sparse);
  if (all.empty()) return note_entry(missing_mark);
  const auto in_words = [](const char* name, double n) {
    return note_entry(sentence(name, {{"unknowns", write_shortest(n)}}));
  };
  if (!(all.back().d > 0)) return in_words("break_even.dense", all.back().n);
  std::string unknowns, low, high;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if ((all[i - 1].d > 0) == (all[i].d > 0)) continue;
    if (low.empty()) low = write_shortest(all[i - 1].n);
    unknowns = write_fixed(zero_between(all[i - 1], all[i]), 0);  // the last one is kept
    high = write_shortest(all[i].n);
  }
  if (low.empty()) return in_words("break_even.sparse", all.front().n);
  return composed("{} [{}, {}]", {unknowns, low, high});
}

/// Shows from how many unknowns on sparse matrices pay.
Section dense_or_sparse(const Record& record) {
  Curves curves = curves_of(record.break_even);
  Table table = headed_table("break_even");
  std::vector<double> found;  // break-even sizes with the fastest dense solver
  for (const std::string_view family : dense_families)
    table.columns.insert(table.columns.end() - 2,
                         {std::string(family), table.columns.rbegin()[1].quantities});
  for (const auto& [name, sizes] : recorded_sizes(record.break_even)) {
    const auto curve_of = [&](std::string_view family) -> const Curve& {
      return curves[{name, "global_automatic_" + std::string(family)}];
    };
    std::vector<Curve> dense;
    Curve fastest;
    for (const std::string_view family : dense_families)
      fastest = faster_of(fastest, dense.emplace_back(curve_of(family)));
    dense.push_back(fastest);
    for (const std::string_view family : sparse_families) {
      const Curve& sparse = curve_of(family);
      if (sparse.points.empty()) continue;
      std::vector<Entry>& row = table.rows.emplace_back();
      row = {name, std::string(family)};
      for (const Curve& curve : dense) row.push_back(break_even_entry(curve, sparse));
      if (row.back().has_number()) found.push_back(std::stod(row.back().digits.front()));
      row.push_back(digits_entry(published_break_even));
    }
  }
  Section section = headed_section("break_even_section", {}, {std::move(table)});
  if (!found.empty()) {
    const std::string least = write_fixed(std::ranges::min(found), 0),
                      most = write_fixed(std::ranges::max(found), 0);
    const TextValues range{{"unknowns", least == most ? least : least + " to " + most}};
    section.paragraphs = {sentence("break_even_section.found", range)};
    section.numbers = {sentence("break_even_section.range", range)};
  }
  return section;
}

constexpr double min_linear = 0.9, max_linear = 1.15;

bool is_linear(double slope) { return min_linear <= slope && slope <= max_linear; }

/// Fit of an exponent to the times of a curve at up to max_linear_coordinates.
struct Fit {
  explicit Fit(const Curve& curve) {
    std::vector<double> sizes, seconds;
    for (const auto& [coordinates, point] : curve.points)
      if (coordinates <= max_linear_coordinates) {
        sizes.push_back(static_cast<double>(coordinates));
        seconds.push_back(point.seconds);
      }
    count = sizes.size();
    slope = fit_slope(sizes, seconds);
  }
  std::size_t count;
  std::optional<Slope> slope;
};

/// Returns the entry "1.012 [0.990, 1.034] n=5 linear"; where there are fewer than three sizes, a
/// note with their number.
Entry slope_entry(const Curve& curve) {
  const Fit fit(curve);
  const std::string count = std::to_string(fit.count),
                    gap = curve.failed ? ", a size " + std::string(failed_mark) : "";
  if (!fit.slope) return note_entry(sentence("growth_exponents.too_few", {{"sizes", count}}) + gap);
  const auto& [slope, low, high] = *fit.slope;
  const char* const growth = !is_linear(slope)                   ? "not linear"
                             : is_linear(low) && is_linear(high) ? "linear"
                                                                 : "uncertain";
  return composed("{} [{}, {}] n={}",
                  {write_fixed(slope, 3), write_fixed(low, 3), write_fixed(high, 3), count},
                  growth + gap);
}

/// Returns the entry of the time of a step per coordinate [ns], and the number of coordinates:
/// "8.28 at 558".
Entry cost_entry(const CurvePoint& point) {
  return composed("{} at {}",
                  {write_significant(point.nanoseconds(), 3), std::to_string(point.coordinates)});
}

Table exponents(const Curves& curves) {
  Table table = headed_table("growth_exponents");
  for (const auto& [key, curve] : curves) {
    std::vector<Entry> row{key.first, key.second, slope_entry(curve)};
    if (const CurvePoint* const least = cheapest(curve)) {
      const CurvePoint& largest = curve.points.rbegin()->second;
      row.push_back(cost_entry(*least));
      row.push_back(number_entry(largest.nanoseconds() / least->nanoseconds(), 3));
    }
    row.resize(table.columns.size(), note_entry(missing_mark));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Returns the names and sizes [KiB] of the caches that hold data, the smallest first. They are
/// read from texts such as "L2 Unified 1024 KiB, shared by 1"; other texts are left out.
std::vector<std::pair<std::string, double>> data_caches(const Machine& machine) {
  std::vector<std::pair<std::string, double>> caches;
  for (const std::string& text : machine.caches) {
    std::istringstream words(text);
    std::string name, type, unit;
    double size = 0;
    if (words >> name >> type >> size >> unit && type != "Instruction" && unit.starts_with("KiB") &&
        size > 0)
      caches.emplace_back(name + " " + write_shortest(size) + " KiB", size);
  }
  std::ranges::stable_sort(caches, {}, [](const auto& cache) { return cache.second; });
  return caches;
}

/// Returns the data of the figure of growth: a row for each case, formulation and size.
Table growth_data(const Record& record) {
  Table table = headed_table("growth", {{"cpu", record.machine.cpu}, {"date", record.date}});
  const auto kibibytes = [](std::optional<double> bytes) {
    return number_entry(bytes ? std::optional(*bytes / 1024) : std::nullopt, 4);
  };
  table.lines = data_caches(record.machine);
  for (const auto& [key, entry] : record.growth) {
    std::vector<Entry> row{key.case_name, key.id, key.coordinates};
    if (entry.status == Status::ok) {
      const double seconds = std::ranges::min(entry.time.seconds);
      row.insert(row.end(), {step_time_entry(entry.time),
                             number_entry(1e9 * seconds / static_cast<double>(key.coordinates), 4),
                             kibibytes(entry.bytes), kibibytes(entry.state_bytes),
                             number_entry(entry.iterations_per_step, 3),
                             error_entry(entry.verification->position),
                             sentence("growth.checked", {{"precision", entry.checked_against}})});
    } else {
      row.push_back(note_entry(failed_mark));
      row.resize(9, note_entry(missing_mark));
      row.push_back(entry.message);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Shows whether growth is linear, and how the time per coordinate grows up to the largest size.
Section growth(const Record& record) {
  const Curves curves = curves_of(record.growth);
  std::size_t fitted = 0, linear = 0;
  std::optional<double> least;  // least time of a step per coordinate [ns]
  for (const auto& [key, curve] : curves) {
    if (const CurvePoint* const point = cheapest(curve))
      least = std::min(least.value_or(point->nanoseconds()), point->nanoseconds());
    if (const auto slope = Fit(curve).slope) {
      ++fitted;
      linear += is_linear(slope->value);
    }
  }
  return headed_section(
      "growth_section",
      {{"linear", linear}, {"fitted", fitted}, {"least", number_entry(least, 3).shown}},
      {growth_data(record), exponents(curves)});
}

}  // namespace

/// Moves sentences, numbers and figures of the sections to the short one, and adds excerpts of
/// their tables.
std::vector<Section> size_sections(const Record& record) {
  std::vector<Section> sections{headed_section("size")};
  const auto add = [&](Section section, const char* in_short, bool only_last_case) {
    Section& front = sections.front();
    std::ranges::move(section.paragraphs, std::back_inserter(front.paragraphs));
    std::ranges::move(section.numbers, std::back_inserter(front.numbers));
    section.paragraphs.clear();
    if (!section.tables.front().figure.empty()) {
      front.tables.push_back(std::move(section.tables.front()));
      section.tables.erase(section.tables.begin());
    }
    const Table& table = section.tables.front();
    front.tables.push_back(excerpt(table, headed_table(in_short), [&](const auto& row) {
      return !only_last_case || is_of_last_case(table, row);
    }));
    sections.push_back(std::move(section));
  };
  if (!record.growth.empty()) add(growth(record), "growth_in_short", true);
  if (!record.break_even.empty()) add(dense_or_sparse(record), "break_even_in_short", false);
  return sections;
}

}  // namespace desmo::report
