// Equations of overconstrained groups: others are chosen where they are clearly better.

#include "formulations/verification/branch/chosen_equations.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <vector>

#include "formulations/modelling/independence/linearisation.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/groupwise/double_solution.h"
#include "tests/overconstrained.h"

namespace desmo::chosen_equations_test {
namespace {

double last_pivot(const Eigen::MatrixXd& rows) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows.transpose());
  return std::abs(qr.matrixQR()(rows.cols() - 1, rows.cols() - 1));
}

/// Returns by how much the smallest pivot of all equations of a mechanism's largest group is more
/// than that of the equations that are kept.
double gain(const Model& m, const std::vector<double>& q) {
  const std::vector<double> state = m.state_of(q);
  Lineariser lineariser(m);
  double most = 0;
  for (const GroupSystem& s : group_systems(m)) {
    if (s.unknowns == 0) continue;
    const Eigen::MatrixXd all = lineariser.at(state, s).jacobian.leftCols(s.unknowns);
    std::vector<int> kept;
    for (int i = 0; i < all.rows(); ++i)
      if (!(m.constraints[s.rows[i].first].left_out >> s.rows[i].second & 1)) kept.push_back(i);
    if (static_cast<int>(kept.size()) < all.rows())
      most = std::max(most, last_pivot(all) / last_pivot(all(kept, Eigen::all)));
  }
  return most;
}

/// Others that are better by 1.5 are chosen, those that are hardly better are not: a path would
/// begin anew with them, and lead no farther.
TEST(ChosenEquations, AreClearlyBetter) {
  int chosen = 0, kept = 0;
  const Model m = make_model(bennett(0.8L, 17));
  std::vector<double> times;
  for (int i = 0; i < 120; ++i) times.push_back(i * 0.02);
  for (const ReferenceInstant& s : double_solution(m, times)) {
    const double better = gain(m, s.q);
    const bool is_chosen = with_chosen_equations(m, s.q) != nullptr;
    EXPECT_EQ(is_chosen, better > 1.5) << s.time << ": " << better;
    chosen += better > 2 && better < 10;
    kept += better < 1.2;
  }
  EXPECT_GT(chosen, 0);
  EXPECT_GT(kept, 0);
}

}  // namespace
}  // namespace desmo::chosen_equations_test
