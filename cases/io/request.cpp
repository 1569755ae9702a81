#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "cases/io/readers.h"
#include "cases/mechanism/carriers.h"
#include "cases/mechanism/joint_forms.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

using Kind = RequestedEntity::Kind;
using MeasureKind = RequestedMeasure::Kind;

constexpr int max_patterns = 100;  // each is compared with every name

// One key of a request: what can be asked for under it, by name and position in the mechanism.
struct Selection : NameTable {
  Selection(std::string key, std::string kind) : NameTable(std::move(kind)), key(std::move(key)) {}

  std::vector<int> match(const JsonValue& pattern) const {
    std::vector<int> found;
    for (const std::string_view name : names())
      if (matches(pattern.text(), name)) found.push_back(*position(name));
    if (found.empty())
      pattern.complain("the pattern " + in_quotes(pattern.text()) + " matches none of the " + key +
                       "; " + suggestion(pattern.text(), names()));
    return found;
  }

  const std::string key;
};

class RequestReader {
 public:
  explicit RequestReader(Scene& scene)
      : d_(scene.mechanism),
        body_levels_(d_.bodies.size()),
        wanted_(scene.request),
        measures_(scene.measures) {
    fill_selections();
  }

  void read(const std::vector<JsonValue>& entries) {
    for (const JsonValue& entry : entries) read_entry(entry);
  }

 private:
  void fill_selections() {
    using enum Mechanism::CoordinateType;
    const Carriers points(d_, &Mechanism::Body::points), vectors(d_, &Mechanism::Body::vectors);
    for (std::size_t i = 0; i < d_.points.size(); ++i)
      if (points.is_carried(static_cast<int>(i)))
        points_.add(d_.points[i].name, static_cast<int>(i));
    for (std::size_t i = 0; i < d_.vectors.size(); ++i)
      if (vectors.is_carried(static_cast<int>(i)))
        vectors_.add(d_.vectors[i].name, static_cast<int>(i));
    for (std::size_t i = 0; i < d_.coordinates.size(); ++i)
      (d_.coordinates[i].type == angle ? angles_ : distances_)
          .add(d_.coordinates[i].name, static_cast<int>(i));
    for (std::size_t i = 0; i < d_.bodies.size(); ++i)
      bodies_.add(d_.bodies[i].name, static_cast<int>(i));
    for (std::size_t i = 1; i < d_.bodies.size(); ++i)
      rotations_.add(d_.bodies[i].name, static_cast<int>(i));
    for (std::size_t i = 0; i < d_.joints.size(); ++i)
      if (turns(d_.joints[i].type) || slides(d_.joints[i].type))
        joints_.add(d_.joints[i].name, static_cast<int>(i));
  }

  void read_entry(const JsonValue& entry) {
    entry.allow({"points", "vectors", "angles", "distances", "bodies", "rotations", "joints",
                 "ratios", "everything", "level"});
    const auto level_given = entry.find("level");
    const Level level = level_given ? read_level(*level_given) : Level::position;
    if (const auto everything = entry.find("everything")) {
      if (!everything->boolean()) everything->complain("is false; make it true or leave it out");
      if (entry.members().size() > (level_given ? 2u : 1u))
        entry.complain("asks for everything and more; leave the rest out");
      return want_everything(level);
    }
    if (entry.members().size() == (level_given ? 1u : 0u))
      entry.complain(
          "asks for nothing; give points, vectors, angles, distances, bodies, rotations, joints, "
          "ratios or \"everything\": true");
    const auto want_kind = [&](Kind kind) {
      return [this, kind, level](int i) { want(kind, i, level); };
    };
    read_names(entry, points_, want_kind(Kind::point));
    read_names(entry, vectors_, want_kind(Kind::vector));
    read_names(entry, angles_, want_kind(Kind::coordinate));
    read_names(entry, distances_, want_kind(Kind::coordinate));
    read_names(entry, bodies_, [&](int i) { want_body(i, level); });
    read_names(entry, rotations_, [&](int i) { measure(MeasureKind::rotation, i, level); });
    read_names(entry, joints_, [&](int i) { measure(MeasureKind::joint, i, level); });
    if (const auto ratios = entry.find("ratios")) {
      if (level_given && level != Level::velocity)
        level_given->complain(
            "a ratio is one of velocities; give \"velocity\" or leave the level out, in an entry "
            "of "
            "its own");
      for (const JsonValue& ratio : ratios->members()) read_ratio(ratio);
    }
  }

  static Level read_level(const JsonValue& value) {
    constexpr std::array<std::string_view, 3> names{"position", "velocity", "acceleration"};
    return static_cast<Level>(value.choose("level", names));
  }

  void read_names(const JsonValue& entry, const Selection& selection,
                  const std::function<void(int)>& want) {
    const auto list = entry.find(selection.key);
    if (!list) return;
    if (list->is_object() && defines_in_place(selection)) {
      for (const JsonValue& defined : list->members()) want(selection.find(defined, defined.key()));
      return;
    }
    const std::vector<JsonValue> names = list->elements();
    if (names.empty()) list->complain("is an empty list; name something or leave it out");
    for (const JsonValue& name : names) {
      if (name.is_object() && defines_in_place(selection))
        name.complain("defines something in a list of names; give \"" + selection.key +
                      "\": {\"NAME\": …} in an entry of its own");
      if (name.text().find('*') != std::string_view::npos) {
        check_pattern(name);
        for (const int i : selection.match(name)) want(i);
      } else {
        check_kind(name, selection);
        if (&selection == &joints_) check_joint(name);
        want(selection.find(name));
      }
    }
  }

  bool defines_in_place(const Selection& selection) const {
    return &selection == &points_ || &selection == &angles_ || &selection == &distances_;
  }

  void check_pattern(const JsonValue& pattern) {
    if (characters(pattern.text()) > max_name)
      pattern.complain("the pattern is longer than " + std::to_string(max_name) +
                       " characters; shorten it");
    if (++patterns_ > max_patterns)
      pattern.complain("the request has more than " + std::to_string(max_patterns) +
                       " patterns with *; join some");
  }

  // Refuses a name of another kind, and one that no body carries. It is more likely meant than a
  // similar one of this kind, which a complaint about an unknown name would offer.
  void check_kind(const JsonValue& name, const Selection& selection) const {
    if (selection.position(name.text()) || &selection == &rotations_ || &selection == &joints_)
      return;
    for (const Selection* other : {&points_, &vectors_, &angles_, &distances_, &bodies_})
      if (other->position(name.text()))
        name.complain(in_quotes(name.text()) + " is none of the " + selection.key +
                      "; ask for it under \"" + other->key + "\"");
    const auto is_named = [&](const auto& entry) { return entry.name == name.text(); };
    if (std::ranges::any_of(d_.points, is_named) || std::ranges::any_of(d_.vectors, is_named))
      name.complain(in_quotes(name.text()) +
                    " is carried by no body and has no motion; list it in a body");
  }

  // Refuses a joint that has neither a turn nor a travel.
  void check_joint(const JsonValue& name) const {
    if (joints_.position(name.text())) return;
    const auto joint = std::ranges::find(d_.joints, name.text(), &Mechanism::Joint::name);
    if (joint == d_.joints.end()) return;
    name.complain(in_quotes(name.text()) + " is a joint of type " +
                  in_quotes(find_joint_form(joint->type, d_.dimension)->name) +
                  ", which neither turns about one axis nor slides along one; ask for rotations or "
                  "points of its bodies");
  }

  void want(Kind kind, int index, Level level) {
    const auto [place, is_new] = places_.try_emplace({kind, index}, wanted_.size());
    if (is_new) wanted_.push_back({kind, index, level});
    Level& known = wanted_[place->second].level;
    known = std::max(known, level);
  }

  void measure(MeasureKind kind, int index, Level level) {
    const auto [place, is_new] = measure_places_.try_emplace({kind, index}, measures_.size());
    if (is_new) measures_.push_back({kind, index, level});
    Level& known = measures_[place->second].level;
    known = std::max(known, level);
  }

  void read_ratio(const JsonValue& value) {
    const std::string name = checked_name(value, value.key());
    if (!ratios_.insert(name).second)
      value.complain("the name is that of another ratio; choose another");
    const std::vector<JsonValue> of = value.elements();
    if (of.size() != 2) value.complain("has " + std::to_string(of.size()) + " names; give two");
    measures_.push_back({MeasureKind::ratio,
                         Mechanism::none,
                         Level::velocity,
                         name,
                         {component(of[0]), component(of[1])}});
  }

  /// Reads the name of a coordinate, or of a component of a point or vector: "C.x".
  std::string component(const JsonValue& value) const {
    const std::string_view name = value.text(), entity = name.substr(0, name.rfind('.'));
    const bool is_component = entity.size() + 2 == name.size() &&
                              std::string_view("xyz").substr(0, d_.dimension).find(name.back()) !=
                                  std::string_view::npos &&
                              (points_.position(entity) || vectors_.position(entity));
    if (!is_component && !angles_.position(name) && !distances_.position(name)) {
      std::vector<std::string_view> known;
      for (const Mechanism::Coordinate& c : d_.coordinates) known.push_back(c.name);
      value.complain("unknown coordinate " + in_quotes(name) +
                     "; give one, or a component of a point or vector such as 'C.x'; " +
                     suggestion(name, known));
    }
    return std::string(name);
  }

  // Once at each level: a request can name a body with many points many times.
  void want_body(int body, Level level) {
    if (body_levels_[body] >= level) return;
    body_levels_[body] = level;
    for (const int point : d_.bodies[body].points) want(Kind::point, point, level);
    for (const int vector : d_.bodies[body].vectors) want(Kind::vector, vector, level);
  }

  void want_everything(Level level) {
    if (everything_level_ >= level) return;
    everything_level_ = level;
    for (const std::string_view name : points_.names())
      want(Kind::point, *points_.position(name), level);
    for (const std::string_view name : vectors_.names())
      want(Kind::vector, *vectors_.position(name), level);
    for (int i = 0; i < static_cast<int>(d_.coordinates.size()); ++i)
      want(Kind::coordinate, i, level);
  }

  const Mechanism& d_;
  std::vector<std::optional<Level>> body_levels_;
  std::optional<Level> everything_level_;
  int patterns_ = 0;
  std::vector<RequestedEntity>& wanted_;
  std::vector<RequestedMeasure>& measures_;
  std::map<std::pair<Kind, int>, std::size_t> places_;  // in it, of what is wanted
  std::map<std::pair<MeasureKind, int>, std::size_t> measure_places_;
  std::set<std::string> ratios_;
  Selection points_{"points", "point"}, vectors_{"vectors", "vector"}, angles_{"angles", "angle"},
      distances_{"distances", "distance"}, bodies_{"bodies", "body"},
      rotations_{"rotations", "moving body"}, joints_{"joints", "joint that turns or slides"};
};

}  // namespace

void read_request(const JsonValue& root, const FileUnits& units, Scene& scene) {
  const auto list = root.find("request");
  if (!list) return;
  const std::vector<JsonValue> entries = list->elements();
  if (entries.empty()) list->complain("asks for nothing; leave it out to ask for everything");
  add_definitions(entries, units, scene.mechanism);
  RequestReader(scene).read(entries);
}

}  // namespace desmo
