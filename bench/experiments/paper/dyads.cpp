// desmo_dyads: CPU time per dyad and step of the four-bar chain with 558 coordinates, by a closed
// form written by hand for this chain alone and by formulations that know nothing of it,
// interleaved. The hand-written one checks nothing; that all agree is checked before anything is
// timed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/kit/cpu_clock.h"
#include "cases/cases.h"
#include "formulations/equations/elementary.h"
#include "formulations/modelling/model.h"
#include "formulations/variants.h"

namespace {

using namespace desmo;

constexpr int dyads = 185, steps = 3000, rounds = 15;
constexpr double step = 0.01;

/// The angle that differs by whole turns and is nearest to that before.
double near(double angle, double before) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle + turn * std::nearbyint((before - angle) * (1 / turn));
}

/// q, q̇, q̈ in the order of coordinates of the case: θ, B, then C and ψ of each dyad.
class ByHand {
 public:
  void solve(double t) {
    const double theta = std::numbers::pi / 3 + t, c = 2 * std::cos(theta), s = 2 * std::sin(theta);
    Point b{c, s, -s, c, -c, -s};
    for (int k = 0; k < dyads; ++k) {
      const double pivot = 6.0 * (k + 1);
      // Two circles of radius 6: C − B = a/2 + h a⊥ with a = D − B.
      const double ax = pivot - b.x, ay = -b.y, a2 = ax * ax + ay * ay;
      const double h = std::sqrt(36 / a2 - 0.25);
      const double ex = 0.5 * ax - h * ay, ey = 0.5 * ay + h * ax;  // C − B
      const double fx = ex - ax, fy = ey - ay;                      // C − D
      // C moves across the rocker, Ċ = ω f⊥, and along the coupler as B does.
      const double inverse = 1 / (ey * fx - ex * fy);
      const double omega = inverse * (ex * b.vx + ey * b.vy);
      const double vx = -omega * fy, vy = omega * fx, rx = vx - b.vx, ry = vy - b.vy;
      const double omega2 = omega * omega;
      const double alpha =
          inverse * (ex * (b.ax + omega2 * fx) + ey * (b.ay + omega2 * fy) - (rx * rx + ry * ry));
      psi_[k] = near(elementary::arctan(fy, fx), psi_[k]);
      b = {pivot + fx, fy, vx, vy, -alpha * fy - omega2 * fx, alpha * fx - omega2 * fy};
      double* const at = q.data() + 3 + 3 * k;
      at[0] = b.x, at[1] = b.y, at[2] = psi_[k];
      at[n] = b.vx, at[n + 1] = b.vy, at[n + 2] = omega;
      at[2 * n] = b.ax, at[2 * n + 1] = b.ay, at[2 * n + 2] = alpha;
    }
  }

  static constexpr int n = 3 + 3 * dyads;
  std::array<double, 3 * n> q{};

 private:
  struct Point {
    double x, y, vx, vy, ax, ay;
  };
  std::array<double, dyads> psi_ = [] {
    std::array<double, dyads> start;
    start.fill(2);
    return start;
  }();
};

void require_agreement(const ByHand& by_hand, const Formulation& f) {
  const std::span<const double> levels[] = {f.q(), f.qd(), f.qdd()};
  for (int level = 0; level < 3; ++level)
    for (int i = 3; i < ByHand::n; ++i)
      if (!(std::abs(by_hand.q[level * ByHand::n + i] - levels[level][i]) < 1e-8))
        throw std::runtime_error("a formulation and the closed form by hand disagree");
}

/// There and back, so that every step is a small one, the next round's first as well.
double per_dyad(const std::function<void(double)>& solve) {
  const double start = suite::cpu_now();
  for (int i = 0; i < steps; ++i) solve(std::min(i, steps - i) * step);
  return (suite::cpu_now() - start) / (static_cast<double>(steps) * dyads);
}

}  // namespace

int main() {
  try {
    const Mechanism m = make_mechanism(four_bar(dyads));
    ByHand by_hand;
    std::vector<std::string> names{"by hand"};
    std::vector<std::function<void(double)>> all{[&](double t) { by_hand.solve(t); }};
    std::vector<std::unique_ptr<Formulation>> formulations;
    for (const char* id : {"group_symbolic_explicit", "group_symbolic_inlined"}) {
      formulations.push_back(make_formulation(find_variant(id), m));
      Formulation& f = *formulations.back();
      const auto solve = [&f, &m](double t) {
        if (const Summary s = f.step(t); !s.ok()) throw std::runtime_error(describe(s, m));
      };
      for (int i = 0; i < 700; ++i) {
        solve(i * step);
        by_hand.solve(i * step);
        require_agreement(by_hand, f);
      }
      solve(0);
      by_hand.solve(0);
      names.emplace_back(id);
      all.push_back(solve);
    }
    std::vector<double> fastest(all.size(), std::numeric_limits<double>::infinity());
    for (int r = 0; r < rounds; ++r)
      for (std::size_t i = 0; i < all.size(); ++i)
        fastest[i] = std::min(fastest[i], per_dyad(all[i]));
    for (std::size_t i = 0; i < all.size(); ++i)
      std::printf("%-26s %8.2f ns/dyad/step %6.2f\n", names[i].c_str(), fastest[i] * 1e9,
                  fastest[i] / fastest[0]);
  } catch (const std::exception& e) {
    std::cerr << "desmo_dyads: " << e.what() << '\n';
    return 1;
  }
}
