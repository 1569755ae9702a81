#include "bench/cli/solve/columns.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <span>

#include "cases/io/input_error.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace {

constexpr const char* prefixes[] = {"", "d/dt ", "d2/dt2 "};

DisplayUnit ratio_of(const DisplayUnit& a, const DisplayUnit& b) {
  const auto name = [](const DisplayUnit& unit) { return unit.name == "-" ? "1" : unit.name; };
  return {name(a) == name(b) ? "-" : name(a) + "/" + name(b), a.in_si / b.in_si};
}

/// Returns what has a column of this name: "coordinate 'C.x'", "point 'C'".
std::vector<std::string> owners_of(const std::string& name, const Mechanism& mechanism) {
  std::vector<std::string> owners;
  const auto add = [&](const std::string& kind, const auto& list, const std::string& entity) {
    if (std::ranges::any_of(list, [&](const auto& entry) { return entry.name == entity; }))
      owners.push_back(kind + " " + desmo::in_quotes(entity));
  };
  const std::string of_component = name.substr(0, name.rfind('.'));
  add("coordinate", mechanism.coordinates, name);
  add("point", mechanism.points, of_component);
  add("vector", mechanism.vectors, of_component);
  if (owners.size() < 2) owners.push_back("a rotation, joint or ratio of the request");
  return owners;
}

/// Throws InputError where two columns have one heading.
void require_headings_of_their_own(const std::vector<Column>& columns, const Input& input) {
  std::map<std::string, std::string> names;  // the name of a column, by its heading
  for (const Column& c : columns)
    // Headings of rates are equal where those of order 0 are.
    if (c.order == 0 && !names.emplace(c.heading(), c.name).second)
      throw InputError(input.source + ": two columns are headed " + desmo::in_quotes(c.heading()) +
                       ", those of " +
                       joined(owners_of(c.name, input.scene.mechanism), std::identity{}, " and ") +
                       "; rename one of them, or leave it out of the request");
}

}  // namespace

std::vector<Column> columns_of(const Model& m, const Output& output, const DisplayUnits& units) {
  std::vector<Column> columns;
  const Entity& e = m.entities[output.entity];
  for (int order = 0; order <= static_cast<int>(output.level); ++order) {
    const auto level = static_cast<Level>(order);
    for (int i = e.first; i < e.first + e.size; ++i) {
      Column& column = columns.emplace_back();
      column.name = prefixes[order] + coordinate_name(m, output.entity, i);
      column.unit = unit_of(units, e.kind, level);
      column.level = level;
      column.order = order;
      if (!e.fixed)
        column.coordinate = i;
      else if (order == 0)
        column.constant = m.fixed_values[i];
    }
  }
  return columns;
}

std::vector<Column> columns_of(const Measures& measures, int coordinates,
                               const DisplayUnits& units) {
  std::vector<Column> columns;
  for (const Measure& measure : measures.list()) {
    for (const Level level : all_levels) {
      const std::string& name = measure.names[level];
      if (name.empty()) continue;
      Column& column = columns.emplace_back();
      column.name = name;
      column.unit = measure.per
                        ? ratio_of(unit_of(units, measure.kind), unit_of(units, *measure.per))
                        : unit_of(units, measure.kind, level);
      column.level = level;
      column.order = name.starts_with(prefixes[1]) ? 1 : name.starts_with(prefixes[2]) ? 2 : 0;
      column.coordinate = coordinates;
      column.may_lack = measure.per.has_value();
    }
    ++coordinates;
  }
  return columns;
}

std::vector<Column> make_columns(const Plan& plan, const Measures& measures, const Input& input) {
  std::vector<Column> columns;
  const Scene& scene = input.scene;
  const bool everything = scene.asks_for_everything();
  // The plan's outputs are those asked for, followed by those that measures read.
  for (const Output& output :
       std::span(plan.outputs).first(everything ? plan.outputs.size() : scene.request.size()))
    if (!everything || !plan.model.is_at_rest(output.entity))
      std::ranges::copy(columns_of(plan.model, output, input.units), std::back_inserter(columns));
  std::ranges::copy(columns_of(measures, plan.model.coordinates(), input.units),
                    std::back_inserter(columns));
  require_headings_of_their_own(columns, input);
  return columns;
}

}  // namespace desmo::cli
