#include "formulations/verification/certificate/coordinate_paths.h"

#include <array>

#include "formulations/verification/certificate/path_equations.h"

namespace desmo {

namespace {

constexpr int degree = PathEquations::degree;
constexpr double unit = Interval::unit;

LaneNumbers size_of(const Quintic<LaneNumbers>& c) {
  LaneNumbers sum(0);
  for (const LaneNumbers& x : c) sum += abs(x);
  return sum;
}

}  // namespace

void CoordinatePaths::find(const CertifiedInstant& from, const CertifiedInstant& to) {
  span_ = TimeSpan(from.time, to.time);
  find_between(from, to);
  find_drivers();
}

/// Finds the path p(s) of each coordinate, a Hermite polynomial through both instants, and its gap:
/// the distance at the ends from the farthest point of the certified boxes.
void CoordinatePaths::find_between(const CertifiedInstant& from, const CertifiedInstant& to) {
  const double h = span_.half, s0 = span_.s(from.time), s1 = span_.s(to.time);
  const Level highest = std::min(levels_of(from.values).back(), levels_of(to.values).back());
  for (int first = 0; first < m_.coordinates(); first += LaneNumbers::count) {
    const int last = std::min(first + LaneNumbers::count, m_.coordinates()) - 1;
    const int second = std::min(first + 1, last), third = std::min(first + 2, last);
    const bool is_full = last == first + 3;
    const auto lanes_of = [&](std::span<const double> x) {
      return is_full ? LaneNumbers::load(&x[first])
                     : LaneNumbers(LaneNumbers::Numbers{x[first], x[second], x[third], x[last]});
    };
    std::array<Level, LaneNumbers::count> levels;
    levels.fill(highest);
    for (const std::span<const Level> solved : {from.levels, to.levels})
      for (int i = first; i <= last && !solved.empty(); ++i)
        levels[i - first] = std::min(levels[i - first], solved[i]);
    for (const Level level : all_levels) {
      if (std::ranges::find(levels, level) == levels.end()) continue;
      const auto end = [&](const CertifiedInstant& x) {
        EndValues<LaneNumbers> values{lanes_of(x.values.position)};
        if (level >= Level::velocity) values.first = lanes_of(x.values.velocity) * h;
        if (level >= Level::acceleration) values.second = lanes_of(x.values.acceleration) * (h * h);
        return values;
      };
      const EndValues<LaneNumbers> a = end(from), b = end(to);
      const Quintic<LaneNumbers> p = hermite(a, b, level);
      // Horner's rule rounds twice a degree; s is off by two roundings, which counts up to the
      // degree.
      constexpr double rounding = (4 * degree + 2) * unit;
      const auto distance = [&](const EndValues<LaneNumbers>& x, std::span<const double> radius,
                                double s) {
        return abs(value_at(p, LaneNumbers(s)) - x.q) + lanes_of(radius);
      };
      const LaneNumbers first_gap = distance(a, from.radius, s0),
                        last_gap = distance(b, to.radius, s1),
                        widest =
                            (max(first_gap, last_gap) + rounding * size_of(p)) * (1 + 8 * unit);
      // max() drops what is not a number.
      const LaneNumbers gap = select(is_finite(first_gap + last_gap), widest, INFINITY);
      std::array<LaneNumbers, 4> low{p[0], p[1], p[2], p[3]}, high{p[4], p[5], gap, INFINITY};
      transpose(low[0], low[1], low[2], low[3]);
      transpose(high[0], high[1], high[2], high[3]);
      for (int i = first; i <= last; ++i)
        if (levels[i - first] == level) rows_[i].set(low[i - first], high[i - first]);
    }
  }
}

/// Replaces the path of driven coordinates by Taylor polynomials of their motions.
void CoordinatePaths::find_drivers() {
  using Exact = TaylorModel<Compensated<double>, degree>;
  Exact time(span_.middle);
  time.c[1] = span_.half;
  for (const Driver& d : m_.drivers) {
    const int i = m_.entities[d.coordinate].first;
    const Exact z = sample<Level::position>(d.motion, time).position;
    double rest = z.rest;
    for (int k = 0; k <= degree; ++k) {
      const Interval c = z.c[k].enclosure();
      rows_[i].path[k] = c.mid;
      rest += c.radius;
    }
    rows_[i].radius = rest * (1 + 16 * unit);
  }
}

}  // namespace desmo
