#include "bench/cli/solve/columns.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>

#include "cases/io/input_error.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace {

constexpr const char* prefixes[] = {"", "d/dt ", "d2/dt2 "};
constexpr const char* time_name = "t";

DisplayUnit ratio_of(const DisplayUnit& a, const DisplayUnit& b) {
  const auto name = [](const DisplayUnit& unit) { return unit.name == "-" ? "1" : unit.name; };
  return {name(a) == name(b) ? "-" : name(a) + "/" + name(b), a.in_si / b.in_si};
}

/// Returns what has a column of this name: "coordinate 'C.x'", "point 'C'".
std::vector<std::string> owners_of(const std::string& name, const Mechanism& d,
                                   const std::string& remark) {
  std::vector<std::string> owners;
  if (name == time_name) owners.push_back("the time");
  if (name == remark) owners.push_back("the last column");
  const auto add = [&](const std::string& kind, const auto& list, const std::string& entity) {
    if (std::ranges::any_of(list, [&](const auto& entry) { return entry.name == entity; }))
      owners.push_back(kind + " " + desmo::in_quotes(entity));
  };
  const std::string of_component = name.substr(0, name.rfind('.'));
  add("coordinate", d.coordinates, name);
  add("point", d.points, of_component);
  add("vector", d.vectors, of_component);
  if (owners.size() < 2) owners.push_back("a rotation, joint or ratio of the request");
  return owners;
}

/// Throws InputError where two columns have one name.
void require_names_of_their_own(const std::vector<Column>& columns, const Input& input,
                                const std::string& remark) {
  std::vector<std::string_view> names{time_name, remark};
  for (const Column& c : columns)
    if (c.order == 0) names.push_back(c.name);  // those of rates follow
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  if (twice == names.end()) return;
  const std::string name(*twice);
  throw InputError(
      input.source + ": two columns have the name " + desmo::in_quotes(name) + ", those of " +
      joined(owners_of(name, input.scene.mechanism, remark), std::identity{}, " and ") +
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

std::vector<Column> make_columns(const Plan& plan, const Measures& measures, const Input& input,
                                 const std::string& remark) {
  std::vector<Column> columns;
  const Scene& scene = input.scene;
  const bool everything = scene.asks_for_everything();
  // After the outputs that are asked for come those that measures read.
  for (const Output& output :
       std::span(plan.outputs).first(everything ? plan.outputs.size() : scene.request.size()))
    if (!everything || !plan.model.is_at_rest(output.entity))
      std::ranges::copy(columns_of(plan.model, output, input.units), std::back_inserter(columns));
  std::ranges::copy(columns_of(measures, plan.model.coordinates(), input.units),
                    std::back_inserter(columns));
  require_names_of_their_own(columns, input, remark);
  return columns;
}

}  // namespace desmo::cli
