#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "cases/io/readers.h"
#include "cases/io/requestable.h"

namespace desmo {
namespace {

using Kind = RequestedEntity::Kind;
using MeasureKind = RequestedMeasure::Kind;

class RequestReader {
 public:
  explicit RequestReader(Scene& scene)
      : d_(scene.mechanism),
        names_(d_),
        body_levels_(d_.bodies.size()),
        wanted_(scene.request),
        measures_(scene.measures),
        patterns_(scene.patterns) {}

  void read(const std::vector<JsonValue>& entries) {
    for (const JsonValue& entry : entries) read_entry(entry);
  }

 private:
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
      return [this, kind, level](int i, auto) { want(kind, i, level); };
    };
    names_.read(entry, names_.points, want_kind(Kind::point));
    names_.read(entry, names_.vectors, want_kind(Kind::vector));
    names_.read(entry, names_.angles, want_kind(Kind::coordinate));
    names_.read(entry, names_.distances, want_kind(Kind::coordinate));
    const auto measure_kind = [&](MeasureKind kind) {
      return [this, kind, level](int i, std::string_view by) { measure(kind, i, level, by); };
    };
    names_.read(entry, names_.bodies, [&](int i, auto) { want_body(i, level); });
    names_.read(entry, names_.rotations, measure_kind(MeasureKind::rotation));
    names_.read(entry, names_.joints, measure_kind(MeasureKind::joint));
    if (const auto ratios = entry.find("ratios")) {
      if (level_given && level != Level::velocity)
        level_given->complain(
            "a ratio is one of velocities; give \"velocity\" or leave the level out, in an "
            "entry of its own");
      ratios->require_object(R"({"i": ["s", "C.x"]})");
      for (const JsonValue& ratio : ratios->members()) read_ratio(ratio);
    }
  }

  static Level read_level(const JsonValue& value) {
    constexpr std::array<std::string_view, 3> names{"position", "velocity", "acceleration"};
    return static_cast<Level>(value.choose("level", names));
  }

  void want(Kind kind, int index, Level level) {
    const auto [place, is_new] = places_.try_emplace({kind, index}, wanted_.size());
    if (is_new) wanted_.push_back({kind, index, level});
    Level& known = wanted_[place->second].level;
    known = std::max(known, level);
  }

  void measure(MeasureKind kind, int index, Level level, std::string_view pattern) {
    const bool by_pattern = !pattern.empty();
    if (by_pattern) patterns_.emplace(kind, pattern);
    const auto [place, is_new] = measure_places_.try_emplace({kind, index}, measures_.size());
    if (is_new)
      measures_.push_back({.kind = kind, .index = index, .level = level, .by_pattern = by_pattern});
    RequestedMeasure& known = measures_[place->second];
    known.level = std::max(known.level, level);
    known.by_pattern = known.by_pattern && by_pattern;
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
                         {names_.read_component(of[0]), names_.read_component(of[1])}});
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
    for (const std::string_view name : names_.points.names())
      want(Kind::point, *names_.points.position(name), level);
    for (const std::string_view name : names_.vectors.names())
      want(Kind::vector, *names_.vectors.position(name), level);
    for (int i = 0; i < static_cast<int>(d_.coordinates.size()); ++i)
      want(Kind::coordinate, i, level);
  }

  const Mechanism& d_;
  Requestable names_;
  std::vector<std::optional<Level>> body_levels_;
  std::optional<Level> everything_level_;
  std::vector<RequestedEntity>& wanted_;
  std::vector<RequestedMeasure>& measures_;
  std::set<std::pair<MeasureKind, std::string>>& patterns_;
  std::map<std::pair<Kind, int>, std::size_t> places_;                 // in wanted_
  std::map<std::pair<MeasureKind, int>, std::size_t> measure_places_;  // in measures_
  std::set<std::string> ratios_;
};

}  // namespace

void read_request(const JsonValue& root, const FileUnits& units, Scene& scene) {
  const auto list = root.find("request");
  if (!list) return;
  const std::vector<JsonValue> entries = list->elements();
  if (entries.empty()) list->complain("asks for nothing; leave it out to ask for everything");
  for (const JsonValue& entry : entries) entry.require_object(R"({"points": ["C"]})");
  add_definitions(entries, units, scene.mechanism);
  RequestReader(scene).read(entries);
}

}  // namespace desmo
