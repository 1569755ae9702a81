#include "cases/mechanism/motion.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace desmo {

namespace {

// T: double, or Derived for the exact spline.

/// A symmetric tridiagonal matrix.
template <class T>
struct Tridiagonal {
  std::vector<T> diagonal;      ///< (n)
  std::vector<T> off_diagonal;  ///< (n − 1): entries above the diagonal, equal to those below it
};

/// Solves a tridiagonal system with the right-hand side x by Thomas' algorithm, without pivoting:
/// the matrices of splines are diagonally dominant.
template <class T>
std::vector<T> solve(const Tridiagonal<T>& matrix, std::vector<T> x) {
  std::vector<T> pivot = matrix.diagonal;
  const std::vector<T>& e = matrix.off_diagonal;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const T factor = e[i - 1] / pivot[i - 1];
    pivot[i] = pivot[i] - factor * e[i - 1];
    x[i] = x[i] - factor * x[i - 1];
  }
  x.back() = x.back() / pivot.back();
  for (std::size_t i = x.size() - 1; i-- > 0;) x[i] = (x[i] - e[i] * x[i + 1]) / pivot[i];
  return x;
}

/// Solves the system of a tridiagonal matrix with `corner` added at its upper right and lower left.
/// Uses the formula of Sherman and Morrison: this matrix is A + u vᵀ, where A is tridiagonal,
/// u = (γ, 0 … 0, corner) and v = (1, 0 … 0, corner/γ).
template <class T>
std::vector<T> solve_cyclic(Tridiagonal<T> matrix, const T& corner, std::vector<T> rhs) {
  const T gamma = -matrix.diagonal.front();  // any number but 0; this one keeps A dominant
  const T v_last = corner / gamma;
  std::vector<T> u(rhs.size(), T(0));
  u.front() = gamma;
  u.back() = corner;
  matrix.diagonal.front() = matrix.diagonal.front() - gamma;
  matrix.diagonal.back() = matrix.diagonal.back() - corner * v_last;

  std::vector<T> x = solve(matrix, std::move(rhs));
  const std::vector<T> y = solve(matrix, std::move(u));  // A y = u
  const T factor = (x.front() + v_last * x.back()) / (T(1) + y.front() + v_last * y.back());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] - factor * y[i];
  return x;
}

bool closes(SplineEnds ends) {
  return ends == SplineEnds::periodic || ends == SplineEnds::indexing;
}

/// Returns z̈ at every knot. It follows from the continuity of ż at each knot i, where interval i
/// (length hᵢ, slope δᵢ of its chord) follows interval i−1:
///   hᵢ₋₁ z̈ᵢ₋₁ + 2 (hᵢ₋₁ + hᵢ) z̈ᵢ + hᵢ z̈ᵢ₊₁ = 6 (δᵢ − δᵢ₋₁)
template <class T>
std::vector<T> second_derivatives(const std::vector<T>& h, const std::vector<T>& slope,
                                  SplineEnds ends) {
  const std::size_t n = h.size();
  Tridiagonal<T> matrix{std::vector<T>(n + 1, T(0)), h};
  std::vector<T> rhs(n + 1, T(0));
  for (std::size_t i = 0; i < n; ++i) {  // each interval's share in the equations of its two knots
    matrix.diagonal[i] = matrix.diagonal[i] + T(2) * h[i];
    matrix.diagonal[i + 1] = matrix.diagonal[i + 1] + T(2) * h[i];
    rhs[i] = rhs[i] + T(6) * slope[i];
    rhs[i + 1] = rhs[i + 1] - T(6) * slope[i];
  }
  if (closes(ends)) {  // the last knot and the first have one unknown z̈ and one equation
    matrix.diagonal.front() = matrix.diagonal.front() + matrix.diagonal.back();
    rhs.front() = rhs.front() + rhs.back();
    matrix.diagonal.pop_back();
    matrix.off_diagonal.pop_back();
    rhs.pop_back();
    std::vector<T> x = solve_cyclic(std::move(matrix), h.back(), std::move(rhs));
    x.push_back(x.front());
    return x;
  }
  if (ends == SplineEnds::natural) {
    matrix.off_diagonal.front() = matrix.off_diagonal.back() = T(0);
    rhs.front() = rhs.back() = T(0);
  }
  return solve(matrix, std::move(rhs));
}

void check(const std::vector<double>& times, const std::vector<double>& values, SplineEnds ends) {
  const auto refuse = [](const std::string& what) {
    throw std::invalid_argument("a table " + what);
  };
  const bool periodic = closes(ends);
  if (times.size() != values.size())
    refuse("has " + std::to_string(times.size()) + " times but " + std::to_string(values.size()) +
           " values");
  if (times.size() < (periodic ? 3u : 2u))
    refuse(periodic ? "with these ends needs three points or more" : "needs two points or more");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]))
      refuse("has a time that is not finite, at position " + std::to_string(i));
    if (!std::isfinite(values[i]))
      refuse("has a value that is not finite, at position " + std::to_string(i));
    if (i > 0 && times[i] <= times[i - 1])
      refuse("needs ascending times: that at position " + std::to_string(i) +
             " is not after the one before");
  }
  if (ends == SplineEnds::periodic && values.front() != values.back())
    refuse("that is periodic must end with the value it begins with");
}

/// Returns the pieces of the spline through a table.
template <class T>
std::vector<std::array<T, 4>> interpolated(const std::vector<double>& times,
                                           const std::vector<double>& values, SplineEnds ends) {
  const std::size_t n = times.size() - 1;
  std::vector<T> h(n), slope(n);
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = T(times[i + 1]) - T(times[i]);
    slope[i] = (T(values[i + 1]) - T(values[i])) / h[i];
  }
  const std::vector<T> second = second_derivatives(h, slope, ends);
  std::vector<std::array<T, 4>> pieces;
  for (std::size_t i = 0; i < n; ++i)
    pieces.push_back({T(values[i]), slope[i] - h[i] * (T(2) * second[i] + second[i + 1]) / T(6),
                      second[i] / T(2), (second[i + 1] - second[i]) / (T(6) * h[i])});
  return pieces;
}

/// Returns the least double at or after a time. Where the radius leaves open on which side of the
/// nearest double the time is, returns the nearest double.
double rounded_up(const Derived& time) {
  const auto [value, correction, radius] = time.rounded();
  return correction > radius ? std::nextafter(value, std::numeric_limits<double>::infinity())
                             : value;
}

/// Returns whether v² ≥ a s, as far as the numbers of the file tell: there is no steady phase.
bool is_triangular(const Derived& s, const Derived& v, const Derived& a) {
  const Derived square = v * v, product = a * s, more = product - square;
  return std::isfinite(more.correction) ? more.value + more.correction <= more.radius
                                        : square.value >= product.value;  // one overflows
}

void require_finite(const Derived& coefficient) {
  if (!std::isfinite(coefficient.value))
    throw std::invalid_argument("the motion is too steep to be computed with");
}

}  // namespace

Spline make_spline(std::vector<double> times, std::vector<double> values, SplineEnds ends) {
  check(times, values, ends);
  const auto rounded = interpolated<double>(times, values, ends);
  const auto exact = interpolated<Derived>(times, values, ends);
  Spline spline;
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    Spline::Piece piece;
    for (int k = 0; k < 4; ++k)
      piece[k] = std::isfinite(rounded[i][k]) ? exact[i][k].about(rounded[i][k]) : rounded[i][k];
    spline.add(times[i], piece);
  }
  spline.knots_.push_back(times.back());
  spline.first_time_ = times.front();
  spline.last_time_ = times.back();
  return spline;
}

void Spline::add(double knot, const Piece& piece) {
  for (const Derived& c : piece) require_finite(c);
  knots_.push_back(knot);
  pieces_.push_back(piece);
}

/// The motion accelerates for the duration `up`, moves at the limit of velocity until `brakes`
/// (trapezoid only), and decelerates for the duration `up`. Pieces are cubics of the time since
/// their rounded knots. With their remainders the motion is continuous up to a relative error of
/// about 2^-100. Knots are rounded up: no double lies between an exact knot and the rounded one. A
/// steady phase in which no double lies is left out.
Spline make_spline(const Trapezoid& of) {
  const bool is_back = of.distance.value < 0;
  const Derived s = is_back ? -of.distance : of.distance, v = of.velocity, a = of.acceleration;
  const bool is_triangle = is_triangular(s, v, a);
  const Derived up = is_triangle ? sqrt(s / a) : v / a;
  const Derived end = Derived(of.start) + (is_triangle ? up * 2 : up + s / v);
  const double steady = rounded_up(Derived(of.start) + up),
               brakes = is_triangle ? steady : std::max(steady, rounded_up(end - up)),
               rests = rounded_up(end);
  if (!(of.start < steady && brakes < rests && std::isfinite(rests)))
    throw std::invalid_argument("the times at which it changes cannot be told apart");

  Spline spline;
  const auto add = [&](double knot, Spline::Piece piece) {
    for (Derived& c : piece) c = (is_back ? -c : c).rounded();
    spline.add(knot, piece);
  };
  const Derived half = a / 2, left = (end - brakes).rounded();
  add(of.start - (rests - of.start), {});  // sample() does not read where the outer knots are
  add(of.start, {0, 0, half, 0});
  if (steady < brakes) add(steady, {v * (Derived(steady) - of.start) - v * up / 2, v, 0, 0});
  add(brakes, {s - half * left * left, a * left, -half, 0});
  add(rests, {s, 0, 0, 0});
  spline.knots_.push_back(rests + (rests - of.start));
  return spline;
}

void Spline::shift(const Derived& distance) {
  for (Piece& piece : pieces_) piece[0] = (piece[0] + distance).rounded();
}

void Spline::scale(const Derived& factor) {
  for (Piece& piece : pieces_)
    for (Derived& c : piece) {
      c = (c * factor).rounded();
      require_finite(c);
    }
}

Motion shifted(Motion motion, const Derived& distance) {
  if (auto* const polynomial = std::get_if<Polynomial>(&motion)) {
    std::vector<Derived>& c = polynomial->coefficients;
    if (c.empty()) c.emplace_back();
    c[0] = (c[0] + distance).rounded();
  } else if (auto* const sum = std::get_if<HarmonicSum>(&motion)) {
    sum->mean = (sum->mean + distance).rounded();
  } else {
    std::get<Spline>(motion).shift(distance);
  }
  return motion;
}

}  // namespace desmo
