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
      : scene_(scene), names_(scene.mechanism), body_levels_(scene.mechanism.bodies.size()) {}

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
    for (const auto& [key, kind] : {std::pair(&names_.points, Kind::point),
                                    {&names_.vectors, Kind::vector},
                                    {&names_.angles, Kind::coordinate},
                                    {&names_.distances, Kind::coordinate}})
      for (const AskedEntity& asked : names_.read(entry, *key)) want(kind, asked.index, level);
    for (const AskedEntity& body : names_.read(entry, names_.bodies)) want_body(body.index, level);
    for (const auto& [key, kind] : {std::pair(&names_.rotations, MeasureKind::rotation),
                                    {&names_.joints, MeasureKind::joint}})
      for (const AskedEntity& asked : names_.read(entry, *key)) measure(kind, asked, level);
    if (const auto ratios = entry.find("ratios")) {
      if (level_given && level != Level::velocity)
        level_given->complain(
            "a ratio is one of velocities; give \"velocity\" or leave the level out, in an "
            "entry of its own");
      ratios->require_object(R"({"i": ["s", "C.x"]})");
      if (ratios->members().empty())
        ratios->complain("defines nothing; define something or leave it out");
      for (const JsonValue& ratio : ratios->members()) read_ratio(ratio);
    }
  }

  static Level read_level(const JsonValue& value) {
    constexpr std::array<std::string_view, 3> names{"position", "velocity", "acceleration"};
    return static_cast<Level>(value.choose("level", names));
  }

  /// Index in a list of requested entities or measures, by their kind and index in the mechanism.
  template <class Entry>
  using Places = std::map<std::pair<typename Entry::Kind, int>, std::size_t>;

  /// Returns the entry of the same kind and index in a list, at the higher one of both levels. Adds
  /// the entry where there is none.
  template <class Entry>
  static Entry& listed(std::vector<Entry>& list, Places<Entry>& places, const Entry& entry) {
    const auto [place, is_new] = places.try_emplace({entry.kind, entry.index}, list.size());
    if (is_new) list.push_back(entry);
    Entry& known = list[place->second];
    known.level = std::max(known.level, entry.level);
    return known;
  }

  void want(Kind kind, int index, Level level) {
    listed(scene_.request, places_, {kind, index, level});
  }

  void measure(MeasureKind kind, const AskedEntity& asked, Level level) {
    const bool by_pattern = !asked.pattern.empty();
    if (by_pattern) scene_.patterns.emplace(kind, asked.pattern);
    RequestedMeasure& known =
        listed(scene_.measures, measure_places_,
               {.kind = kind, .index = asked.index, .level = level, .by_pattern = by_pattern});
    known.by_pattern = known.by_pattern && by_pattern;
  }

  void read_ratio(const JsonValue& value) {
    const std::string name = checked_name(value, value.key());
    if (!ratios_.insert(name).second)
      value.complain("the name is that of another ratio; choose another");
    const std::vector<JsonValue> of = value.elements();
    if (of.size() != 2) value.complain("has " + std::to_string(of.size()) + " names; give two");
    scene_.measures.push_back({MeasureKind::ratio,
                               Mechanism::none,
                               Level::velocity,
                               name,
                               {names_.read_component(of[0]), names_.read_component(of[1])}});
  }

  // Requests the points and vectors of a body. Returns at once where that level or a higher one was
  // requested before: a request can name a body with many points many times.
  void want_body(int body, Level level) {
    if (body_levels_[body] >= level) return;
    body_levels_[body] = level;
    const Mechanism::Body& of = scene_.mechanism.bodies[body];
    for (const int point : of.points) want(Kind::point, point, level);
    for (const int vector : of.vectors) want(Kind::vector, vector, level);
  }

  void want_everything(Level level) {
    if (everything_level_ >= level) return;
    everything_level_ = level;
    for (const std::string_view name : names_.points.names())
      want(Kind::point, *names_.points.position(name), level);
    for (const std::string_view name : names_.vectors.names())
      want(Kind::vector, *names_.vectors.position(name), level);
    for (int i = 0; i < static_cast<int>(scene_.mechanism.coordinates.size()); ++i)
      want(Kind::coordinate, i, level);
  }

  Scene& scene_;
  Requestable names_;
  std::vector<std::optional<Level>> body_levels_;  // by body: highest level requested so far
  std::optional<Level> everything_level_;          // highest level of "everything" so far
  Places<RequestedEntity> places_;
  Places<RequestedMeasure> measure_places_;
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
