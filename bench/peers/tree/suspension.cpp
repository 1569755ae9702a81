#include "bench/peers/tree/suspension.h"

#include <cmath>
#include <stdexcept>

#include "bench/peers/tree/nominal.h"

namespace desmo::tree {

Stabiliser::Stabiliser(const Mechanism& mechanism, const std::string& prefix,
                       const std::string& lever, const std::string& link)
    : name_(prefix + lever) {
  const Vec s = nominal(mechanism, prefix + "S"), a = nominal(mechanism, prefix + "A" + lever);
  const Vec b = nominal(mechanism, prefix + "B" + lever);
  a_ = a - s;
  g_ = nominal(mechanism, prefix + "G" + link);
  lever_ = (b - a).norm();
  link_ = (b - g_).norm();
  const Vec across(b.z() - a.z(), 0, a.x() - b.x());  // y2 × (B − A) in the nominal position
  side_ = std::copysign(1.0, across.dot(a - g_));
}

std::vector<std::string> Stabiliser::delivered(const std::string& prefix, const std::string& lever,
                                               const std::string& link) {
  return {prefix + "A" + lever, prefix + "B" + lever, prefix + "e" + lever,  prefix + "n" + lever,
          prefix + "u" + link,  prefix + "n" + link,  prefix + "phi" + lever};
}

void Stabiliser::solve(const Pose& axle, AnswerWriter& out) const {
  const Moving<Vec> a = axle.at(a_);
  // D·e = k, that is −X cos φ + Z sin φ = k with X = D·x2, Z = D·z2. Its two solutions differ in
  // the sign of w.
  const Vec from_g = a.q - g_;
  const double x = from_g.dot(axle.x.q), z = from_g.dot(axle.z.q);
  const double k = (link_ * link_ - lever_ * lever_ - from_g.squaredNorm()) / (2 * lever_);
  const double square = x * x + z * z, rest = square - k * k;
  if (!(rest > 0)) throw std::runtime_error(name_ + ": its link does not reach it");
  const double w = side_ * std::sqrt(rest), inverse = 1 / square;
  const double cosine = inverse * (w * z - k * x), sine = inverse * (w * x + k * z);

  // e and n = de/dφ with rates as if φ were constant (e0, n0). n·(B−G) = n·D = w.
  const Moving<Vec> e0 = sine * axle.z - cosine * axle.x, n0 = cosine * axle.z + sine * axle.x;
  const Vec b = from_g + lever_ * e0.q;  // B − G
  const double per_angle = -1 / (lever_ * w);
  const double rate = per_angle * b.dot(a.qd + lever_ * e0.qd);  // (B−G)·Ḃ = 0
  const Vec e1 = e0.qd + rate * n0.q;
  const Vec e2 = e0.qdd + 2 * rate * n0.qd - rate * rate * e0.q;  // without φ̈
  const double second_rate =                                      // (B−G)·B̈ + Ḃ² = 0
      per_angle * ((a.qd + lever_ * e1).squaredNorm() + b.dot(a.qdd + lever_ * e2));
  const Moving<Vec> e{e0.q, e1, e2 + second_rate * n0.q};
  const Moving<Vec> n{n0.q, n0.qd - rate * e0.q,
                      n0.qdd - 2 * rate * e0.qd - rate * rate * n0.q - second_rate * e0.q};

  const Moving<Vec> end = a + lever_ * e, link = end - g_, u = unit(cross(e, link));
  out.put(a);
  out.put(end);
  out.put(e);
  out.put(n);
  out.put(u);
  out.put((1 / link_) * cross(link, u));
  out.put(Moving<double>{std::atan2(sine, cosine), rate, second_rate});
}

Damper::Damper(const Mechanism& mechanism, const std::string& prefix, const std::string& rod,
               const std::string& tube)
    : a_(nominal(mechanism, prefix + "A" + rod) - nominal(mechanism, prefix + "S")),
      t_(nominal(mechanism, prefix + "T" + tube)) {}

std::vector<std::string> Damper::delivered(const std::string& prefix, const std::string& rod,
                                           const std::string& tube) {
  return {prefix + "A" + rod, prefix + "d" + rod,  prefix + "u" + rod,
          prefix + "n" + rod, prefix + "n" + tube, prefix + "s" + rod};
}

void Damper::solve(const Pose& axle, AnswerWriter& out) const {
  const Moving<Vec> a = axle.at(a_);
  const auto [s, d] = polar(-1 * (a - t_));  // T − A = s d
  const Moving<Vec> u = unit(cross(d, axle.x)), n = cross(d, u);
  out.put(a);
  out.put(d);
  out.put(u);
  out.put(n);
  out.put(-1 * n);
  out.put(s);
}

}  // namespace desmo::tree
