#include "report/tables/in_short.h"

#include <algorithm>
#include <functional>

#include "report/statistics/measurements.h"
#include "report/statistics/variants.h"
#include "report/tables/extremes.h"
#include "report/tables/precision.h"
#include "report/tables/size.h"

namespace desmo::report {
namespace {

using Row = std::vector<Entry>;

constexpr std::size_t max_rows = 14;

/// Some columns, in the order of the names, and the first rows of those to be kept.
struct Excerpt {
  std::string name;
  std::vector<std::string> columns;
  std::vector<std::string> notes;
  std::function<bool(const Row&)> keep = [](const Row&) { return true; };
};

Table excerpt(const Table& table, Excerpt of) {
  Table result{.name = std::move(of.name),
               .title = table.title,
               .notes = std::move(of.notes),
               .columns = {},
               .rows = {}};
  std::vector<std::size_t> places;
  for (const std::string& name : of.columns)
    if (const auto found = std::ranges::find(table.columns, name, &Column::name);
        found != table.columns.end()) {
      places.push_back(static_cast<std::size_t>(found - table.columns.begin()));
      result.columns.push_back(*found);
    }
  for (const Row& row : table.rows) {
    if (result.rows.size() == max_rows) break;
    if (!of.keep(row)) continue;
    Row& kept = result.rows.emplace_back();
    for (const std::size_t place : places) kept.push_back(row[place]);
  }
  return result;
}

/// Keeps the rows of the case that stands last: the truck, where both cases were measured.
std::function<bool(const Row&)> of_last_case(const Table& table) {
  return [name = table.rows.empty() ? std::string() : table.rows.back().front().shown](
             const Row& row) { return row.front().shown == name; };
}

/// The table of a section by its name.
Table table_of(const Section& section, std::string_view name) {
  return *std::ranges::find(section.tables, name, &Table::name);
}

Section in_short(std::string sentence, std::vector<Table> tables) {
  return {.title = "In short", .paragraphs = {std::move(sentence)}, .tables = std::move(tables)};
}

}  // namespace

Section accuracy_in_short(const Record& record) {
  const Table costs = accuracy_costs(record);
  const auto solves_every_instant = [of_case = of_last_case(costs)](const Row& row) {
    return of_case(row) && row[3].shown.find("/stride:") == std::string::npos;
  };
  return in_short(
      "An error is the largest relative position error of a motion. Each row has the cheapest "
      "configuration that solves every instant and holds it.",
      {excerpt(costs, {"accuracy_in_short",
                       {"case", "error at most", "cheapest", "µs/step",
                        "as global_automatic_klu with them"},
                       {"µs/step: the least sample – the second least. Last column: times as fast "
                        "as global_automatic_klu with the paper's guess and Jacobian at the same "
                        "error."},
                       solves_every_instant})});
}

Section tuning_in_short(const Record& record) {
  return in_short(
      "desmo tune promises an error and chooses settings; both are tried out here.",
      {excerpt(
          tuning(record).tables.front(),
          {"tuning_in_short",
           {"mechanism", "coordinates", "error at most", "measured", "promise", "times the best's"},
           {"Times the best's: the choice's µs/step over that of the fastest configuration "
            "there is that holds half of the error."}})});
}

Section size_in_short(const Record& record) {
  std::vector<Table> tables;
  if (!record.growth.empty()) {
    const Table exponents = table_of(growth(record), "growth_exponents");
    tables.push_back(
        excerpt(exponents, {"growth_in_short",
                            {"case", "id", "slope", "ns/coordinate, least", "times the least"},
                            {"A slope of 1 is linear growth. Times the least: cost of a coordinate "
                             "at the largest size, over its least."},
                            of_last_case(exponents)}));
  }
  if (!record.break_even.empty())
    tables.push_back(excerpt(dense_or_sparse(record).tables.front(),
                             {"break_even_in_short",
                              {"case", "sparse", "the faster of both", "the paper, about"},
                              {"Unknowns from which on a sparse solver is faster than the faster "
                               "of LAPACK and Eigen."}}));
  return in_short("How the time of a step grows, and from which size on sparse matrices pay.",
                  std::move(tables));
}

Section instructions_in_short(const Record& record) {
  const std::vector<Table> all = instructions(record).tables;
  const auto truck = std::ranges::find_if(all, [](const Table& table) {
    return table.name.find(variants[truck_global].case_name) != std::string::npos;
  });
  return in_short(
      "Instructions of a step, delivery included, are repeatable where times are not.",
      {excerpt(truck == all.end() ? all.front() : *truck,
               {"instructions_in_short",
                {"id", "instructions/step", "times fewer"},
                {"Times fewer: those of global_automatic_klu over these. The fewest first."}})});
}

Section extremes_in_short(const Record& record) {
  return in_short(
      "A defect is a wrong number without a flag. Counted are results: a case in a formulation "
      "each.",
      {excerpt(extreme_rows(record), {"extremes_in_short",
                                      {"row", "as expected", "missed", "DEFECT", "n/a"},
                                      {"Missed: fails, or is less exact than expected, and says "
                                       "so. n/a: not applicable, or not tried for its time."}})});
}

}  // namespace desmo::report
