#include <algorithm>
#include <array>
#include <cmath>

#include "tests/fuzz/mutations.h"

namespace desmo::fuzz {
namespace {

/// Points, or directions given by components.
std::vector<Tree*> component_lists(Tree& root, std::initializer_list<std::string_view> members) {
  std::vector<Tree*> lists;
  Tree* const mechanism = mechanism_in(root);
  if (!mechanism) return lists;
  for (const std::string_view member : members)
    if (Tree* const found = mechanism->find(member))
      for (Tree& child : found->children)
        if (child.kind == Tree::Kind::list) lists.push_back(&child);
  return lists;
}

/// About as near as the tolerances of the program, on both sides of them.
double nearly_zero(Random& random) {
  static constexpr std::array<double, 9> sizes = {0,    1e-16, 1e-13, 1e-12, 1e-10,
                                                  1e-9, 1e-8,  1e-7,  1e-5};
  return random.pick(sizes) * random.around_zero();
}

void coincide(Tree& root, Random& random) {
  const std::vector<Tree*> points = component_lists(root, {"points"});
  if (points.empty()) return;
  Tree copy = *random.pick(points);
  for (Tree& x : copy.children) x = scalar(x.number() * (1 + nearly_zero(random)));
  put(*random.pick(points), std::move(copy));
}

void make_parallel(Tree& root, Random& random) {
  const std::vector<Tree*> vectors = component_lists(root, {"vectors"});
  if (vectors.empty()) return;
  Tree copy = *random.pick(vectors);
  const double sign = random.one_in(2) ? 1 : -1;
  for (Tree& x : copy.children) x = scalar(sign * x.number() + nearly_zero(random));
  put(*random.pick(vectors), std::move(copy));
}

void point_along_points(Tree& root, Random& random) {
  const std::vector<Tree*> vectors = component_lists(root, {"vectors"});
  const std::vector<Tree*> points = component_lists(root, {"points"});
  if (vectors.empty() || points.empty()) return;
  const Tree &p = *random.pick(points), &q = *random.pick(points);
  Tree direction = list({});
  for (std::size_t i = 0; i < std::min(p.children.size(), q.children.size()); ++i)
    direction.children.push_back(
        scalar(q.children[i].number() - p.children[i].number() + nearly_zero(random)));
  put(*random.pick(vectors), std::move(direction));
}

void align_points(Tree& root, Random& random) {
  const std::vector<Tree*> points = component_lists(root, {"points"});
  if (points.empty()) return;
  const Tree &p = *random.pick(points), &q = *random.pick(points);
  const double share = random.one_in(2) ? 0.5 : 2 * random.around_zero();
  Tree between = list({});
  for (std::size_t i = 0; i < std::min(p.children.size(), q.children.size()); ++i)
    between.children.push_back(
        scalar(p.children[i].number() * (1 - share) + q.children[i].number() * share));
  put(*random.pick(points), std::move(between));
}

void make_zero(Tree& root, Random& random) {
  const std::vector<Tree*> lists = component_lists(root, {"points", "vectors"});
  if (lists.empty()) return;
  for (Tree& x : random.pick(lists)->children) x = scalar(nearly_zero(random));
}

void flatten(Tree& root, Random& random) {
  const std::size_t component = random.below(3);
  for (Tree* const l : component_lists(root, {"points"}))
    if (l->children.size() > component) l->children[component] = scalar("0");
}

void scale(Tree& root, Random& random) {
  static constexpr std::array<double, 16> factors = {1e-300, 1e-160, 1e-100, 1e-60, 1e-30, 1e-12,
                                                     1e-9,   1e-6,   1e-3,   1e3,   1e6,   1e9,
                                                     1e12,   1e30,   1e60,   1e97};
  const double factor = random.pick(factors);
  for (Tree* const l : component_lists(root, {"points"}))
    for (Tree& x : l->children) x = scalar(x.number() * factor);
}

void shift(Tree& root, Random& random) {
  static constexpr std::array<double, 6> distances = {1, 1e3, 1e6, 1e9, 1e12, 1e16};
  const double distance = random.pick(distances);
  for (Tree* const l : component_lists(root, {"points"}))
    for (Tree& x : l->children) x = scalar(x.number() + distance);
}

void stir(Tree& root, Random& random) {
  const double size = std::pow(10, -static_cast<double>(random.below(8)));
  for (Tree* const l : component_lists(root, {"points"}))
    for (Tree& x : l->children) x = scalar(x.number() * (1 + size * random.around_zero()));
}

void define_otherwise(Tree& root, Random& random) {
  Tree* const mechanism = mechanism_in(root);
  Tree* const vectors = mechanism ? mechanism->find("vectors") : nullptr;
  if (!vectors || vectors->children.empty()) return;
  const std::vector<std::string> points = names_under(*mechanism, "points");
  const std::vector<std::string> names = names_under(*mechanism, "vectors");
  if (points.empty()) return;
  const auto line = [&] {
    return list({string_tree(random.pick(points)), string_tree(random.pick(points))});
  };
  const auto direction = [&] {
    return random.one_in(2) ? string_tree(random.pick(names)) : line();
  };
  Tree definition = object();
  if (random.one_in(2))
    put(definition["along"], line());
  else
    put(definition["normal"], list({direction(), direction()}));
  put(random.pick(vectors->children), std::move(definition));
}

void change_dimension(Tree& root, Random&) {
  Tree* const mechanism = mechanism_in(root);
  Tree* const dimension = mechanism ? mechanism->find("dimension") : nullptr;
  if (!dimension) return;
  const bool was_plane = dimension->text == "2";
  dimension->text = was_plane ? "3" : "2";
  for (Tree* const l : component_lists(root, {"points", "vectors"}))
    if (was_plane)
      l->children.push_back(scalar("0"));
    else if (l->children.size() > 2)
      l->children.resize(2);
}

constexpr TreeMutation all_geometry_mutations[] = {
    coincide, make_parallel, point_along_points, align_points,    make_zero, flatten, scale, shift,
    stir,     stir,          define_otherwise,   change_dimension};

}  // namespace

std::span<const TreeMutation> geometry_mutations() { return all_geometry_mutations; }

}  // namespace desmo::fuzz
