#include "bench/peers/tree/axle.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/peers/tree/nominal.h"
#include "formulations/base/settings.h"

namespace desmo::tree {

namespace {

const Vec vertical = Vec::UnitZ();

/// Return e_y × a and e_z × a.
Vec about_lateral(const Vec& a) { return {a.z(), 0, -a.x()}; }
Vec about_vertical(const Vec& a) { return {-a.y(), a.x(), 0}; }

}  // namespace

/// The part of the heights of the wheels that depends on neither ψ nor θ.
struct Axle::Roll {
  Moving<double> sine, cosine;  // sin ρ and cos ρ
  double rate, second_rate;     // ρ̇ and ρ̈
  /// The height of S is base + cos ρ m(θ) with m = w_x sin θ − w_z cos θ and w = left_.
  Moving<double> base;
};

/// Quantities of the axle at given ψ and θ, and its closure equations g of the two rods.
struct Axle::Closure {
  double m, m_pitch;          // m(θ) and its derivative
  Vec roll_axis;              // Rz(ψ) e_x
  Vec s, x, y, z;             // S and the axle's frame
  Vec arm;                    // S − R
  Vec rise;                   // ∂S/∂(height of S), as S moves on a circle about R
  double pitch_lift;          // ∂(height of S)/∂θ, so that ∂S/∂θ = pitch_lift · rise
  std::array<Vec, 2> r, rod;  // C − S, C − G
  Eigen::Vector2d g;          // (‖C − G‖² − L²)/2 of each rod
  Eigen::Matrix2d jacobian;   // ∂g/∂(ψ, θ)
  double error;               // √Σ (gᵢ/Lᵢ²)²
};

Axle::Axle(const Mechanism& mechanism, const std::string& prefix, double tolerance)
    : prefix_(prefix), tolerance_(tolerance) {
  const auto at = [&](const char* name) { return nominal(mechanism, prefix + name); };
  const Vec s = at("S");
  pivot_ = at("R");
  arm_ = std::copysign((s - pivot_).norm(), s.x() - pivot_.x());
  left_ = at("WL") - s;
  right_ = at("WR") - s;
  track_ = left_.y() - right_.y();
  for (int i = 0; i < 2; ++i) {
    const std::string side = i == 0 ? "4" : "5";
    const Vec c = nominal(mechanism, prefix + "C" + side),
              g = nominal(mechanism, prefix + "G" + side);
    rods_[i] = {c - s, g, (c - g).norm()};
  }
}

/// Solves zL − zR = track sin ρ, and its first and second derivatives, for ρ.
Axle::Roll Axle::roll(const Moving<double>& left, const Moving<double>& right) const {
  Roll roll;
  roll.sine = (1 / track_) * (left - right);
  const auto& [s, s1, s2] = roll.sine;
  const double c = std::sqrt(1 - s * s);
  if (!(c > 0))
    throw std::runtime_error(prefix_ +
                             "2: the heights of its wheels differ by more than its track");
  const double c1 = -s * s1 / c;
  roll.cosine = {c, c1, -(s1 * s1 + c1 * c1 + s * s2) / c};
  roll.rate = s1 / c;
  roll.second_rate = (s2 - c1 * roll.rate) / c;
  roll.base = left - left_.y() * roll.sine;
  return roll;
}

Axle::Closure Axle::closure(const Angles& angles, const Roll& roll) const {
  Closure at;
  const double cy = std::cos(angles.q[0]), sy = std::sin(angles.q[0]);  // ψ
  const double cp = std::cos(angles.q[1]), sp = std::sin(angles.q[1]);  // θ
  const double cr = roll.cosine.q, sr = roll.sine.q;
  at.roll_axis = {cy, sy, 0};
  at.x = {cy * cp - sy * sr * sp, sy * cp + cy * sr * sp, -cr * sp};
  at.y = {-sy * cr, cy * cr, sr};
  at.z = {cy * sp + sy * sr * cp, sy * sp - cy * sr * cp, cr * cp};

  at.m = left_.x() * sp - left_.z() * cp;
  at.m_pitch = left_.x() * cp + left_.z() * sp;
  const double dz = roll.base.q + cr * at.m - pivot_.z();
  const double dx = std::copysign(std::sqrt(arm_ * arm_ - dz * dz), arm_);
  at.arm = {dx, 0, dz};
  at.s = pivot_ + at.arm;
  at.rise = {-dz / dx, 0, 1};
  at.pitch_lift = cr * at.m_pitch;

  double error2 = 0;
  for (int i = 0; i < 2; ++i) {
    const auto& [c, g, length] = rods_[i];
    const Vec& r = at.r[i] = c.x() * at.x + c.y() * at.y + c.z() * at.z;
    const Vec& v = at.rod[i] = at.s + r - g;
    const double length2 = length * length, relative = 0.5 * (v.squaredNorm() / length2 - 1);
    at.g[i] = length2 * relative;
    error2 += relative * relative;
    at.jacobian(i, 0) = v.y() * r.x() - v.x() * r.y();
    at.jacobian(i, 1) = v.dot(at.pitch_lift * at.rise + at.y.cross(r));
  }
  at.error = std::sqrt(error2);
  return at;
}

int Axle::solve(const Moving<double>& left, const Moving<double>& right, const Angles& angles) {
  left_height_ = left;
  right_height_ = right;
  const Roll roll = this->roll(left, right);
  constexpr int max_iterations = Settings{}.max_iterations;
  for (int iterations = 0;; ++iterations) {
    const Closure at = closure(angles, roll);
    if (at.error < tolerance_) {
      solve_rates(at, roll, angles);
      return iterations;
    }
    if (!std::isfinite(at.error))
      throw std::runtime_error(prefix_ + "2: its arm cannot reach the heights of its wheels");
    if (iterations == max_iterations)
      throw std::runtime_error(prefix_ + "2: its rods are not closed in " +
                               std::to_string(iterations) + " iterations");
    const Eigen::Vector2d correction = at.jacobian.inverse() * at.g;
    angles.q[0] -= correction[0];
    angles.q[1] -= correction[1];
  }
}

/// Solves (C−G)·v = 0 and (C−G)·a + v·v = 0 of both rods for ψ̇, θ̇ and ψ̈, θ̈. v and a are velocity
/// and acceleration of C. Terms without these unknowns (`known_…`) are on the right-hand side.
void Axle::solve_rates(const Closure& at, const Roll& roll, const Angles& angles) {
  const Eigen::Matrix2d inverse = at.jacobian.inverse();
  Eigen::Vector2d b;
  const Vec known_turn = roll.rate * at.roll_axis;
  const double known_climb = roll.base.qd + roll.cosine.qd * at.m;
  for (int i = 0; i < 2; ++i)
    b[i] = -at.rod[i].dot(known_climb * at.rise + known_turn.cross(at.r[i]));
  const Eigen::Vector2d rate = inverse * b;
  const double yaw = rate[0], pitch = rate[1];

  const Vec w = yaw * vertical + known_turn + pitch * at.y;  // ω
  const Vec s1 = (known_climb + at.pitch_lift * pitch) * at.rise;
  const Vec y1 = w.cross(at.y);
  const Vec known_w1 =
      roll.second_rate * at.roll_axis + roll.rate * yaw * about_vertical(at.roll_axis) + pitch * y1;
  const double known_climb1 = roll.base.qdd + roll.cosine.qdd * at.m +
                              2 * roll.cosine.qd * at.m_pitch * pitch -
                              roll.cosine.q * at.m * pitch * pitch;
  // S stays on its circle: (S−R)·S̈ = −Ṡ².
  const Vec known_s2 = known_climb1 * at.rise - Vec(s1.squaredNorm() / at.arm.x(), 0, 0);
  for (int i = 0; i < 2; ++i) {
    const Vec turning = w.cross(at.r[i]), v = s1 + turning;
    b[i] = -v.squaredNorm() - at.rod[i].dot(known_s2 + known_w1.cross(at.r[i]) + w.cross(turning));
  }
  const Eigen::Vector2d second_rate = inverse * b;

  const Vec w1 = known_w1 + second_rate[0] * vertical + second_rate[1] * at.y;  // ω̇
  const auto fixed = [&](const Vec& a) -> Moving<Vec> {
    const Vec turning = w.cross(a);
    return {a, turning, w1.cross(a) + w.cross(turning)};
  };
  pose_ = {{at.s, s1, known_s2 + at.pitch_lift * second_rate[1] * at.rise},
           fixed(at.x),
           fixed(at.y),
           fixed(at.z)};
  std::copy_n(rate.data(), 2, angles.qd.begin());
  std::copy_n(second_rate.data(), 2, angles.qdd.begin());
}

std::vector<std::string> Axle::delivered(const std::string& prefix) {
  std::vector<std::string> names;
  for (const char* name :
       {"WL", "WR", "S", "x2", "y2", "z2", "n3", "C4", "u4", "n4", "C5", "u5", "n5", "zL", "zR"})
    names.push_back(prefix + name);
  return names;
}

void Axle::deliver(AnswerWriter& out) const {
  const auto& [s, x, y, z] = pose_;
  out.put(pose_.at(left_));
  out.put(pose_.at(right_));
  out.put(s);
  out.put(x);
  out.put(y);
  out.put(z);
  const double per_length = 1 / std::abs(arm_);
  const Moving<Vec> arm = s - pivot_;
  out.put(per_length *
          Moving<Vec>{about_lateral(arm.q), about_lateral(arm.qd), about_lateral(arm.qdd)});
  for (int i = 0; i < 2; ++i) {
    const auto& [c, g, length] = rods_[i];
    const Moving<Vec> end = pose_.at(c), rod = end - g, u = unit(cross(i == 0 ? z : y, rod));
    out.put(end);
    out.put(u);
    out.put((1 / length) * cross(rod, u));
  }
  out.put(left_height_);
  out.put(right_height_);
}

}  // namespace desmo::tree
