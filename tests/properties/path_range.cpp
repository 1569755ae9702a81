#include "tests/properties/path_range.h"

#include "tests/properties/continuation.h"

namespace desmo::properties {

namespace {

constexpr int pieces = 16;  // parts of the reach; crossings are looked for after each

PathRange::End find_end(Continuation& c, double reach) {
  for (int i = 1; i <= pieces; ++i) {
    const bool reached = c.go_to(reach * i / pieces);
    if (c.crossings() > 0) return {static_cast<double>(c.crossed_at()), true};
    if (!reached) return {static_cast<double>(c.parameter()), true};
  }
  return {reach, false};
}

}  // namespace

PathRange find_range(const Model& m, const Drawn& drawn) {
  PathRange range;
  for (const Driver& d : m.drivers)
    range.nominal.push_back(m.estimate[m.entities[d.coordinate].first]);
  const DriverPath straight = straight_path({range.nominal.begin(), range.nominal.end()},
                                            {drawn.direction.begin(), drawn.direction.end()});
  for (const int side : {0, 1}) {
    Continuation c(m);
    c.begin(straight, 0);
    range.ends[side] = find_end(c, (2 * side - 1) * drawn.reach);
  }
  return range;
}

}  // namespace desmo::properties
