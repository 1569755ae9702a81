#include "tests/fuzz/mutations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace desmo::fuzz {
namespace {

/// Returns points, or directions given by components.
std::vector<Json*> component_lists(Json& root, const char* member) {
  std::vector<Json*> lists;
  Json* const mechanism = mechanism_in(root);
  if (!mechanism || !mechanism->contains(member)) return lists;
  for (Json& child : mechanism->at(member))
    if (child.is_array()) lists.push_back(&child);
  return lists;
}

double number(const Json& value) { return value.is_number() ? value.get<double>() : 0; }

/// Returns a number about as small as the tolerances of the program, on both sides of them.
double nearly_zero(Random& random) {
  static constexpr std::array sizes = {0., 1e-16, 1e-13, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-5};
  const double size = random.pick(sizes);
  return size * random.uniform(-1, 1);
}

/// Replaces a point or vector by a p + b q, nearly.
void combine(Json& root, Random& random) {
  struct Combination {
    const char *replaced, *from;
    double a, b;
  };
  const double share = random.one_in(2) ? 0.5 : 2 * random.uniform(-1, 1);
  const std::array ways = {Combination{"points", "points", 1, 0},  // coincide
                           Combination{"points", "points", share, 1 - share},
                           Combination{"points", "points", 0, 0},
                           Combination{"vectors", "vectors", 1, 0},  // are parallel
                           Combination{"vectors", "vectors", -1, 0},
                           Combination{"vectors", "points", 1, -1},  // along points
                           Combination{"vectors", "vectors", 0, 0}};
  const Combination& way = random.pick(ways);
  const std::vector<Json*> replaced = component_lists(root, way.replaced);
  const std::vector<Json*> from = component_lists(root, way.from);
  const Json p = *random.pick(from), q = *random.pick(from);
  Json result = Json::array();
  for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) {
    const double relative = nearly_zero(random),
                 absolute = random.one_in(2) ? 0 : nearly_zero(random);
    result.push_back((way.a * number(p[i]) + way.b * number(q[i])) * (1 + relative) + absolute);
  }
  *random.pick(replaced) = std::move(result);
}

/// Scales, shifts, stirs or flattens all points.
void transform(Json& root, Random& random) {
  static constexpr std::array factors = {1e-300, 1e-160, 1e-100, 1e-60, 1e-30, 1e-12, 1e-9, 1e-6,
                                         1e-3,   1e3,    1e6,    1e9,   1e12,  1e30,  1e60, 1e97};
  static constexpr std::array distances = {1., 1e3, 1e6, 1e9, 1e12, 1e16};
  const std::size_t way = random.below(5);
  const double factor = way == 0 ? random.pick(factors) : 1;
  const double distance = way == 1 ? random.pick(distances) : 0;
  const std::size_t flat = way == 2 ? random.below(3) : 3;
  const double stir = way > 2 ? std::pow(10, -static_cast<double>(random.below(8))) : 0;
  for (Json* const point : component_lists(root, "points"))
    for (std::size_t i = 0; i < point->size(); ++i) {
      const double x = number(point->at(i)) * factor * (1 + stir * random.uniform(-1, 1));
      point->at(i) = i == flat ? 0 : x + distance;
    }
}

void change_dimension(Json& root) {
  Json* const mechanism = mechanism_in(root);
  if (!mechanism || !mechanism->contains("dimension")) throw NothingToPick();
  const bool was_plane = mechanism->at("dimension") == 2;
  mechanism->at("dimension") = was_plane ? 3 : 2;
  for (const char* member : {"points", "vectors"})
    for (Json* const list : component_lists(root, member))
      if (was_plane)
        list->push_back(0);
      else if (list->size() > 2)
        list->erase(2);
}

}  // namespace

void move_geometry(Json& root, Random& random) {
  const std::size_t way = random.below(12);
  if (way == 0)
    change_dimension(root);
  else if (way < 6)
    transform(root, random);
  else
    combine(root, random);
}

void remove_body(Json& root, Random& random) {
  Json* const mechanism = mechanism_in(root);
  if (!mechanism || mechanism->value("bodies", Json()).empty()) throw NothingToPick();
  Json& bodies = mechanism->at("bodies");
  const auto body =
      std::next(bodies.begin(), static_cast<std::ptrdiff_t>(random.below(bodies.size())));
  const Json name = body.key();
  bodies.erase(body);
  Json left = Json::array();
  for (const Json& joint : mechanism->at("joints"))
    if (std::ranges::find(joint.at("bodies"), name) == joint.at("bodies").end())
      left.push_back(joint);
  mechanism->at("joints") = std::move(left);
}

void repeat_member(Json& root, Random& random) {
  std::vector<Json*> objects = {&root};
  for (std::size_t i = 0; i < objects.size(); ++i)
    for (Json& inner : *objects[i])
      if (inner.is_structured()) objects.push_back(&inner);
  std::erase_if(objects, [](const Json* value) { return !value->is_object() || value->empty(); });
  auto& members = random.pick(objects)->get_ref<Json::object_t&>();
  // Its emplace() would not.
  members.push_back(Json::object_t::value_type(random.pick(members)));
}

void give_motion_to_drivers(Json& root) {
  Json* const mechanism = mechanism_in(root);
  if (!mechanism || mechanism == &root) return;
  Json motions = Json::object();
  for (const Json& driver : mechanism->value("drivers", Json::array()))
    if (driver.is_string()) {
      const std::string name = driver;
      const Json given = root.value("motion", Json::object());
      motions[name] =
          given.contains(name) ? given[name] : Json{{"type", "constant"}, {"value", 0.7}};
    }
  if (!motions.empty()) root["motion"] = std::move(motions);
}

}  // namespace desmo::fuzz
