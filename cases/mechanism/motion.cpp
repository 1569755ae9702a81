#include "cases/mechanism/motion.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace desmo {

namespace {

/// Symmetric and tridiagonal.
struct Tridiagonal {
  std::vector<double> diagonal;
  std::vector<double> off_diagonal;  ///< one fewer
};

/// Thomas' algorithm, without pivoting: the matrices of splines are diagonally dominant.
std::vector<double> solve(const Tridiagonal& matrix, std::vector<double> x) {
  std::vector<double> pivot = matrix.diagonal;
  const std::vector<double>& e = matrix.off_diagonal;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double factor = e[i - 1] / pivot[i - 1];
    pivot[i] -= factor * e[i - 1];
    x[i] -= factor * x[i - 1];
  }
  x.back() /= pivot.back();
  for (std::size_t i = x.size() - 1; i-- > 0;) x[i] = (x[i] - e[i] * x[i + 1]) / pivot[i];
  return x;
}

/// The same with `corner` added to the matrix at its upper right and lower left, by Sherman and
/// Morrison: A + u vᵀ with u = (γ, 0 … 0, corner), v = (1, 0 … 0, corner/γ).
std::vector<double> solve_cyclic(Tridiagonal matrix, double corner, std::vector<double> rhs) {
  const double gamma = -matrix.diagonal.front();  // any but 0; this one keeps A dominant
  const double v_last = corner / gamma;
  std::vector<double> u(rhs.size(), 0.0);
  u.front() = gamma;
  u.back() = corner;
  matrix.diagonal.front() -= gamma;
  matrix.diagonal.back() -= corner * v_last;

  std::vector<double> x = solve(matrix, std::move(rhs));
  const std::vector<double> y = solve(matrix, std::move(u));  // A y = u
  const double factor = (x.front() + v_last * x.back()) / (1 + y.front() + v_last * y.back());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= factor * y[i];
  return x;
}

/// z̈ at every knot, from the continuity of ż at knot i, where interval i (length hᵢ, slope δᵢ of
/// its chord) follows interval i−1:
///   hᵢ₋₁ z̈ᵢ₋₁ + 2 (hᵢ₋₁ + hᵢ) z̈ᵢ + hᵢ z̈ᵢ₊₁ = 6 (δᵢ − δᵢ₋₁)
std::vector<double> second_derivatives(const std::vector<double>& h,
                                       const std::vector<double>& slope, SplineEnds ends) {
  const std::size_t n = h.size();
  const bool periodic = ends == SplineEnds::periodic;
  Tridiagonal matrix{std::vector<double>(n + 1, 0.0), h};
  std::vector<double> rhs(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) {  // each interval's share in the equations of its two knots
    matrix.diagonal[i] += 2 * h[i];
    matrix.diagonal[i + 1] += 2 * h[i];
    rhs[i] += 6 * slope[i];
    rhs[i + 1] -= 6 * slope[i];
  }
  if (periodic) {  // the last knot is the first
    matrix.diagonal.front() += matrix.diagonal.back();
    rhs.front() += rhs.back();
    matrix.diagonal.pop_back();
    matrix.off_diagonal.pop_back();
    rhs.pop_back();
    std::vector<double> x = solve_cyclic(std::move(matrix), h.back(), std::move(rhs));
    x.push_back(x.front());
    return x;
  }
  if (ends == SplineEnds::natural) {
    matrix.off_diagonal.front() = matrix.off_diagonal.back() = 0;
    rhs.front() = rhs.back() = 0;
  }
  return solve(matrix, std::move(rhs));
}

void check(const std::vector<double>& times, const std::vector<double>& values, SplineEnds ends) {
  const auto refuse = [](const std::string& what) {
    throw std::invalid_argument("a table of times and values " + what);
  };
  const bool periodic = ends == SplineEnds::periodic;
  if (times.size() != values.size())
    refuse("has " + std::to_string(times.size()) + " times but " + std::to_string(values.size()) +
           " values");
  if (times.size() < (periodic ? 3u : 2u))
    refuse(periodic ? "that is periodic needs three points or more" : "needs two points or more");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]))
      refuse("has a time that is not finite, at position " + std::to_string(i));
    if (!std::isfinite(values[i]))
      refuse("has a value that is not finite, at position " + std::to_string(i));
    if (i > 0 && times[i] <= times[i - 1])
      refuse("needs ascending times: that at position " + std::to_string(i) +
             " is not after the one before");
  }
  if (periodic && values.front() != values.back())
    refuse("that is periodic must end with the value it begins with");
}

}  // namespace

Spline make_spline(std::vector<double> times, std::vector<double> values, SplineEnds ends) {
  check(times, values, ends);
  const std::size_t n = times.size() - 1;
  std::vector<double> h(n), slope(n);
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = times[i + 1] - times[i];
    slope[i] = (values[i + 1] - values[i]) / h[i];
  }
  const std::vector<double> second = second_derivatives(h, slope, ends);

  Spline spline;
  for (std::size_t i = 0; i < n; ++i) {
    const Spline::Piece piece{values[i], slope[i] - h[i] * (2 * second[i] + second[i + 1]) / 6,
                              second[i] / 2, (second[i + 1] - second[i]) / (6 * h[i])};
    for (const double c : piece)
      if (!std::isfinite(c))
        throw std::invalid_argument("a table of times and values is too steep to be computed with");
    spline.pieces_.push_back(piece);
  }
  spline.knots_ = std::move(times);
  return spline;
}

TimeGrid time_grid(double seconds, double step) {
  const double intervals = std::round(seconds / step);
  if (!(seconds > 0) || !(step > 0) || !std::isfinite(seconds) || !(intervals >= 1) ||
      !(intervals <= 1e9 - 1))
    throw std::invalid_argument(
        "time grid: duration and step must be positive, with 2 to 1e9 instants");
  return {0, step, static_cast<int>(intervals) + 1};
}

}  // namespace desmo
