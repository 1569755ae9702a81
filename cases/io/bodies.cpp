// Points and bodies of a mechanism file.
#include <cmath>

#include "cases/io/readers.h"
#include "cases/mechanism/names.h"
#include "cases/numbers/space.h"

namespace desmo {
namespace {

using Vec = Mechanism::Vec;

using Exact = Mechanism::ExactVec;

double length(const Vec& x) { return std::hypot(x[0], x[1], x[2]); }
Derived length(const Exact& x) { return sqrt(dot(x, x)); }

/// Returns a vector turned by a rotation vector [rad].
template <class S>
std::array<S, 3> turned(const std::array<S, 3>& x, const std::array<S, 3>& rotation) {
  const S angle = length(rotation);
  if (as<double>(angle) == 0) return x;
  return turned_about({rotation[0] / angle, rotation[1] / angle, rotation[2] / angle}, angle, x);
}

/// The place of a frame as the file means it. Mechanism::Frame has it rounded.
struct ExactPlace {
  Exact origin{}, rotation{};

  Exact position(const Exact& local) const {
    Exact x = turned(local, rotation);
    for (int i = 0; i < 3; ++i) x[i] = x[i] + origin[i];
    return x;
  }
};

/// Returns what the rounded components of a vector lack.
std::array<Remainder, 3> remainder_of(const Exact& exact, const Vec& rounded) {
  std::array<Remainder, 3> all;
  for (int i = 0; i < 3; ++i) all[i] = exact[i].about(rounded[i]).remainder();
  return all;
}

class BodyReader {
 public:
  BodyReader(Mechanism& mechanism, const DisplayUnits& units, Names& names)
      : mechanism_(mechanism), units_(units), names_(names) {}

  void read(const JsonValue& root) {
    const JsonValue ground = root["ground"];
    ground.allow({"points", "vectors"});
    mechanism_.bodies.push_back({"ground"});
    names_.bodies.add(ground.key());
    const std::vector<JsonValue> members = root["bodies"].members();
    for (const JsonValue& value : members) {
      if (value.key() == ground.key())
        value.complain("'ground' is the name of the ground; choose another for this body");
      value.require_object(R"({"points": ["A", "B"]})");
      value.allow({"at", "points", "vectors", "length"});
      mechanism_.bodies.push_back({checked_name(value, value.key())});
      names_.bodies.add(value.key());
    }
    drawn_points_ = mechanism_.points.size();
    drawn_vectors_ = mechanism_.vectors.size();
    for (std::size_t b = 0; b < members.size(); ++b)
      if (has_frame(members[b])) read_shape(members[b], mechanism_.bodies[b + 1]);
    read_lists(ground, mechanism_.bodies.front());
    for (std::size_t b = 0; b < members.size(); ++b)
      if (!has_frame(members[b])) read_lists(members[b], mechanism_.bodies[b + 1]);
  }

 private:
  static bool has_frame(const JsonValue& body) {
    const auto points = body.find("points"), vectors = body.find("vectors");
    return body.find("at") || (points && points->is_object()) || (vectors && vectors->is_object());
  }

  void read_shape(const JsonValue& value, Mechanism::Body& body) {
    value.allow({"at", "points", "vectors"});
    Mechanism::Frame& frame = body.own.emplace();
    ExactPlace exact = read_place(value["at"], frame);
    Names own;
    std::vector<Mechanism::Point> points;
    if (const auto list = value.find("points"))
      points = read_points(*list, mechanism_.dimension, units_, own);
    meet_what_is_drawn(points, frame, exact);
    for (const Mechanism::Point& p : points) {
      const Vec x = drawn_position(frame, p.position);
      body.points.push_back(place(mechanism_.points, names_.points, own.points, body.points,
                                  {p.name, x, remainder_of(exact.position(p.exact()), x)}));
      frame.points.push_back(p.exact());
    }
    for (const auto& [name, u, along, remainder] :
         read_vectors(value, mechanism_.dimension, points, own)) {
      frame.vectors.push_back(Mechanism::exact(u, remainder));
      const Vec x = turned(u, frame.rotation);
      const Exact meant = turned(frame.vectors.back(), exact.rotation);
      body.vectors.push_back(place(mechanism_.vectors, names_.vectors, own.vectors, body.vectors,
                                   {name, x, {}, remainder_of(meant, x)}));
    }
  }

  /// Moves a frame in which some points have been placed before, and some have not. The points
  /// placed before are then, on average, where they were placed.
  void meet_what_is_drawn(const std::vector<Mechanism::Point>& points, Mechanism::Frame& frame,
                          ExactPlace& exact) const {
    Vec way{};
    Exact exact_way{};
    std::size_t drawn = 0;
    for (const Mechanism::Point& p : points)
      if (const auto known = names_.points.position(p.name)) {
        const Vec to = mechanism_.points[*known].position, from = drawn_position(frame, p.position);
        const Exact target = mechanism_.points[*known].exact(), begin = exact.position(p.exact());
        for (int i = 0; i < 3; ++i) {
          way[i] += to[i] - from[i];
          exact_way[i] = exact_way[i] + target[i] - begin[i];
        }
        ++drawn;
      }
    if (drawn == 0 || drawn == points.size()) return;
    for (int i = 0; i < 3; ++i) {
      frame.origin[i] += way[i] / static_cast<double>(drawn);
      exact.origin[i] = exact.origin[i] + exact_way[i] / static_cast<double>(drawn);
    }
  }

  /// Returns the index in `all` of an entity of a body's frame. Adds it to `all` and its name to
  /// `names` unless the name is there.
  /// - own: names of the frame's entities, in the order in which they are placed
  /// - listed: indices of those placed before this one
  template <class Entity>
  static int place(std::vector<Entity>& all, NameTable& names, const NameTable& own,
                   const std::vector<int>& listed, Entity entity) {
    const std::string_view name = own.names()[listed.size()];
    if (const auto known = names.position(name)) return *known;
    names.add(name);
    all.push_back(std::move(entity));
    return static_cast<int>(all.size()) - 1;
  }

  ExactPlace read_place(const JsonValue& value, Mechanism::Frame& frame) const {
    ExactPlace exact;
    const std::vector<JsonValue> numbers = value.elements();
    const int n = mechanism_.dimension;
    if (numbers.size() != static_cast<std::size_t>(n == 2 ? 3 : 6))
      value.complain("has " + std::to_string(numbers.size()) + " numbers; give the origin and " +
                     (n == 2 ? "the angle: three" : "the rotation vector: six"));
    for (int i = 0; i < n; ++i) {
      frame.origin[i] = numbers[i].number() * units_.length.in_si;
      exact.origin[i] = Derived(numbers[i].number()) * units_.length.in_si;
    }
    for (std::size_t i = n; i < numbers.size(); ++i) {
      const std::size_t k = n == 2 ? 2 : i - n;
      frame.rotation[k] = numbers[i].number() * units_.angle.in_si;
      exact.rotation[k] = exact_size(units_.angle) * numbers[i].number();
    }
    return exact;
  }

  void read_lists(const JsonValue& value, Mechanism::Body& body) const {
    const auto points = value.find("points"), vectors = value.find("vectors");
    if (const auto length = value.find("length"))
      body.length = Derived(length->number()) * units_.length.in_si;
    if (points) body.points = names_.points.find_each(*points);
    if (vectors) body.vectors = names_.vectors.find_each(*vectors);
    if (points && !body.length) require_drawn(*points, "point", body.points, drawn_points_);
    if (vectors) require_drawn(*vectors, "vector", body.vectors, drawn_vectors_);
  }

  /// Refuses an entity in the list of a body without a frame that is given in frames only. A frame
  /// places it by an estimate, and this body needs its exact place.
  static void require_drawn(const JsonValue& list, const std::string& kind,
                            const std::vector<int>& listed, std::size_t drawn) {
    const std::vector<JsonValue> names = list.elements();
    for (std::size_t k = 0; k < listed.size(); ++k)
      if (listed[k] >= static_cast<int>(drawn))
        names[k].complain("the " + kind + " " + in_quotes(names[k].text()) +
                          " is given in the frame of another body only, which is an estimate; "
                          "add it to the file's \"" +
                          kind + "s\", or give this body a frame, too, by \"at\"");
  }

  Mechanism& mechanism_;
  const DisplayUnits& units_;
  Names& names_;
  // Numbers of entities in the file's own "points" and "vectors". Those of frames come after them.
  std::size_t drawn_points_ = 0, drawn_vectors_ = 0;
};

}  // namespace

Vec drawn_position(const Mechanism::Frame& frame, const Vec& local) {
  Vec x = turned(local, frame.rotation);
  for (int i = 0; i < 3; ++i) x[i] += frame.origin[i];
  return x;
}

void set_position(Mechanism::Point& point, const Vec& numbers, const DisplayUnit& unit) {
  for (int i = 0; i < 3; ++i) {
    const Derived x = Derived(numbers[i]) * unit.in_si;
    point.position[i] = x.value;
    point.remainder[i] = x.remainder();
  }
}

std::vector<Mechanism::Point> read_points(const JsonValue& list, int dimension,
                                          const DisplayUnits& units, Names& names) {
  std::vector<Mechanism::Point> points;
  for (const JsonValue& value : list.members()) {
    Mechanism::Point& point = points.emplace_back();
    point.name = checked_name(value, value.key());
    set_position(point, read_components(value, dimension), units.length);
    names.points.add(value.key());
  }
  return points;
}

void read_bodies(const JsonValue& root, Mechanism& mechanism, const DisplayUnits& units,
                 Names& names) {
  BodyReader(mechanism, units, names).read(root);
}

}  // namespace desmo
