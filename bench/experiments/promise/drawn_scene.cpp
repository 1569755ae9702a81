#include "bench/experiments/promise/drawn_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "bench/experiments/promise/judgeable.h"
#include "bench/experiments/promise/mechanisms.h"
#include "bench/experiments/promise/path_range.h"
#include "cases/io/files.h"
#include "cases/mechanism/formatted.h"
#include "formulations/modelling/modelling.h"
#include "formulations/parts/profile.h"
#include "formulations/scaling/scales.h"

namespace desmo::promise {

namespace {

using Json = nlohmann::ordered_json;

constexpr int max_draws = 60;
constexpr std::array distances{0.0,  1e-16, 1e-15, 1e-14, 1e-12, 1e-10,
                               1e-8, 1e-6,  1e-4,  1e-3,  1e-2,  0.1};

/// A motion along the path, from a base: u(t).
struct Profile {
  std::string name;
  enum { polynomial, harmonic, table } kind = polynomial;
  std::vector<double> values = {};  ///< coefficients; mean, amplitude, frequency, phase; at times
  std::vector<double> times = {};
  const char* ends = "natural";
  TimeGrid grid = {};
};

Json motion_json(const Profile& p, double base, double direction, double unit) {
  std::vector<double> v = p.values;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const bool has_base = p.kind == Profile::table || i == 0;
    if (p.kind != Profile::harmonic || i < 2)
      v[i] = ((has_base ? base : 0) + direction * v[i]) * unit;
  }
  if (p.kind == Profile::polynomial) return {{"type", "polynomial"}, {"coefficients", v}};
  if (p.kind == Profile::table)
    return {{"type", "table"}, {"times", p.times}, {"values", v}, {"ends", p.ends}};
  return {{"type", "harmonic"},
          {"mean", v[0]},
          {"terms", {{{"amplitude", v[1]}, {"frequency", v[2]}, {"phase", v[3]}}}}};
}

/// Returns the value that was meant to be simple: a multiple of π/2, or a short number.
double simple(double z) {
  constexpr double quarter = std::numbers::pi / 2;
  if (std::abs(z) < 1e-9) return 0;
  const double turns = std::nearbyint(z / quarter) * quarter, rounded = static_cast<float>(z);
  for (const double candidate : {turns, rounded})
    if (std::abs(z - candidate) < 1e-9 * std::abs(z)) return candidate;
  return z;
}

TimeGrid grid_of(Random& r, int before, int after) {
  const double step = std::ldexp(1, -r.below(8));
  return {-before * step, step, before + after + 1};
}

/// A motion that is `distance` before a singular position at t = 0; side: where this lies.
Profile aimed(Random& r, int instants, int side, double distance, double length) {
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

/// A motion between two path parameters. It begins at the nominal position, or anywhere.
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

double rounding_of(const Model& m, const TimeGrid& grid) {
  double far = 0, driver = 1;
  for (const Entity& e : m.entities)
    if (e.kind == EntityKind::point)
      for (int i = 0; i < e.size; ++i)
        far = std::max(far, std::abs((e.fixed ? m.fixed_values : m.estimate)[e.first + i]));
  for (const Driver& d : m.drivers)
    if (m.entities[d.coordinate].kind == EntityKind::angle)
      for (int i = 0; i < grid.instants; ++i)
        driver = std::max(driver, std::abs(sample(d.motion, grid.time(i)).position));
  return std::max(1.0, far / nominal_size(m)) * driver;
}

const Family& chosen_family(Random& r) {
  const auto& all = families();
  const auto drawn = std::ranges::count_if(all, [](const Family& f) { return f.draw != nullptr; });
  const int library = static_cast<int>(std::ssize(all) - drawn);
  return r.chance(0.7) ? all[r.below(static_cast<int>(drawn))] : all[drawn + r.below(library)];
}

/// Returns the model with the numbers that formulations solve with, dimensions and motions as
/// rounded to double: bounds without a proof are of these.
Model as_solved(Model m) {
  for (Constraint& c : m.constraints) c.remainders.clear();
  std::ranges::fill(m.fixed_remainders, Remainder());
  for (Driver& d : m.drivers)
    std::visit(
        [](auto& motion) {
          if constexpr (requires { motion.remainders; }) motion.remainders.clear();
        },
        d.motion);
  return m;
}

DrawnScene try_scene(Random& r, int number) {
  const Family& family = chosen_family(r);
  const Drawn drawn = draw(family, r);
  const std::vector<Motion> still(drawn.direction.size(), Polynomial{});
  const Model nominal = model_mechanism(drawn.mechanism, still).model;
  const PathRange range = find_range(nominal, drawn);
  const int instants = nominal.coordinates() > 40 ? 8 + r.below(8) : 16 + r.below(40);
  const bool is_aimed = number % 2 == 1;
  int side = r.below(2);
  if (!range.ends[side].singular) side = 1 - side;
  const PathRange::End end = range.ends[side];
  if (is_aimed && !end.singular && r.chance(0.8)) throw std::runtime_error("nothing to aim at");

  std::vector<double> base = range.nominal;
  Profile profile;
  if (is_aimed) {
    const double at = end.at * (end.singular ? 1 : r.uniform(0.1, 0.9));
    for (std::size_t k = 0; k < base.size(); ++k) {
      base[k] += at * drawn.direction[k];
      if (drawn.exact) base[k] = simple(base[k]);
    }
    profile = aimed(r, instants, 2 * side - 1, distances[r.below(distances.size())],
                    std::abs(at) * r.uniform(0.3, 0.95));
    if (!end.singular) profile.name = profile.name.substr(0, profile.name.find(' ')) + " regular";
  } else {
    const auto inside = [](const PathRange::End& e) { return e.at * (e.singular ? 0.98 : 1); };
    profile = random_motion(r, instants, inside(range.ends[0]), inside(range.ends[1]));
  }

  const bool degrees = r.chance(0.2);
  Json motions;
  std::size_t k = 0;
  for (const Mechanism::Coordinate& c : drawn.mechanism.coordinates) {
    if (!c.driven) continue;
    const bool turns = degrees && c.type == Mechanism::CoordinateType::angle;
    motions[c.name] =
        motion_json(profile, base[k], drawn.direction[k], turns ? 180 / std::numbers::pi : 1);
    ++k;
  }
  DrawnScene s{.number = number, .family = std::string(family.name), .aim = profile.name};
  s.text =
      scene_text(drawn.mechanism, s.family + ", " + s.aim, motions.dump(), profile.grid, degrees);
  s.scene = parse_scene(s.text, "drawn scene", ".");
  ModellingResult modelled = model_mechanism(s.scene.mechanism, s.scene.motions);
  s.overconstrained = std::ranges::any_of(modelled.left_out, &LeftOut::redundant);
  s.model = as_solved(std::move(modelled.model));
  s.truth = true_motion(s.model, s.scene.grid);
  if (s.overconstrained) add_other_answers(s);
  s.rounding = rounding_of(s.model, s.scene.grid);
  return s;
}

}  // namespace

std::string scene_text(const Mechanism& mechanism, const std::string& name,
                       const std::string& motions, const TimeGrid& grid, bool degrees) {
  const Json j = {
      {"format", "desmo-scene"},
      {"version", 2},
      {"name", name},
      {"mechanism", Json::parse(write_mechanism(mechanism))},
      {"units", {{"length", mechanism.length_unit}, {"angle", degrees ? "deg" : "rad"}}},
      {"motion", Json::parse(motions)},
      {"time",
       {{"start", grid.start}, {"end", grid.time(grid.instants - 1)}, {"step", grid.step}}}};
  return j.dump(1) + '\n';
}

DrawnScene draw_scene(std::uint64_t seed, int number) {
  Random r(seed * 1'000'003 + number);
  std::string last;
  for (int i = 0; i < max_draws; ++i) {
    Random one(r.bits());
    try {
      return try_scene(one, number);
    } catch (const std::exception& error) {  // dimensions that do not close, a start out of reach
      last = error.what();
    }
  }
  throw std::runtime_error("scene " + std::to_string(number) +
                           ": no draw serves; the last: " + last);
}

}  // namespace desmo::promise
