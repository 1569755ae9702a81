// Scenes whose motions follow a path between singular positions, or run into one.
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "tests/properties/assembled_drawing.h"
#include "tests/properties/scene_kinds.h"

namespace desmo::properties {

namespace {

constexpr std::array distances{0.0,  1e-16, 1e-15, 1e-14, 1e-12, 1e-10,
                               1e-8, 1e-6,  1e-4,  1e-3,  1e-2,  0.1};

/// Returns the value that was meant to be simple: a multiple of π/2, or a short number.
double simple(double z) {
  constexpr double quarter = std::numbers::pi / 2;
  if (std::abs(z) < 1e-9) return 0;
  const double turns = std::nearbyint(z / quarter) * quarter, rounded = static_cast<float>(z);
  for (const double candidate : {turns, rounded})
    if (std::abs(z - candidate) < 1e-9 * std::abs(z)) return candidate;
  return z;
}

int drawn_instants(Random& r, int coordinates) {
  return coordinates > 40 ? 8 + r.below(8) : 16 + r.below(40);
}

}  // namespace

DrawnPath path_of(Drawn drawn) {
  drawn.mechanism = parse_mechanism(write_mechanism(drawn.mechanism), "drawn mechanism");
  const std::vector<Motion> still(drawn.direction.size(), Polynomial{});
  const Model m = with_assembled_drawing(model_mechanism(drawn.mechanism, still).model);
  PathRange range = find_range(m, drawn);
  return {std::move(drawn), std::move(range), m.coordinates()};
}

Draft draft_of(Random& r, std::string_view family, const DrawnPath& path,
               const std::vector<double>& base, const Profile& profile) {
  Draft d{.family = std::string(family),
          .aim = profile.name,
          .mechanism = path.drawn.mechanism,
          .motions = {},
          .grid = profile.grid,
          .degrees = r.chance(0.2)};
  std::size_t k = 0;
  for (const Mechanism::Coordinate& c : d.mechanism.coordinates) {
    if (!c.driven) continue;
    const bool turns = d.degrees && c.is_angle();
    d.motions.push_back(
        motion_text(profile, base[k], path.drawn.direction[k], turns ? 180 / std::numbers::pi : 1));
    ++k;
  }
  return d;
}

Draft draft_inside(Random& r, std::string_view family, const DrawnPath& path) {
  const auto inside = [](const PathRange::End& e) { return e.at * (e.singular ? 0.98 : 1); };
  const Profile profile = random_motion(r, drawn_instants(r, path.coordinates),
                                        inside(path.range.ends[0]), inside(path.range.ends[1]));
  return draft_of(r, family, path, path.range.nominal, profile);
}

Draft draw_random(Random& r) {
  const Family& family = chosen_family(r);
  return draft_inside(r, family.name, path_of(draw(family, r)));
}

Draft draw_aimed(Random& r) {
  const Family& family = chosen_family(r);
  const DrawnPath path = path_of(draw(family, r));
  int side = r.below(2);
  if (!path.range.ends[side].singular) side = 1 - side;
  const PathRange::End end = path.range.ends[side];
  if (!end.singular && r.chance(0.8)) throw std::runtime_error("nothing to aim at");
  const double at = end.at * (end.singular ? 1 : r.uniform(0.1, 0.9));
  std::vector<double> base = path.range.nominal;
  for (std::size_t k = 0; k < base.size(); ++k) {
    base[k] += at * path.drawn.direction[k];
    if (path.drawn.exact) base[k] = simple(base[k]);
  }
  const double length = std::abs(at) * r.uniform(0.3, 0.95);
  const double distance = r.pick(distances);
  Profile profile =
      aimed_motion(r, drawn_instants(r, path.coordinates), 2 * side - 1, distance, length);
  if (!end.singular) profile.name = profile.name.substr(0, profile.name.find(' ')) + " regular";
  return draft_of(r, family.name, path, base, profile);
}

Draft draw_requested(Random& r) {
  using Json = nlohmann::ordered_json;
  static constexpr std::array levels{"position", "velocity", "acceleration"};
  Draft d = draw_random(r);
  Json request = Json::array();
  const auto add = [&](const char* list, const std::string& name) {
    request.push_back({{list, {name}}, {"level", r.pick(levels)}});
  };
  for (const Mechanism::Point& p : d.mechanism.points)
    if (r.chance(0.2)) add("points", p.name);
  for (const Mechanism::Coordinate& c : d.mechanism.coordinates)
    if (r.chance(0.3)) add(c.is_angle() ? "angles" : "distances", c.name);
  if (request.empty()) add("points", d.mechanism.points.back().name);
  d.request = request.dump();
  if (r.chance(0.3)) d.mode = CheckMode::mechanism;
  return d;
}

namespace {

Draft draft_far(Random& r, const Family& family) {
  const DrawnPath path = path_of(draw(family, r));
  const bool turns = std::ranges::none_of(
      path.drawn.mechanism.coordinates,
      [](const Mechanism::Coordinate& c) { return c.driven && !c.is_angle(); });
  const double far = turns ? 4 * std::numbers::pi : path.drawn.reach;
  const double from = r.uniform(-far, far), to = from + r.uniform(-0.4, 0.4);
  const Profile profile = straight_motion(r, 12 + r.below(12), from, to);
  Draft d = draft_of(r, family.name, path, path.range.nominal, profile);
  d.aim = "far start";
  return d;
}

}  // namespace

Draft draw_far_start(Random& r) {
  const auto plane = plane_families();
  return draft_far(r, r.pick(plane));
}

Draft draw_coupled(Random& r) {
  const auto coupled = coupled_families();
  const Family& family = r.pick(coupled);
  if (r.chance(0.3)) return draft_far(r, family);
  return draft_inside(r, family.name, path_of(draw(family, r)));
}

}  // namespace desmo::properties
