// Closed forms of couplings by tables: cams, an indexing table, and a rail.

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "tests/load/closed_forms.h"

namespace desmo::load::closed_forms {
namespace {

/// The spline through a table, from its moments m = f″ at the knots: natural, or closed, with the
/// rise of a table that repeats.
class Interpolation {
 public:
  Interpolation(std::vector<Real> at, std::vector<Real> z, bool closed)
      : at_(std::move(at)), z_(std::move(z)), closed_(closed) {
    const std::size_t n = at_.size() - 1;
    Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> a;
    a.setZero(n + 1, n + 1);
    m_.setZero(n + 1);
    const auto add = [&](std::size_t row, std::size_t i, bool at_end, int sign) {
      const Real h = at_[i + 1] - at_[i], slope = (z_[i + 1] - z_[i]) / h;
      a(row, i) += (at_end ? 1 : 2) * h;
      a(row, i + 1) += (at_end ? 2 : 1) * h;
      m_[row] += sign * 6 * slope;
    };
    for (std::size_t i = 1; i < n; ++i) add(i, i - 1, true, -1), add(i, i, false, 1);
    if (closed) {
      add(0, n - 1, true, -1), add(0, 0, false, 1);
      a(n, 0) = 1, a(n, n) = -1;
    } else {
      a(0, 0) = a(n, n) = 1;
    }
    m_ = a.partialPivLu().solve(m_).eval();
  }

  Jet operator()(Jet x) const {
    const Real length = at_.back() - at_.front();
    const Real turns = closed_ ? std::floor((x.v - at_.front()) / length) : 0;
    x = x - Jet(turns * length);
    std::size_t i = 0;
    while (i + 2 < at_.size() && x.v >= at_[i + 1]) ++i;
    const Real h = at_[i + 1] - at_[i];
    const Jet right = (x - Jet(at_[i])) / Jet(h), left = Jet(1) - right, sixth = Jet(h * h / 6);
    return Jet(turns * (z_.back() - z_.front())) + left * Jet(z_[i]) + right * Jet(z_[i + 1]) +
           sixth * (Jet(m_[i]) * (left * left * left - left) +
                    Jet(m_[i + 1]) * (right * right * right - right));
  }

 private:
  std::vector<Real> at_, z_;
  Eigen::Matrix<Real, Eigen::Dynamic, 1> m_;
  bool closed_;
};

}  // namespace

Values cam_dwell(double t) {
  static const Interpolation lift({0, 60, 90, 120, 150, 180, 240, 300, 360},
                                  {0, 1, 5, 9, 10, 10, 10, 3, 0}, true);
  const Jet a = degrees(t, 750, 300, 60);
  const Jet s = Jet(0.001L) * (Jet(30) + lift(a / Jet(degree)));
  return {{"s", s}, {"F.y", s}};
}

Values indexing(double t) {
  static const Interpolation angle({0, 60, 120, 150, 180, 210, 240, 300, 360},
                                   {0, 0, 0, 10, 45, 80, 90, 90, 90}, true);
  const Jet w = Jet(pi / 4) + Jet(degree) * angle(degrees(t, -500, 700, 0) / Jet(degree));
  Values v{{"w", w}};
  add(v, "B", Vec2{{Jet(0.05L), 0}} + polar(Jet(0.01L * std::sqrt(2.0L)), w));
  return v;
}

/// The pin's place along the rail is unknown: Newton's method, then rates by the chain rule.
Values curved_rail(double t) {
  static const Interpolation rail({0, 10, 20, 35, 50}, {80, 88, 100, 112, 140}, false);
  const Jet y = Jet(105) + Jet(20) * sin(Jet(pi) * Jet::time(t));
  Jet x(20);
  for (int i = 0; i < 60; ++i) {
    const Jet at = rail(Jet(x.v, 1, 0));
    x = Jet(x.v + (y.v - at.v) / at.d, y.d / at.d, 0);
    x.dd = (y.dd - at.dd * x.d * x.d) / at.d;
  }
  const Vec2 P{{Jet(0.001L) * x, Jet(0.001L) * y}};
  Values v{{"x", P[0]}};
  add(v, "P", P);
  add(v, "A", meet(Vec2{{0, 0}}, Jet(0.1L), P, Jet(std::sqrt(0.0068L)), Side::left));
  return v;
}

}  // namespace desmo::load::closed_forms
