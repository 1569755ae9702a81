#include "formulations/algebra/ma27_analysis.h"

#include <numeric>
#include <stdexcept>
#include <utility>

#include "formulations/algebra/coinhsl.h"

namespace desmo {

namespace {

std::vector<int> identity(int n) {
  std::vector<int> p(n);
  std::iota(p.begin(), p.end(), 0);
  return p;
}

}  // namespace

Ma27Dialogue::Ma27Dialogue() {
  coinhsl().ma27.set_defaults(icntl.data(), cntl.data());
  icntl[0] = icntl[1] = 0;
  cntl[0] = 0;
}

Ma27Analysis::Ma27Analysis(const Pattern& pattern, NormalForm form)
    : normal(pattern, form, identity(pattern.n)), order(3 * pattern.n), work(2 * pattern.n) {
  const int n = normal.n();
  for (int j = 0; j < n; ++j)
    for (int e = normal.column_start()[j]; e < normal.column_start()[j + 1]; ++e) {
      row.push_back(normal.row()[e] + 1);
      column.push_back(j + 1);
    }
  const int entries = count(row);
  std::vector<int> space(2 * (2 * row.size() + order.size()) + 1);  // twice the least
  Ma27Dialogue& d = dialogue;
  do {
    const int size = count(space);
    int order_of_its_own = 0;
    coinhsl().ma27.analyse(&n, &entries, row.data(), column.data(), space.data(), &size,
                           order.data(), work.data(), &steps, &order_of_its_own, d.icntl.data(),
                           d.cntl.data(), d.info.data(), &operations);
  } while (d.lacks_integers() && grow(space, d.may_suffice()));
  if (!d.succeeded()) throw std::invalid_argument("MA27: the Jacobian could not be analysed");
}

Ma27Analysis cheapest_ma27_analysis(const Pattern& pattern) {
  Ma27Analysis columns(pattern, NormalForm::columns), rows(pattern, NormalForm::rows);
  return rows.operations < columns.operations ? std::move(rows) : std::move(columns);
}

}  // namespace desmo
