#include "bench/cli/view/page_data.h"

#include <openssl/evp.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "bench/cli/solve/columns.h"
#include "bench/cli/view/drawn_entities.h"
#include "cases/io/files.h"
#include "cases/mechanism/joint_forms.h"
#include "formulations/base/per_level.h"
#include "formulations/modelling/measures/measures.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_plotted = 100'000;  // largest number of values packed for plots alone (≤)

constexpr const char* flag_names[] = {"unproven", "misfit", "failed", "crossing", "branch"};

/// Returns numbers as base64, the lowest byte of each first.
std::string base64(const std::vector<float>& numbers) {
  static_assert(std::endian::native == std::endian::little);
  const std::size_t bytes = numbers.size() * sizeof(float);
  std::vector<unsigned char> text((bytes + 2) / 3 * 4 + 1);  // ends with a 0
  const int size = EVP_EncodeBlock(
      text.data(), reinterpret_cast<const unsigned char*>(numbers.data()), static_cast<int>(bytes));
  return {text.begin(), text.begin() + size};
}

/// Writes the JSON. Appends the numbers of a column, once, when the JSON first refers to it.
class Writer {
 public:
  explicit Writer(const ShownMotion& motion)
      : scene_(motion.scene),
        m_(motion.model),
        motion_(motion),
        shown_(motion.recording.instants()) {
    const std::vector<bool> carried = carried_points(scene_.mechanism);
    for (std::size_t p = 0; p < carried.size(); ++p)
      if (carried[p]) points_.push_back(m_.find(scene_.mechanism.points[p].name));
  }

  std::string operator()() {
    write_about();
    write_geometry();
    write_flags();
    write_plots();
    json_["columns"] = columns_;
    json_["numbers"] = base64(numbers_);
    std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
      text.replace(at, 1, "\\u003c");  // or a text could end the script
    return text;
  }

 private:
  /// Packs a column: appends its numbers to numbers_ and its JSON to columns_. Returns its index
  /// there. Numbers are stored relative to the finite one nearest to 0, so that small motions far
  /// from the origin keep their digits. NaN and infinite numbers stay. value: returns the number of
  /// an instant.
  template <class Value>
  int pack(Json column, const Value& value) {
    std::vector<double> values;
    for (const RecordedInstant& i : shown_) values.push_back(value(i));
    double low = INFINITY, high = -INFINITY;
    for (const double x : values)
      if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    const double origin = low > high ? 0 : std::clamp(0., low, high);
    column["origin"] = origin;
    for (const double x : values) numbers_.push_back(static_cast<float>(x - origin));
    columns_.push_back(std::move(column));
    return static_cast<int>(columns_.size()) - 1;
  }

  using Key = std::tuple<int, Level, std::string>;

  /// Returns the key by which a packed column is found: its index and level in the state, since a
  /// component of a point may have the name of a coordinate; for a constant, its name.
  static Key key_of(const Column& column) {
    return {column.coordinate, column.level, column.coordinate < 0 ? column.name : ""};
  }

  /// Packs a column of the state, unless it is packed already. Returns its index in columns_.
  int pack(const Column& column) {
    const int coordinate = column.coordinate;
    const auto [found, is_new] = packed_.try_emplace(key_of(column), columns_.size());
    if (is_new)
      pack({{"name", column.name},
            {"unit", column.unit.name},
            {"level", column.order},
            {"quantity", coordinate}},
           [&](const RecordedInstant& i) {
             const std::size_t level = i.state.size() / 3 * static_cast<std::size_t>(column.level);
             return column.unit.from_si(
                 coordinate < 0 ? column.constant
                                : i.state[level + static_cast<std::size_t>(coordinate)]);
           });
    return static_cast<int>(found->second);
  }

  void write_about() {
    const CheckedSummary& s = motion_.summary;
    json_["mechanism"] = Json::parse(write_mechanism(scene_.mechanism));
    json_["title"] = scene_.mechanism.title;
    json_["scene"] = scene_.name;
    json_["formulation"] = motion_.formulation;
    json_["coordinates"] = m_.coordinates();
    json_["accuracy"] = describe_radius(s);
    for (const Level level : all_levels) {
      json_["levels"].push_back(level_names[level]);
      json_["units"].push_back(unit_of(motion_.units, EntityKind::point, level).name);
    }
    const DisplayUnit& angle = motion_.units.angle;
    json_["angle_unit"] = {{"name", angle.name}, {"radian", angle.from_si(1)}};
    json_["time"] = {{"start", scene_.grid.start},
                     {"interval", scene_.grid.interval()},
                     {"instants", scene_.grid.instants},
                     {"solved", motion_.recording.solved()},
                     {"stride", motion_.recording.stride()}};
    json_["shown"] = shown_.size();
    for (const RecordedInstant& i : shown_) json_["index"].push_back(i.index);
    for (const Group& g : m_.groups)
      json_["groups"].push_back({{"name", g.name}, {"bodies", g.bodies}, {"constant", g.constant}});
    for (const JointForm& form : joint_forms())
      if (form.dimension == scene_.mechanism.dimension)
        json_["joint_forms"][form.name] = {{"in_plane", form.in_plane},
                                           {"own_vectors", form.own_vectors}};
  }

  /// Returns where a point or vector is found: its fixed components or, at each level, the index of
  /// its first column. The columns of its other components follow that one.
  Json geometry(EntityId entity) {
    const Entity& e = m_.entities[entity];
    Json result = {{"name", e.name}};
    const bool is_point = e.kind == EntityKind::point;
    const Output output{entity, is_point ? Level::acceleration : Level::position};
    for (const Column& column : columns_of(m_, output, motion_.units)) {
      if (e.fixed) {
        if (column.level == Level::position)
          result["fixed"].push_back(column.unit.from_si(column.constant));
        continue;
      }
      const int place = pack(column);
      const char* level = level_names[column.level];
      if (!result.contains(level)) result[level] = place;
    }
    return result;
  }

  /// Writes all points, and the vectors that are drawn.
  void write_geometry() {
    const Mechanism& m = scene_.mechanism;
    json_["points"] = Json::array();
    for (const EntityId point : points_) json_["points"].push_back(geometry(point));
    const std::vector<bool> drawn = drawn_vectors(m);
    json_["vectors"] = Json::array();
    for (std::size_t v = 0; v < drawn.size(); ++v)
      if (drawn[v]) json_["vectors"].push_back(geometry(m_.find(m.vectors[v].name)));
  }

  void write_flags() {
    json_["flags"] = Json::array();
    for (const Flag& flag : motion_.recording.flags()) {
      Json open = Json::array();
      for (const EntityId e : flag.open) open.push_back(m_.entities[e].name);
      json_["flags"].push_back({{"kind", flag_names[static_cast<int>(flag.kind)]},
                                {"from", flag.from},
                                {"to", flag.to},
                                {"text", flag.text},
                                {"open", open}});
    }
  }

  void write_plots() {
    std::vector<Output> outputs = outputs_of(scene_, m_);
    outputs.resize(scene_.request.size());  // those after them are read by measures alone
    const bool requested = !scene_.asks_for_everything();
    json_["requested"] = requested;
    if (!requested) {
      for (const Mechanism::Coordinate& c : scene_.mechanism.coordinates)
        outputs.push_back({m_.find(c.name), Level::acceleration});
      for (const EntityId point : points_)
        if (!m_.is_at_rest(point)) outputs.push_back({point, Level::acceleration});
    }
    json_["driven"] = Json::array();
    for (const Driver& driver : m_.drivers)
      json_["driven"].push_back(
          pack(columns_of(m_, {driver.coordinate, Level::position}, motion_.units)[0]));
    const std::size_t drawn = columns_.size();
    std::size_t wanted = 0;
    json_["plotted"] = Json::array();
    const auto plot = [&](const std::vector<Column>& columns) {
      wanted += columns.size();
      const bool is_drawn = packed_.contains(key_of(columns[0]));
      if (!is_drawn && (columns_.size() - drawn + columns.size()) * shown_.size() > max_plotted)
        return;
      for (const Column& column : columns) json_["plotted"].push_back(pack(column));
    };
    for (const Output& a : outputs) plot(columns_of(m_, a, motion_.units));
    for (const Column& column : columns_of(motion_.measures, m_.coordinates(), motion_.units))
      plot({column});
    json_["wanted"] = wanted;
    json_["condition"] = pack({{"name", "condition number"}, {"unit", "1"}},
                              [](const RecordedInstant& i) { return i.condition; });
    for (const Level level : all_levels)
      json_["radii"].push_back(
          pack({{"name", std::string("radius, ") + level_names[level]}, {"unit", "1"}},
               [&](const RecordedInstant& i) { return i.radius[level]; }));
  }

  const Scene& scene_;
  const Model& m_;
  const ShownMotion& motion_;
  const std::vector<RecordedInstant>& shown_;
  std::vector<EntityId> points_;
  std::map<Key, std::size_t> packed_;  // index in columns_ of each packed column
  Json json_, columns_ = Json::array();
  std::vector<float> numbers_;
};

}  // namespace

std::string page_data(const ShownMotion& motion) { return Writer(motion)(); }

}  // namespace desmo::cli
