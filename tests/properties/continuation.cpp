#include "tests/properties/continuation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "formulations/constraints/kind_functions.h"
#include "formulations/model/part_system.h"
#include "formulations/model/scales.h"

namespace desmo {

namespace {

constexpr double settled_correction = 1e-30;   // relative correction that only rounding leaves
constexpr double rounding_correction = 1e-32;  // likewise, for a condition number of 1
constexpr double passed = 1e11;                // condition number that only a singular position has
constexpr double max_prediction = 0.1;         // relative correction of a prediction

/// Change of a determinant's logarithm, as expected from the last step, that is a fall; and the
/// part of it that has to come true. Towards a zero a fall becomes steeper.
constexpr double fall = -0.7, part_of_fall = 0.8;

std::vector<double> doubles(const std::vector<Quadruple>& values) {
  std::vector<double> result;
  for (const Quadruple& x : values) result.push_back(static_cast<double>(x));
  return result;
}

}  // namespace

DriverPath motions_of(const Model& model) {
  return [&model](const Quadruple& t) {
    std::vector<MotionSample<Quadruple>> z;
    for (const Driver& d : model.drivers) z.push_back(sample(d.motion, t));
    return z;
  };
}

DriverPath straight_path(std::vector<Quadruple> from, std::vector<Quadruple> rate) {
  return [from = std::move(from), rate = std::move(rate)](const Quadruple& s) {
    std::vector<MotionSample<Quadruple>> z;
    for (std::size_t k = 0; k < from.size(); ++k)
      z.push_back({from[k] + s * rate[k], rate[k], Quadruple(0)});
    return z;
  };
}

Continuation::Continuation(const Model& m)
    : m_(m),
      magnitude_(nominal_magnitudes(m)),
      solver_(m),
      condition_number_(m),
      now_{0, solver_.state(), {}, 1},
      regular_(now_),
      blocks_(make_partition(m, Partition::block)) {
  for (int i = 0; i < m.coordinates(); ++i)
    far_ = std::max(far_, std::abs(m.estimate[i]) / magnitude_[i]);
  double correction = INFINITY;
  for (int i = 0; i < 100 && correction > settled_correction; ++i) {
    correction = solver_.correct_positions();
    if (!(correction < 1e6)) break;
  }
  if (!(correction < 1e-20)) throw std::runtime_error(m.name + ": no nominal position");
}

void Continuation::begin(DriverPath path, const Quadruple& parameter) {
  path_ = std::move(path);
  step_ = Quadruple(1) / 64;
  solver_.drive(path_(parameter));
  solver_.correct_positions();
  solver_.solve_rates();
  regular_ = now_ = {parameter, solver_.state(), determinants(), condition()};
  slopes_.assign(blocks_.size(), 0);
  max_condition_ = now_.condition;
}

bool Continuation::go_to(const Quadruple& target) {
  for (int tries = 0; now_.parameter != target; ++tries) {
    const Quadruple left = target - now_.parameter;
    Quadruple step = abs(left) <= step_ ? left : left > 0 ? step_ : -step_;
    if (try_step(step == left ? target : now_.parameter + step)) {
      step_ = 2 * abs(step);
    } else {
      solver_.restore(now_.state);
      step_ = abs(step) / 2;
      if (step_ < min_step || tries > max_tries) {
        step_ = Quadruple(1) / 64;
        now_ = regular_;
        slopes_.assign(blocks_.size(), 0);
        solver_.restore(now_.state);
        return false;
      }
    }
  }
  return true;
}

bool Continuation::try_step(const Quadruple& next) {
  const Quadruple step = next - now_.parameter;
  ScalarState<Quadruple> predicted = solver_.state();  // by Taylor polynomials of second degree
  for (int i = 0; i < m_.coordinates(); ++i)
    predicted.q[i] += step * (predicted.qd[i] + step / 2 * predicted.qdd[i]);
  solver_.restore(predicted);
  solver_.drive(path_(next));
  try {
    double last = solver_.correct_positions();
    if (!(last <= max_prediction)) return false;
    for (int i = 0; i < 12 && last > rounding(); ++i) {
      const double correction = solver_.correct_positions();
      if (!(correction <= std::max(last / 4, rounding()))) return false;
      last = correction;
    }
    solver_.solve_rates();
  } catch (const std::runtime_error&) {
    return false;
  }
  Determinants now = determinants();
  bool crosses = false, regular = true;
  for (std::size_t k = 0; k < now.size(); ++k) {
    crosses |= now[k].sign != now_.determinants[k].sign;
    const double change = now[k].log - now_.determinants[k].log;
    const double expected = slopes_[k] * static_cast<double>(step);
    regular &= std::abs(change) < std::log(5.0);
    regular &= !(expected < fall) || change < part_of_fall * expected;
  }
  regular &= !crosses;
  if (!regular && abs(step) > crossing_step) return false;
  if (!is_continuous(step)) return false;
  for (std::size_t k = 0; k < now.size(); ++k)
    slopes_[k] = (now[k].log - now_.determinants[k].log) / static_cast<double>(step);
  const double before = now_.condition;
  now_ = {next, solver_.state(), std::move(now), condition()};
  crosses |= before > passed && now_.condition < before / 2;
  if (crosses) crossed_at_ = next;
  crossings_ += crosses;
  max_condition_ = std::max(max_condition_, crosses ? INFINITY : now_.condition);
  if (now_.condition < passed) regular_ = now_;
  return true;
}

Continuation::Determinants Continuation::determinants() const {
  Determinants result;
  for (const PartDefinition& block : blocks_) {
    PartSystem<Quadruple> system(m_, block, solver_.state());
    result.push_back(DenseLu(std::move(system.jacobian), system.n).determinant());
  }
  return result;
}

bool Continuation::is_continuous(const Quadruple& step) const {
  double moved = 0, off = 0;
  const ScalarState<Quadruple>&last = now_.state, &now = solver_.state();
  for (int i = 0; i < m_.coordinates(); ++i) {
    const Quadruple change = now.q[i] - last.q[i];
    const Quadruple closure = change - step / 2 * (last.qd[i] + now.qd[i]);
    moved = std::max(moved, std::abs(static_cast<double>(change)) / magnitude_[i]);
    const double error = std::abs(static_cast<double>(closure)) / magnitude_[i];
    if (!(error <= off)) off = error;  // NaN stays
  }
  return off <= 0.03 * moved + 10 * rounding();
}

double Continuation::rounding() const {
  return std::clamp(far_ * rounding_correction * now_.condition, far_ * settled_correction, 1e-14);
}

WideInstant Continuation::instant() const {
  return {static_cast<double>(now_.parameter), solver_.q(), solver_.qd(), solver_.qdd()};
}

double Continuation::condition() { return condition_number_(doubles(solver_.q())); }

double Continuation::max_condition() { return std::exchange(max_condition_, condition()); }

}  // namespace desmo
