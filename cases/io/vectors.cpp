#include <array>

#include "cases/io/readers.h"
#include "cases/mechanism/directions.h"
#include "cases/mechanism/names.h"

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
    int open = 0;  // vectors it waits for
  };

  void read(int i, const JsonValue& value) {
    if (value.is_array()) {
      const auto unit = unit_vector(read_components(value, dimension_));
      if (!unit) value.complain("a direction of length 0; give a component that is not 0");
      vectors_[i].direction = *unit;
      return;
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
    vectors_[i].direction = line(*along, from, to);
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

  // In the order of what depends on what, which is of any depth: not by recursion.
  void resolve_normals() {
    constexpr int known = -1;
    std::vector<int> defined_by(vectors_.size(), known);
    for (int n = 0; n < static_cast<int>(normals_.size()); ++n) defined_by[normals_[n].vector] = n;
    std::vector<std::vector<int>> waiting(normals_.size());
    std::vector<int> ready;
    for (int n = 0; n < static_cast<int>(normals_.size()); ++n) {
      for (const Direction& d : normals_[n].of)
        if (!d.is_line() && defined_by[d.vector] != known) {
          waiting[defined_by[d.vector]].push_back(n);
          ++normals_[n].open;
        }
      if (normals_[n].open == 0) ready.push_back(n);
    }
    std::size_t resolved = 0;
    for (; !ready.empty(); ++resolved) {
      const int n = ready.back();
      ready.pop_back();
      resolve(normals_[n]);
      for (const int next : waiting[n])
        if (--normals_[next].open == 0) ready.push_back(next);
    }
    if (resolved < normals_.size()) complain_of_cycle(defined_by);
  }

  void resolve(const Normal& normal) {
    const auto unit =
        common_normal(resolve(normal.place, normal.of[0]), resolve(normal.place, normal.of[1]));
    if (!unit)
      normal.place.complain(
          "the two directions are parallel and have no common normal; choose "
          "another");
    vectors_[normal.vector].direction = *unit;
  }

  // Whoever still waits, waits for one that still waits: going on, one comes round again.
  [[noreturn]] void complain_of_cycle(const std::vector<int>& defined_by) const {
    const auto waits_for = [&](int n) {
      for (const Direction& d : normals_[n].of)
        if (!d.is_line() && defined_by[d.vector] >= 0 && normals_[defined_by[d.vector]].open > 0)
          return defined_by[d.vector];
      return n;
    };
    int n = 0;
    while (normals_[n].open == 0) ++n;
    for (std::size_t i = 0; i < normals_.size(); ++i) n = waits_for(n);
    constexpr int max_shown = 5;
    std::string cycle = in_quotes(vectors_[normals_[n].vector].name);
    int next = waits_for(n);
    for (int shown = 1; next != n && shown < max_shown; ++shown, next = waits_for(next))
      cycle += " of " + in_quotes(vectors_[normals_[next].vector].name);
    cycle += next == n ? " of " + in_quotes(vectors_[normals_[n].vector].name) : " and so on";
    normals_[n].place.complain("is defined by itself, a normal " + cycle +
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
