#include "formulations/constraints/kinds.h"

#include <array>

#include "formulations/constraints/kind_functions.h"

namespace desmo {

namespace {

template <class Kind>
KindDescription describe() {
  static_assert(Kind::operand_sizes.size() <= max_operands && Kind::rows <= max_rows &&
                Kind::constants <= max_constants && Kind::entries <= max_entries);
  KindDescription result{
      Kind::name, Kind::operand_sizes, Kind::constants, Kind::rows, Kind::linear, -1, {}};
  if constexpr (has_table<Kind>) result.table = Kind::table;
  // Places of entries do not depend on the values: any values serve.
  std::array<double, max_constants> any;
  any.fill(1);
  std::array<const double*, Kind::operand_sizes.size()> x;
  x.fill(any.data());
  Kind::jacobian(x.data(), any.data(), [&](int row, int operand, int component, double) {
    result.entries.push_back({row, operand, component});
  });
  return result;
}

}  // namespace

const KindDescription& description_of(int kind) {
  static const auto all = table_of_kinds([]<class Kind>(Kind) { return describe<Kind>(); });
  return all.at(kind);
}

template struct KindFunctions<double>;

}  // namespace desmo
