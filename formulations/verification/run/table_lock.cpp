#include "formulations/verification/run/table_lock.h"

#include "formulations/constraints/constraints.h"

namespace desmo {

namespace {

/// A motion ends at the end of a table where it was followed to within this of it, over the length
/// of the table. Paths come nearer; at an extremum, they stop some 1e-8 before.
constexpr double end_margin = 1e-6;

}  // namespace

std::optional<TableLock> find_table_lock(const Model& m, int constraint,
                                         std::span<const double> followed_to) {
  if (constraint < 0 || followed_to.empty()) return {};
  const Constraint& c = m.constraints[constraint];
  const EntityId argument = c.operands.back();
  if (c.kind != kind_index<TableCoupling>() || m.entities[argument].fixed) return {};
  const double value = followed_to[m.entities[argument].first], at = c.constants[1] * value;
  const double* const table = c.constants.data() + TableCoupling::table;
  const double first = table[3], last = table[3 + static_cast<int>(table[0])];
  const double margin = end_margin * (last - first);
  const bool is_inside = table[1] != 0 || (at > first + margin && at < last - margin);
  return is_inside ? std::optional(TableLock{argument, value}) : std::nullopt;
}

}  // namespace desmo
