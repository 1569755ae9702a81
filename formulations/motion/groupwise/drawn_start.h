#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"
#include "formulations/model/whole_turns.h"

namespace desmo {

/// Assembly of a solution at its first instant, on the branch that the model's estimate, the
/// drawing, declares. Short steps lead there. The first ones follow Newton's homotopy
/// Φ = (1 − λ) Φ(drawing), λ from 0 to 1, with the drivers as drawn. In the others, drivers move
/// linearly to their first values. A step is accepted if Newton's method contracts from its
/// prediction at once; otherwise it is halved. Solver: a solver of all positions in double, such as
/// GroupwiseSolver<double>.
template <class Solver>
class DrawnStart {
 public:
  /// drivers: their values at the first instant.
  DrawnStart(const Model& m, std::span<const double> drivers) : m_(m), solver_(m) {
    const bool turns_count = whole_turns_count(m);
    to_.assign(drivers.begin(), drivers.end());
    const std::vector<double> magnitude = nominal_magnitudes(m);
    for (std::size_t k = 0; k < to_.size(); ++k) {
      const Entity& e = m.entities[m.drivers[k].coordinate];
      drawn_.push_back(m.estimate[e.first]);
      double way = to_[k] - drawn_[k];
      if (!turns_count && e.kind == EntityKind::angle && std::abs(way) > max_turns * turn)
        way = std::remainder(way, turn);
      way_.push_back(way);
      farthest_ = std::max(farthest_, std::abs(way) / magnitude[e.first]);
    }
  }

  /// Returns the positions at the first instant; nothing where no steps lead there. Angles that are
  /// neither driven nor coupled are changed by whole turns to the values nearest to the drawing.
  std::optional<std::vector<double>> find() {
    solver_.set_homotopy(1);
    const auto solve_drawing = [&](double s) { solver_.set_homotopy(1 - s); };
    const auto move_drivers = [&](double s) {
      std::vector<double> at;
      for (std::size_t k = 0; k < way_.size(); ++k) at.push_back(drawn_[k] + s * way_[k]);
      solver_.drive(std::span<const double>(at));
    };
    if (!go(solve_drawing, 1) || !go(move_drivers, max_change / std::max(farthest_, max_change)))
      return {};
    solver_.drive(std::span<const double>(to_));
    std::vector<double> q = solver_.q();
    for (const int i : free_angles(m_)) q[i] -= turn * whole_turns(q[i] - m_.estimate[i]);
    return q;
  }

 private:
  static constexpr double turn = 2 * std::numbers::pi;
  /// Maximum change (≤) of a driver in a step, and of a coordinate by the first correction,
  /// relative to nominal magnitudes.
  static constexpr double max_change = 0.1;
  /// Maximum number of turns (≤) that a driver makes. One that is farther from its first value
  /// leaves out whole turns, unless couplings count them.
  static constexpr double max_turns = 4;
  /// Limit of the relative correction (≤) that ends an iteration.
  static constexpr double correction_tolerance = 1e-9;

  /// Returns the number of whole turns nearest to `off` [rad]. Half a turn counts as none.
  static double whole_turns(double off) { return std::round(off / turn * (1 - 0x1p-40)); }

  /// Goes from s = 0 to s = 1 in steps of at most max_step. set(s): sets equations and drivers for
  /// s. Returns whether it reaches s = 1.
  template <class Set>
  bool go(Set&& set, double max_step) {
    std::vector<double> last = solver_.q(), slope(last.size(), 0);
    double done = 0, step = max_step;
    while (done < 1) {
      if (1 + step == 1) return false;
      const double next = done + step < 1 ? done + step : 1;
      std::vector<double> predicted = last;
      for (std::size_t i = 0; i < last.size(); ++i) predicted[i] += (next - done) * slope[i];
      solver_.place(predicted);
      set(next);
      if (!contracts()) {
        step /= 2;
        continue;
      }
      const std::vector<double> q = solver_.q();
      for (std::size_t i = 0; i < q.size(); ++i) slope[i] = (q[i] - last[i]) / (next - done);
      last = q;
      done = next;
      step = std::min(2 * step, max_step);
    }
    return true;
  }

  /// Returns whether the corrections contract until one is at most
  /// correction_tolerance. The first is at most max_change, each other one at most a quarter of the
  /// one before.
  bool contracts() {
    double limit = max_change;
    try {
      while (true) {
        const double correction = solver_.correct_positions();
        if (!(correction <= limit)) return false;
        if (correction <= correction_tolerance) return true;
        limit = correction / 4;
      }
    } catch (const std::runtime_error&) {  // the Jacobian is singular
    }
    return false;
  }

  const Model& m_;
  Solver solver_;
  // of each driver: drawn value, first value, change to make
  std::vector<double> drawn_, to_, way_;
  double farthest_ = 0;  // largest |change|, relative to nominal magnitudes
};

/// Sets where Newton's method is to begin at a time [s]. solver: at the model's estimate. It stays
/// there where Newton's method leads from the estimate to the end of DrawnStart's short steps, or
/// these are blocked. Otherwise it is put at the end of the short steps.
template <class Solver>
void begin_on_drawn_branch(Solver& solver, const Model& m, double time) {
  std::vector<double> drivers;
  for (const Driver& d : m.drivers) drivers.push_back(sample(d.motion, time).position);
  const std::optional<std::vector<double>> right = DrawnStart<Solver>(m, drivers).find();
  if (!right) return;
  constexpr double same = 1e-6;  // difference (≤), relative to nominal magnitudes
  const std::vector<double> magnitude = nominal_magnitudes(m);
  try {
    Solver in_one_go(m);
    in_one_go.solve_positions(time);
    const std::vector<double> q = in_one_go.q();
    int apart = 0;
    for (int i = 0; i < m.coordinates(); ++i)
      apart += !(std::abs(q[i] - (*right)[i]) <= same * magnitude[i]);
    if (apart == 0) return;
  } catch (const std::runtime_error&) {  // it does not converge
  }
  solver.place(*right);
}

}  // namespace desmo
