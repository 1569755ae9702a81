#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace desmo::tree {

using Vec = Eigen::Vector3d;

/// A moving quantity at one instant: its value and its first two derivatives in time. T: a vector
/// of two or three components, or a number.
template <class T>
struct Moving {
  T q, qd, qdd;
};

template <class T>
Moving<T> operator+(const Moving<T>& a, const Moving<T>& b) {
  return {a.q + b.q, a.qd + b.qd, a.qdd + b.qdd};
}
template <class T>
Moving<T> operator-(const Moving<T>& a, const Moving<T>& b) {
  return {a.q - b.q, a.qd - b.qd, a.qdd - b.qdd};
}
/// Subtracts a point that rests.
template <class T>
Moving<T> operator-(const Moving<T>& a, const T& resting) {
  return {a.q - resting, a.qd, a.qdd};
}
template <class T>
Moving<T> operator*(double factor, const Moving<T>& a) {
  return {factor * a.q, factor * a.qd, factor * a.qdd};
}

inline Moving<Vec> cross(const Moving<Vec>& a, const Moving<Vec>& b) {
  return {a.q.cross(b.q), a.qd.cross(b.q) + a.q.cross(b.qd),
          a.qdd.cross(b.q) + 2 * a.qd.cross(b.qd) + a.q.cross(b.qdd)};
}

/// A vector as its length and its direction.
struct Polar {
  Moving<double> length;
  Moving<Vec> direction;
};

/// Returns length s and direction d of a vector a = s d, which is not 0:
/// ṡ = d·ȧ, s ḋ = ȧ − ṡ d, s̈ = d·ä + ḋ·ȧ, s d̈ = ä − s̈ d − 2 ṡ ḋ.
inline Polar polar(const Moving<Vec>& a) {
  const double s = a.q.norm(), inverse = 1 / s;
  const Vec d = inverse * a.q;
  const double s1 = d.dot(a.qd);
  const Vec d1 = inverse * (a.qd - s1 * d);
  const double s2 = d.dot(a.qdd) + d1.dot(a.qd);
  return {{s, s1, s2}, {d, d1, inverse * (a.qdd - s2 * d - 2 * s1 * d1)}};
}

inline Moving<Vec> unit(const Moving<Vec>& a) { return polar(a).direction; }

/// A writer of the coordinates that a peer finds, with their rates, one entity after the other.
class AnswerWriter {
 public:
  AnswerWriter(double* q, double* qd, double* qdd) : q_(q), qd_(qd), qdd_(qdd) {}

  template <int n>
  void put(const Moving<Eigen::Matrix<double, n, 1>>& v) {
    for (int i = 0; i < n; ++i) put(Moving<double>{v.q[i], v.qd[i], v.qdd[i]});
  }
  void put(const Moving<double>& x) {
    *q_++ = x.q;
    *qd_++ = x.qd;
    *qdd_++ = x.qdd;
  }

 private:
  double *q_, *qd_, *qdd_;
};

}  // namespace desmo::tree
