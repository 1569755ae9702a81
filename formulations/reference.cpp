#include "formulations/reference.h"

#include <Eigen/LU>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "formulations/partition.h"

namespace desmo {

namespace {

using boost::multiprecision::float128;

template <class S>
class GroupwiseSolver {
 public:
  GroupwiseSolver(const Mechanism& m, double tolerance)
      : q(m.state_size(), S(0)),
        qd(m.state_size(), S(0)),
        qdd(m.state_size(), S(0)),
        m_(m),
        parts_(make_partition(m, Partition::group)),
        tolerance_(tolerance),
        column_(m.state_size(), -1) {
    std::ranges::copy(m.estimate, q.begin());
    std::ranges::copy(m.fixed_values, q.begin() + m.coordinates());
  }

  void solve(double t) {
    for (const Driver& d : m_.drivers) {
      const int i = m_.entities[d.coordinate].first;
      const MotionSample<S> z = sample(d.motion, S(t));
      q[i] = z.position;
      qd[i] = z.velocity;
      qdd[i] = z.acceleration;
    }
    for (const PartDefinition& part : parts_) solve(part, t);
  }

  std::vector<S> q, qd, qdd;  // states

 private:
  using Vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

  void solve(const PartDefinition& part, double t) {
    const int n = static_cast<int>(part.unknowns.size());
    for (int j = 0; j < n; ++j) column_[part.unknowns[j]] = j;
    Vector phi(n), gamma(n), velocity(n), acceleration(n);
    Matrix jacobian(n, n);

    const auto set = [&](std::vector<S>& target, const Vector& x) {
      for (int j = 0; j < n; ++j) target[part.unknowns[j]] = x[j];
    };
    bool solved = false;
    for (int iteration = 0; iteration <= 50 && !solved; ++iteration) {
      evaluate(part, phi, jacobian, gamma, velocity, acceleration);
      const Eigen::PartialPivLU<Matrix> lu(jacobian);
      solved = phi.norm() < S(tolerance_);
      if (solved) {
        set(qd, lu.solve(velocity));
        // γ depends on the velocities just found.
        evaluate(part, phi, jacobian, gamma, velocity, acceleration);
        set(qdd, lu.solve(Vector(acceleration - gamma)));
      } else {
        const Vector step = lu.solve(phi);
        for (int j = 0; j < n; ++j) q[part.unknowns[j]] -= step[j];
      }
    }
    for (const int i : part.unknowns) column_[i] = -1;
    if (!solved)
      throw std::runtime_error(m_.name + ", group '" + m_.groups[part.groups.front()].name +
                               "': no reference solution at t = " + std::to_string(t) + " s");
  }

  /// Φ, Φ_φ, Φ̇_q q̇, −Φ_h ḣ and −Φ_h ḧ at the present state.
  void evaluate(const PartDefinition& part, Vector& phi, Matrix& jacobian, Vector& gamma,
                Vector& velocity, Vector& acceleration) const {
    jacobian.setZero();
    velocity.setZero();
    acceleration.setZero();
    const int n = static_cast<int>(part.equations.size());
    for (int row = 0; row < n;) {
      const int position = part.equations[row].constraint;
      const Constraint& constraint = m_.constraints[position];
      visit_kind(constraint.kind, [&]<class Kind>(Kind) {
        std::array<const S*, Kind::operand_sizes.size()> x, v;
        std::array<int, Kind::operand_sizes.size()> first;
        for (std::size_t k = 0; k < first.size(); ++k) {
          first[k] = m_.state_index(constraint.operands[k]);
          x[k] = q.data() + first[k];
          v[k] = qd.data() + first[k];
        }
        std::array<S, Kind::constants + 1> constants{};
        std::ranges::copy(constraint.constants, constants.begin());
        std::array<S, Kind::rows> all_phi, all_gamma;
        Kind::residual(x.data(), constants.data(), all_phi.data());
        Kind::quadratic(x.data(), v.data(), constants.data(), all_gamma.data());
        std::array<int, Kind::rows> place;
        place.fill(-1);
        for (; row < n && part.equations[row].constraint == position; ++row) {
          const int r = part.equations[row].row;
          place[r] = row;
          phi[row] = all_phi[r];
          gamma[row] = all_gamma[r];
        }
        Kind::jacobian(x.data(), constants.data(), [&](int r, int operand, int i, const S& value) {
          const int state = first[operand] + i;
          if (place[r] < 0) return;
          if (column_[state] >= 0) {
            jacobian(place[r], column_[state]) = value;
          } else {
            velocity[place[r]] -= value * qd[state];
            acceleration[place[r]] -= value * qdd[state];
          }
        });
      });
    }
  }

  const Mechanism& m_;
  std::vector<PartDefinition> parts_;
  double tolerance_;
  std::vector<int> column_;  // of each state component in the part at hand, or -1
};

template <class S>
ReferenceInstant rounded(const GroupwiseSolver<S>& solver, double t, int coordinates) {
  const auto round = [&](const std::vector<S>& v) {
    std::vector<double> result(coordinates);
    std::transform(v.begin(), v.begin() + coordinates, result.begin(),
                   [](const S& x) { return static_cast<double>(x); });
    return result;
  };
  return {t, round(solver.q), round(solver.qd), round(solver.qdd)};
}

}  // namespace

std::vector<ReferenceInstant> reference_solution(const Mechanism& m, std::span<const double> times,
                                                 Precision precision) {
  constexpr double longest_step = 0.01;
  GroupwiseSolver<double> walker(m, 1e-9);
  GroupwiseSolver<float128> polisher(m, 1e-28);
  std::vector<ReferenceInstant> result;
  double t = times.empty() ? 0 : times.front();
  for (const double target : times) {
    const int steps = std::max(1, static_cast<int>(std::ceil((target - t) / longest_step - 1e-9)));
    const double from = t;
    for (int i = 1; i <= steps; ++i) walker.solve(t = from + (target - from) * i / steps);
    if (precision == Precision::standard) {
      result.push_back(rounded(walker, t, m.coordinates()));
    } else {
      std::ranges::copy(walker.q, polisher.q.begin());
      polisher.solve(t);
      result.push_back(rounded(polisher, t, m.coordinates()));
    }
  }
  return result;
}

}  // namespace desmo
