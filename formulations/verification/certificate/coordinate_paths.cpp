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

/// Bounds the distance, at an end, from a path to any point of the certified box. Does not count
/// the rounding of this bound.
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

/// Paths of four coordinates: one register each for the first and the second half of a
/// CoordinatePath.
struct FourPaths {
  std::array<LaneNumbers, LaneNumbers::count> low, high;
};

/// Returns the paths of four coordinates that are solved up to a level at both ends.
FourPaths paths_of(const CertifiedInstant& from, const CertifiedInstant& to, const TimeSpan& span,
                   int first, Level level) {
  const EndValues<LaneNumbers> a = values_at(from, first, level, span.half),
                               b = values_at(to, first, level, span.half);
  const Quintic<LaneNumbers> p = hermite(a, b, level);
  const LaneNumbers widest =
      gap(p, distance(p, span.s(from.time), a.q, LaneNumbers::load(from.radius, first)),
          distance(p, span.s(to.time), b.q, LaneNumbers::load(to.radius, first)));
  FourPaths paths{{p[0], p[1], p[2], p[3]}, {p[4], p[5], widest, INFINITY}};
  for (auto* half : {&paths.low, &paths.high})
    transpose((*half)[0], (*half)[1], (*half)[2], (*half)[3]);
  return paths;
}

}  // namespace

/// Finds the path p(s) of each coordinate, a Hermite polynomial through both instants. Finds also
/// its gap: the distance at the ends from the farthest point of the certified boxes. No tube is
/// proven yet.
void PathProof::find_paths(const CertifiedInstant& from, const CertifiedInstant& to) {
  span_ = TimeSpan(from.time, to.time);
  const Level all = std::min(levels_of(from.values).back(), levels_of(to.values).back());
  const auto level_of = [&](int i) {
    Level level = all;
    for (const std::span<const Level> solved : {from.levels, to.levels})
      if (!solved.empty()) level = std::min(level, solved[i]);
    return level;
  };
  const bool is_same = from.levels.empty() && to.levels.empty();
  for (int first = 0; first < m_.coordinates(); first += LaneNumbers::count) {
    const int end = std::min(first + LaneNumbers::count, m_.coordinates());
    for (const Level level : all_levels) {
      if (level > all || (is_same && level < all)) continue;
      const FourPaths paths = paths_of(from, to, span_, first, level);
      for (int i = first; i < end; ++i)
        if (is_same || level_of(i) == level)
          paths_[i].set(paths.low[i - first], paths.high[i - first]);
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
    paths_[i].radius = rest * (1 + 16 * unit);
  }
}

}  // namespace desmo
