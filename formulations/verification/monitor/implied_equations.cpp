#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/monitor/branch_monitor.h"

namespace desmo {

namespace {

template <class Kind>
constexpr int values_of() {
  int values = 0;
  for (const int size : Kind::operand_sizes) values += size;
  return values;
}

/// The most of any kind, so that nothing here needs the heap.
constexpr std::pair<int, int> most = []<class... Kinds>(const std::tuple<Kinds...>*) {
  return std::pair(std::max({Kinds::rows...}), std::max({values_of<Kinds>()...}));
}(static_cast<const ConstraintKinds*>(nullptr));
constexpr int max_rows = most.first, max_values = most.second;
using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_values, 1>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_rows, 1>;
using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_rows, max_values>;
using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_rows, max_rows>;

struct Linearised {
  Rows phi;
  Jacobian jacobian;
};

/// Evaluates a constraint whose operands begin at `first` in the values.
Linearised linearise(const Constraint& constraint, const std::vector<int>& first, const Values& x) {
  Linearised result;
  visit_kind(constraint.kind, [&]<class Kind>(Kind) {
    std::array<const double*, Kind::operand_sizes.size()> operands;
    for (std::size_t k = 0; k < operands.size(); ++k) operands[k] = x.data() + first[k];
    std::array<double, Kind::rows> phi;
    Kind::residual(operands.data(), constraint.constants.data(), phi.data());
    result.phi = Eigen::Map<const Eigen::VectorXd>(phi.data(), Kind::rows);
    result.jacobian.setZero(Kind::rows, x.size());
    Kind::jacobian(operands.data(), constraint.constants.data(),
                   [&](int row, int operand, int i, double value) {
                     result.jacobian(row, first[operand] + i) += value;
                   });
  });
  return result;
}

/// The sum of the terms of each equation.
Rows sizes(const Linearised& at, const Values& x) { return at.jacobian.cwiseAbs() * x.cwiseAbs(); }

/// Moves x to a solution near it, by least corrections. Returns whether it is one.
bool solve(const Constraint& constraint, const std::vector<int>& first, Values& x) {
  constexpr int max_iterations = 30;
  constexpr double solved = 1e-12;
  for (int i = 0; i < max_iterations; ++i) {
    const Linearised at = linearise(constraint, first, x);
    if ((at.phi.cwiseAbs() - solved * sizes(at, x)).maxCoeff() <= 0) return true;
    const Gram gram = at.jacobian * at.jacobian.transpose();
    x -= at.jacobian.transpose() * gram.ldlt().solve(at.phi);
  }
  return false;
}

std::vector<EntityId> sorted(std::vector<EntityId> ids) {
  std::ranges::sort(ids);
  return ids;
}

/// Operands of one constraint among the values of another.
class Implication {
 public:
  Implication(const Model& m, const Constraint& kept) : kept_(kept) {
    for (const EntityId e : kept.operands) {
      first_.push_back(count_);
      count_ += m.entities[e].size;
    }
    estimate_.resize(count_);
    scale_.setOnes(count_);
    const double* point = nullptr;
    double size = 0;  // distance of points in any direction
    for (std::size_t k = 0; k < first_.size(); ++k) {
      const Entity& e = m.entities[kept.operands[k]];
      double* const values = estimate_.data() + first_[k];
      std::copy_n((e.fixed ? m.fixed_values : m.estimate).data() + e.first, e.size, values);
      if (e.kind == EntityKind::distance) size = std::max(size, std::abs(*values));
      if (e.kind != EntityKind::point) continue;
      if (point == nullptr) point = values;
      for (int i = 0; i < e.size; ++i) size = std::max(size, std::abs(values[i] - point[i]));
    }
    for (std::size_t k = 0; k < first_.size() && size > 0; ++k)
      if (const Entity& e = m.entities[kept.operands[k]]; is_length(e.kind))
        scale_.segment(first_[k], e.size).setConstant(size);
  }

  bool holds(const Constraint& left_out) const {
    constexpr int positions = 3;
    std::vector<int> first;
    for (const EntityId e : left_out.operands)
      first.push_back(first_[std::ranges::find(kept_.operands, e) - kept_.operands.begin()]);
    unsigned bits = 0;  // of no pattern
    for (int i = 0; i < positions; ++i) {
      Values x = draw(bits);
      if (!solve(kept_, first_, x) || !is_satisfied(left_out, first, x)) return false;
    }
    return true;
  }

 private:
  /// Returns a position about as far from the estimate as its points are from each other.
  Values draw(unsigned& bits) const {
    Values x = estimate_;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      bits += 2654435769u;
      x[i] += scale_[i] * (bits * 0x1p-31 - 1);
    }
    return x;
  }

  static bool is_satisfied(const Constraint& c, const std::vector<int>& first, const Values& x) {
    constexpr double satisfied = 1e-10;
    const Linearised at = linearise(c, first, x);
    const Rows size = sizes(at, x);
    for (int r = 0; r < rows(c); ++r)
      if (c.left_out >> r & 1 && !(std::abs(at.phi[r]) <= satisfied * size[r])) return false;
    return true;
  }

  const Constraint& kept_;
  std::vector<int> first_;
  int count_ = 0;
  Values estimate_, scale_;
};

}  // namespace

bool is_implied(const Model& m, const Constraint& constraint) {
  const auto group =
      std::ranges::equal_range(m.constraints, constraint.group, {}, &Constraint::group);
  return std::ranges::any_of(group, [&](const Constraint& kept) {
    return kept.left_out == 0 &&
           std::ranges::includes(sorted(kept.operands), sorted(constraint.operands)) &&
           Implication(m, kept).holds(constraint);
  });
}

}  // namespace desmo
