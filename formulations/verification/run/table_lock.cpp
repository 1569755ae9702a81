#include "formulations/verification/run/table_lock.h"

#include <algorithm>
#include <cmath>

#include "formulations/constraints/constraints.h"
#include "formulations/constraints/table.h"

namespace desmo {

std::optional<TableLock> find_table_lock(const Model& m, int constraint,
                                         std::span<const double> followed_to) {
  if (constraint < 0 || followed_to.empty()) return {};
  const Constraint& c = m.constraints[constraint];
  const EntityId argument = c.operands.back();
  if (c.kind != kind_index<TableCoupling>() || m.entities[argument].fixed) return {};
  const double value = followed_to[m.entities[argument].first], at = c.constants[1].value * value;
  const auto table = [&c](int k) { return c.constants[TableCoupling::table + k].value; };
  const double to_end = std::min(at - table(3), table(3 + static_cast<int>(table(0))) - at);
  const double slope = table_number<1>(table, at), curvature = 2 * table_number<2>(table, at);
  const double to_extremum = std::abs(slope / curvature);  // one step of Newton's method
  const bool locks = table(1) != 0 || to_extremum < to_end;
  return locks ? std::optional(TableLock{argument, value}) : std::nullopt;
}

}  // namespace desmo
