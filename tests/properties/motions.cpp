#include "tests/properties/motions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "cases/mechanism/formatted.h"

namespace desmo::properties {

namespace {

TimeGrid grid_of(Random& r, int before, int after) {
  const double step = std::ldexp(1, -r.below(8));
  return {-before * step, step, before + after + 1};
}

}  // namespace

Profile aimed_motion(Random& r, int instants, int side, double distance, double length) {
  static constexpr std::array names{"end", "pass", "start", "turn", "rest", "knot"};
  const int kind = r.below(names.size());
  const bool both = kind == 1 || kind == 3 || kind == 5;
  const int before = kind == 2 ? 0 : both ? instants / 2 : instants;
  const int after = kind == 2 ? instants : both ? instants / 2 : 0;
  Profile p{.name = names[kind], .grid = grid_of(r, before, after)};
  const double time = std::max(before, after) * p.grid.step;
  const double d = -side * distance, w = side * length / time;
  switch (kind) {
    case 2:
      p.values = {d, -w};
      break;
    case 3:
      p.values = {d, 0, -w / time};
      break;
    case 4:
      p.kind = Profile::table, p.ends = "clamped";
      p.times = {-time, 0};
      p.values = {d - side * length, d};
      break;
    case 5:
      p.kind = Profile::table;
      for (int i = -2; i <= 2; ++i) {
        p.times.push_back(i * time / 2);
        p.values.push_back(i == 0 ? d : d - side * length * r.uniform(0.2, 1));
      }
      break;
    default:
      p.values = {d, w};
  }
  p.name += distance > 0 ? formatted(" %.0e", distance) : " 0";
  return p;
}

Profile random_motion(Random& r, int instants, double low, double high) {
  const auto anywhere = [&] { return r.uniform(low, high); };
  Profile p{.name = "random", .grid = grid_of(r, 0, instants)};
  const double time = instants * p.grid.step, from = r.chance(0.7) ? 0 : anywhere();
  const int kind = r.below(3);
  if (kind == 0) {
    p.values = {from, (anywhere() - from) / time};
  } else if (kind == 1) {
    const double a = std::min(from - low, high - from) * r.uniform(0.2, 1);
    p.kind = Profile::harmonic;
    p.values = {from, a, r.uniform(0.3, 2) / time, r.chance(0.5) ? 0 : std::numbers::pi / 2};
  } else {
    p.kind = Profile::table, p.ends = r.chance(0.5) ? "natural" : "clamped";
    const int knots = 2 + r.below(4);
    for (int i = 0; i <= knots; ++i) {
      p.times.push_back(i * time / knots);
      p.values.push_back(i == 0 ? from : anywhere());
    }
  }
  return p;
}

Profile straight_motion(Random& r, int instants, double from, double to) {
  Profile p{.name = "straight", .grid = grid_of(r, 0, instants)};
  p.values = {from, (to - from) / (instants * p.grid.step)};
  return p;
}

std::string motion_text(const Profile& p, double base, double direction, double unit) {
  using Json = nlohmann::ordered_json;
  std::vector<double> v = p.values;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const bool has_base = p.kind == Profile::table || i == 0;
    if (p.kind != Profile::harmonic || i < 2)
      v[i] = ((has_base ? base : 0) + direction * v[i]) * unit;
  }
  Json j;
  if (p.kind == Profile::polynomial)
    j = {{"type", "polynomial"}, {"coefficients", v}};
  else if (p.kind == Profile::table)
    j = {{"type", "table"}, {"times", p.times}, {"values", v}, {"ends", p.ends}};
  else
    j = {{"type", "harmonic"},
         {"mean", v[0]},
         {"terms", {{{"amplitude", v[1]}, {"frequency", v[2]}, {"phase", v[3]}}}}};
  return j.dump();
}

}  // namespace desmo::properties
