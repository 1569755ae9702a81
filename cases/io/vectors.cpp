#include <algorithm>
#include <array>
#include <map>

#include "cases/io/readers.h"
#include "cases/mechanism/directions.h"
#include "cases/mechanism/names.h"
#include "cases/numbers/space.h"

namespace desmo {
namespace {

using Vec = Mechanism::Vec;
using Direction = Mechanism::Direction;

class VectorReader {
 public:
  VectorReader(int dimension, const std::vector<Mechanism::Point>& points, Names& names)
      : dimension_(dimension), points_(points), names_(names) {}

  std::vector<Mechanism::Vector> read(const JsonValue& list) {
    const std::vector<JsonValue> members = list.members();
    for (const JsonValue& member : members) {
      vectors_.push_back({checked_name(member, member.key()), {}, {}});
      names_.vectors.add(member.key());
    }
    for (int i = 0; i < static_cast<int>(members.size()); ++i) read(i, members[i]);
    resolve_normals();
    return std::move(vectors_);
  }

 private:
  struct Normal {
    int vector;
    JsonValue place;
    std::array<Direction, 2> of;
    bool is_waiting = false;  // it is on the path of resolve_normals()
  };

  void read(int i, const JsonValue& value) {
    if (value.is_array()) {
      const Vec components = read_components(value, dimension_);
      const auto unit = unit_vector(components);
      if (!unit) value.complain("a direction of length 0; give a component that is not 0");
      return set(i, *unit, {components[0], components[1], components[2]});
    }
    if (!value.is_object())
      value.complain(
          "is no direction; give a list of components, {\"normal\": [a, b]} or "
          "{\"along\": [P, Q]}");
    value.allow({"normal", "along"});
    const auto normal = value.find("normal"), along = value.find("along");
    if (normal.has_value() == along.has_value())
      value.complain("defines a direction by both or neither of normal and along; give one");
    if (normal) return read_normal(i, *normal);
    vectors_[i].along = names_.points.find_pair(*along);
    const auto [from, to] = *vectors_[i].along;
    set(i, line(*along, from, to), exact({-1, from, to}));
  }

  void set(int i, const Vec& unit, const Mechanism::ExactVec& along) {
    vectors_[i].direction = unit;
    vectors_[i].remainder = remainder_of(unit, along);
  }
  /// Returns a direction as the file means it: a vector of length 1, or the difference of the two
  /// points of a line, times a power of two. Otherwise the product of two short lines would vanish.
  Mechanism::ExactVec exact(const Direction& d) const {
    if (!d.is_line()) return vectors_[d.vector].exact();
    const Mechanism::ExactVec from = points_[d.from].exact(), to = points_[d.to].exact();
    return near_unit({to[0] - from[0], to[1] - from[1], to[2] - from[2]});
  }

  void read_normal(int i, const JsonValue& value) {
    if (dimension_ != 3)
      value.complain("a normal needs three dimensions, this mechanism is plane; give components");
    const std::vector<JsonValue> of = value.elements();
    if (of.size() != 2)
      value.complain("has " + std::to_string(of.size()) + " directions; give two");
    normals_.push_back({i, value, {read_direction(of[0], names_), read_direction(of[1], names_)}});
  }

  Vec line(const JsonValue& place, int from, int to) const {
    if (const auto unit = direction(points_[from].position, points_[to].position)) return *unit;
    place.complain("the points " + in_quotes(points_[from].name) + " and " +
                   in_quotes(points_[to].name) + " coincide; give them different positions");
  }

  Vec resolve(const JsonValue& place, const Direction& d) const {
    return d.is_line() ? line(place, d.from, d.to) : vectors_[d.vector].direction;
  }

  // Resolves each normal after the vectors that define it. Does without recursion, since any depth
  // is possible.
  void resolve_normals() {
    std::map<int, Normal*> normal_of;  // by vector: its normal that is not resolved yet
    for (Normal& normal : normals_) normal_of[normal.vector] = &normal;
    // Returns a normal that has to be resolved before this one; null: none.
    const auto next = [&](const Normal& normal) -> Normal* {
      for (const Direction& d : normal.of)
        if (const auto found = normal_of.find(d.vector); found != normal_of.end())
          return found->second;
      return nullptr;
    };
    std::vector<Normal*> path;  // normals, each of which waits for the one after it
    while (!normal_of.empty()) {
      if (path.empty()) path.push_back(normal_of.begin()->second);
      Normal& last = *path.back();
      last.is_waiting = true;
      if (Normal* before = next(last)) {
        if (before->is_waiting) complain_of_cycle(std::ranges::find(path, before), path.end());
        path.push_back(before);
      } else {
        resolve(last);
        normal_of.erase(last.vector);
        path.pop_back();
      }
    }
  }

  void resolve(const Normal& normal) {
    const auto unit =
        common_normal(resolve(normal.place, normal.of[0]), resolve(normal.place, normal.of[1]));
    if (!unit)
      normal.place.complain(
          "the two directions are parallel and have no common normal; choose "
          "another");
    set(normal.vector, *unit, cross(exact(normal.of[0]), exact(normal.of[1])));
  }

  // Refuses normals in a circle: each is defined by the next, and the last by the first.
  [[noreturn]] void complain_of_cycle(std::vector<Normal*>::iterator first,
                                      std::vector<Normal*>::iterator end) const {
    constexpr int max_shown = 5;
    const auto name = [&](const Normal* n) { return in_quotes(vectors_[n->vector].name); };
    std::string cycle = name(*first);
    for (auto n = first + 1; n != end && n - first < max_shown; ++n) cycle += " of " + name(*n);
    cycle += end - first <= max_shown ? " of " + name(*first) : " and so on";
    (*first)->place.complain("is defined by itself, a normal " + cycle +
                             "; give one of them by components");
  }

  int dimension_;
  const std::vector<Mechanism::Point>& points_;
  Names& names_;
  std::vector<Mechanism::Vector> vectors_;
  std::vector<Normal> normals_;
};

}  // namespace

std::vector<Mechanism::Vector> read_vectors(const JsonValue& root, int dimension,
                                            const std::vector<Mechanism::Point>& points,
                                            Names& names) {
  const auto list = root.find("vectors");
  if (!list) return {};
  return VectorReader(dimension, points, names).read(*list);
}

}  // namespace desmo
