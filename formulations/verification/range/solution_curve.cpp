#include "formulations/verification/range/solution_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formulations/model/characteristic_lengths.h"
#include "formulations/motion/groupwise/stopping_rule.h"

namespace desmo {

namespace {

/// Factor of the border, the last row of B, which is dense. Being small it is the last choice of a
/// pivot: as an early one it would fill the factors.
constexpr double border_scale = 1e-3;

/// Returns a border that is at right angles to hardly any curve. Another shift gives another one.
Eigen::VectorXd any_direction(int n, double shift) {
  Eigen::VectorXd v(n);
  for (int i = 0; i < n; ++i) v[i] = std::cos(1 + shift + 2.4 * i);
  return v.normalized();
}

Eigen::VectorXd scaled_to_one(Eigen::VectorXd v) { return v / v.cwiseAbs().maxCoeff(); }

}  // namespace

SolutionCurve::SolutionCurve(const Model& m, int driver, const RangeLimits& limits)
    : limits_(limits),
      system_(m),
      driver_(m.entities[m.drivers[driver].coordinate].first),
      column_(m.state_size(), -1),
      row_(system_.rows(), -1),
      constraints_(m.constraints.size()),
      phi_(system_.rows()) {
  std::vector<std::vector<int>> rows_of;  // in the whole system, of each constraint; −1: left out
  int row = 0;
  for (const Constraint& c : m.constraints) {
    std::vector<int>& rows = rows_of.emplace_back();
    for (int r = 0; r < desmo::rows(c); ++r) rows.push_back(c.left_out >> r & 1 ? -1 : row++);
  }
  std::vector<bool> moves(m.state_size(), false);
  moves[driver_] = true;
  for (PartDefinition& block : make_partition(m, Partition::block)) {
    const std::vector<int> read = states_read(m, block);
    if (std::ranges::none_of(read, [&](int i) { return moves[i]; })) continue;
    for (const int i : block.unknowns) moves[i] = true;
    unknowns_.insert(unknowns_.end(), block.unknowns.begin(), block.unknowns.end());
    for (const Equation& e : block.equations) {
      row_[rows_of[e.constraint][e.row]] = static_cast<int>(constraint_.size());
      constraint_.push_back(e.constraint);
    }
    blocks_.push_back(std::move(block));
  }
  std::ranges::sort(unknowns_);
  const std::vector<double> magnitude = CharacteristicLengths(m).of_coordinates();
  for (int j = 0; j < size(); ++j) {
    column_[unknowns_[j]] = j;
    scale_.push_back(magnitude[unknowns_[j]]);
  }
  column_[driver_] = size();
  scale_.push_back(magnitude[driver_]);
  row_sums_.resize(size());
}

bool SolutionCurve::factor(std::span<const double> state, const Eigen::VectorXd& border) {
  entries_.clear();
  row_sums_.setZero();
  system_.jacobian<double>(state, [&](int row, int i, double value) {
    if (row_[row] < 0 || column_[i] < 0) return;
    value *= scale_[column_[i]];
    row_sums_[row_[row]] += std::abs(value);
    entries_.emplace_back(row_[row], column_[i], value);
  });
  row_sums_ = (row_sums_.array() > 0).select(row_sums_, 1.0);
  for (Eigen::Triplet<double>& e : entries_) e = {e.row(), e.col(), e.value() / row_sums_[e.row()]};
  for (int j = 0; j <= size(); ++j) entries_.emplace_back(size(), j, border_scale * border[j]);
  matrix_.resize(size() + 1, size() + 1);
  matrix_.setFromTriplets(entries_.begin(), entries_.end());
  if (!is_analysed_) lu_.analyzePattern(matrix_);
  is_analysed_ = true;
  lu_.factorize(matrix_);
  return lu_.info() == Eigen::Success;
}

/// Adds a factor times a scaled change of the unknowns and the driver to a state.
void SolutionCurve::move(std::vector<double>& state, double factor,
                         const Eigen::VectorXd& change) const {
  for (int j = 0; j < size(); ++j) state[unknowns_[j]] += factor * scale_[j] * change[j];
  state[driver_] += factor * scale_.back() * change[size()];
}

/// Solves Φ = 0 in the plane through the state at right angles to the border. Fails if the first
/// correction is larger than `max_first`, or a later one larger than half of the one before.
bool SolutionCurve::correct(std::vector<double>& state, const Eigen::VectorXd& border,
                            double max_first) {
  StoppingRule<double> stops_after;
  for (double max = max_first; factor(state, border);) {
    system_.residual<double>(state, phi_);
    Eigen::VectorXd change = Eigen::VectorXd::Zero(size() + 1);
    for (std::size_t r = 0; r < row_.size(); ++r)
      if (row_[r] >= 0) change[row_[r]] = phi_[r] / row_sums_[row_[r]];
    change = lu_.solve(change).eval();
    move(state, -1, change);
    const double largest = change.cwiseAbs().maxCoeff();
    if (!std::isfinite(largest)) return false;
    if (stops_after(largest)) return true;
    if (largest > max) return false;
    max = largest / 2;
  }
  return false;
}

/// Returns the point of a solved state. The tangent is oriented along a direction.
std::optional<SolutionCurve::Point> SolutionCurve::settle(std::vector<double> state,
                                                          const Eigen::VectorXd& along) {
  Eigen::VectorXd tangent = along;
  for (int pass = 0; pass < 2; ++pass) {  // the second with the tangent as border, for det B
    if (!factor(state, tangent)) return {};
    tangent = scaled_to_one(lu_.solve(along_driver()));
    if (!tangent.allFinite()) return {};
  }
  const int sign = lu_.signDeterminant() > 0 ? 1 : -1;
  const double log = lu_.logAbsDeterminant() + row_sums_.array().log().sum();
  return Point{std::move(state), std::move(tangent), sign, log};
}

std::optional<SolutionCurve::Point> SolutionCurve::start(std::vector<double> state) {
  crosses_ = false;
  const double value = state[driver_];
  std::optional<Point> point = settle(state, any_direction(size() + 1, 0));
  const std::optional<Point> other = settle(state, any_direction(size() + 1, 1));
  if (!point || !other) {
    crosses_ = true;
    return {};
  }
  // At a regular point both borders give the same tangent. Two tangents mean a crossing.
  const Eigen::VectorXd a = point->tangent.normalized(), b = other->tangent.normalized();
  crosses_ = (a - a.dot(b) * b).norm() > half_digits;
  if (crosses_) return point;
  if (!correct(state, point->tangent, limits_.max_step)) return {};
  point = settle(std::move(state), point->tangent);
  // Next to a dead point there may be no position with exactly this value of the driver.
  if (std::optional<Point> exact = point ? at(*point, value) : point) point = std::move(exact);
  if (point && point->speed() < 0) *point = reversed(*std::move(point));
  return point;
}

std::optional<SolutionCurve::Point> SolutionCurve::step(const Point& from, double length) {
  std::vector<double> state = from.state;
  move(state, length, from.tangent);
  if (!correct(state, from.tangent, limits_.max_correction * std::abs(length))) return {};
  std::optional<Point> point = settle(std::move(state), from.tangent);
  // Next to a crossing, rounding may turn the tangent to another branch without a correction.
  const double max_turn = 2 * limits_.max_correction;
  if (point && !((point->tangent - from.tangent).cwiseAbs().maxCoeff() <= max_turn)) return {};
  return point;
}

std::optional<SolutionCurve::Point> SolutionCurve::at(const Point& from, double value) {
  std::vector<double> state = from.state;
  const double change = (value - state[driver_]) / scale();
  move(state, change / from.speed(), from.tangent);
  state[driver_] = value;
  if (!correct(state, along_driver(), limits_.max_step)) return {};
  state[driver_] = value;
  return settle(std::move(state), from.tangent);
}

SolutionCurve::Point SolutionCurve::reversed(Point point) {
  point.tangent = -point.tangent;
  point.sign = -point.sign;
  return point;
}

SolutionCurve::Forces SolutionCurve::forces(const Point& point) {
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();  // of rows over sums
  Forces result{std::vector<double>(constraints_, 0), std::numeric_limits<double>::infinity()};
  if (!factor(point.state, point.tangent)) return result;
  const Eigen::VectorXd left = lu_.transpose().solve(along_driver()).head(size());
  for (int r = 0; r < size(); ++r) {
    double& force = result.of_constraints[constraint_[r]];
    force = std::max(force, std::abs(left[r]));
  }
  result.rounding = roundings * left.lpNorm<1>() * scale();
  const double largest = left.lpNorm<Eigen::Infinity>();
  for (double& force : result.of_constraints) force /= largest > 0 ? largest : 1;
  return result;
}

}  // namespace desmo
