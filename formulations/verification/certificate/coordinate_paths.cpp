// Paths of all coordinates over a step, about which the tubes of a PathProof lie.
#include <array>

#include "formulations/verification/certificate/path_proof.h"

namespace desmo {

namespace {

constexpr double unit = Interval::unit;

/// Returns values and derivatives with respect to s of four coordinates, from `first` on, at an end
/// of a path.
/// - level: highest derivative
/// - half: half of the path's duration [s], which is dt/ds
EndValues<LaneNumbers> values_at(const CertifiedInstant& end, int first, Level level, double half) {
  EndValues<LaneNumbers> values{LaneNumbers::load(end.values.position, first)};
  if (level >= Level::velocity) values.first = LaneNumbers::load(end.values.velocity, first) * half;
  if (level >= Level::acceleration)
    values.second = LaneNumbers::load(end.values.acceleration, first) * (half * half);
  return values;
}

/// Returns the level up to which each of them is solved at both ends.
/// - last: the last one that exists
std::array<Level, LaneNumbers::count> levels_at(const CertifiedInstant& a,
                                                const CertifiedInstant& b, int first, int last) {
  std::array<Level, LaneNumbers::count> all;
  all.fill(std::min(levels_of(a.values).back(), levels_of(b.values).back()));
  for (const std::span<const Level> solved : {a.levels, b.levels})
    for (int i = first; i <= last && !solved.empty(); ++i)
      all[i - first] = std::min(all[i - first], solved[i]);
  return all;
}

/// Bounds the distance of a path at an end from the farthest point of the certified box there, but
/// for the rounding of this bound.
LaneNumbers distance(const Quintic<LaneNumbers>& path, double s, const LaneNumbers& q,
                     const LaneNumbers& radius) {
  return abs(value_at(path, LaneNumbers(s)) - q) + radius;
}

/// Bounds the larger of the distances at the first and the last end, with all rounding. Infinite
/// where one of them is not finite.
LaneNumbers gap(const Quintic<LaneNumbers>& path, const LaneNumbers& first,
                const LaneNumbers& last) {
  LaneNumbers size(0);
  for (const LaneNumbers& c : path) size += abs(c);
  // Horner's rule rounds twice for each degree. s has two roundings, which count path_degree times
  // at most. Two more cover the distance.
  constexpr double rounding = (4 * path_degree + 2) * unit;
  const LaneNumbers widest = (max(first, last) + rounding * size) * (1 + 8 * unit);
  return select(is_finite(first + last), widest, INFINITY);  // max() may drop a NaN
}

}  // namespace

/// Finds the path p(s) of each coordinate, a Hermite polynomial through both instants. Finds also
/// its gap: the distance at the ends from the farthest point of the certified boxes.
void PathProof::find_paths(const CertifiedInstant& from, const CertifiedInstant& to) {
  span_ = TimeSpan(from.time, to.time);
  const double s0 = span_.s(from.time), s1 = span_.s(to.time);
  for (int first = 0; first < m_.coordinates(); first += LaneNumbers::count) {
    const int last = std::min(first + LaneNumbers::count, m_.coordinates()) - 1;
    const auto levels = levels_at(from, to, first, last);
    for (const Level level : all_levels) {
      if (std::ranges::find(levels, level) == levels.end()) continue;
      const EndValues<LaneNumbers> a = values_at(from, first, level, span_.half),
                                   b = values_at(to, first, level, span_.half);
      const Quintic<LaneNumbers> p = hermite(a, b, level);
      const LaneNumbers widest = gap(p, distance(p, s0, a.q, LaneNumbers::load(from.radius, first)),
                                     distance(p, s1, b.q, LaneNumbers::load(to.radius, first)));
      std::array<LaneNumbers, 4> low{p[0], p[1], p[2], p[3]}, high{p[4], p[5], widest, INFINITY};
      transpose(low[0], low[1], low[2], low[3]);
      transpose(high[0], high[1], high[2], high[3]);
      for (int i = first; i <= last; ++i)
        if (levels[i - first] == level) paths_[i].set(low[i - first], high[i - first]);
    }
  }
}

/// Replaces the paths of driven coordinates by Taylor polynomials of their motions, and sets the
/// radii of their tubes to the remainders.
void PathProof::find_driven_paths() {
  using Exact = TaylorModel<Compensated<double>, path_degree>;
  Exact time(span_.middle);
  time.c[1] = span_.half;
  for (const Driver& d : m_.drivers) {
    const int i = m_.entities[d.coordinate].first;
    const Exact z = sample<Level::position>(d.motion, time).position;
    double rest = z.rest;
    for (int k = 0; k <= path_degree; ++k) {
      const Interval c = z.c[k].enclosure();
      paths_[i].path[k] = c.mid;
      rest += c.radius;
    }
    radius_[i] = paths_[i].radius = rest * (1 + 16 * unit);
  }
}

}  // namespace desmo
