#include "formulations/verification/certificate/group_interface.h"

#include <cmath>

namespace desmo {

void GroupInterface::enclose(std::span<const Level> solved, const PerLevel<ErrorTable>& errors) {
  enclosed = !solved.empty();
  for (const Level level : solved)
    for (const int row : rows) enclosed = enclosed && std::isfinite(errors[level].rows[row].sum);
  if (!enclosed) return;
  basis.start(static_cast<int>(solved.size()) * size(), errors.position.columns);
  for (const Level level : solved)
    for (int i = 0; i < size(); ++i) {
      const ErrorTable& e = errors[level];
      const ErrorTable::Row& row = e.rows[rows[i]];
      centre[level][i] = row.centre;
      basis.set(static_cast<int>(level) * size() + i, e.of_row(rows[i]), row.own);
    }
  basis.enclose();
}

void GroupInterface::lend(Level level, int row, int column, ErrorTable& to) const {
  for (int i = 0; i < size(); ++i) {
    to.lend(row + i, to.rows[coordinates[i]]);
    if (!enclosed) continue;
    const std::span symbols(to.of_row(row + i) + column, basis.size());
    for (int s = 0; s < basis.size(); ++s)
      symbols[s] = basis.generator(static_cast<int>(level) * size() + i, s);
    to.rows[row + i].set_error(centre[level][i], symbols);
  }
}

}  // namespace desmo
