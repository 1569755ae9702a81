#include "bench/cli/solve/columns.h"

#include <algorithm>
#include <iterator>

namespace desmo::cli {
namespace {

constexpr const char* prefixes[] = {"", "d/dt ", "d2/dt2 "};

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
      if (!e.fixed)
        column.coordinate = i;
      else if (order == 0)
        column.constant = m.fixed_values[i];
    }
  }
  return columns;
}

std::vector<Column> make_columns(const Plan& plan, const Scene& scene, const DisplayUnits& units) {
  std::vector<Column> columns;
  for (const Output& output : plan.outputs)
    if (!scene.request.empty() || !plan.model.is_at_rest(output.entity))
      std::ranges::copy(columns_of(plan.model, output, units), std::back_inserter(columns));
  return columns;
}

}  // namespace desmo::cli
