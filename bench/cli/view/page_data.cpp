#include "bench/cli/view/page_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/cli/solve/columns.h"
#include "bench/cli/view/packing.h"
#include "cases/io/files.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

// Steps to which numbers are rounded.
constexpr double planar_step = 1e-8, spatial_step = 2e-5;  // of positions, in mechanism's sizes
constexpr double direction_step = 1e-4;
constexpr double rate_step = 1. / 2000;       // of the largest rate
constexpr std::size_t max_plotted = 360'000;  // numbers

constexpr const char* level_names[] = {"position", "velocity", "acceleration"};
constexpr const char* flag_names[] = {"degraded", "failed", "crossing", "branch"};

/// Writes the JSON, and packs a column whenever it names one.
class Writer {
 public:
  Writer(const ShownMotion& motion, int every)
      : scene_(motion.scene), m_(motion.model), motion_(motion) {
    const auto& instants = motion.recording.instants();
    stride_ = motion.recording.stride() * every;
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const bool before_gap = i + 1 == instants.size() ||
                              instants[i + 1].index > instants[i].index + motion.recording.stride();
      if (i % static_cast<std::size_t>(every) == 0 || before_gap) shown_.push_back(&instants[i]);
    }
    for (const Mechanism::Point& point : scene_.mechanism.points)
      points_.push_back(m_.find(point.name));
    measure();
  }

  PageData operator()() {
    write_about();
    write_geometry();
    write_flags();
    write_plots();
    json_["columns"] = columns_;
    PageData result{json_.dump(-1, ' ', false, Json::error_handler_t::replace), packed_.text()};
    for (std::size_t at = 0; (at = result.json.find('<', at)) != std::string::npos;)
      result.json.replace(at, 1, "\\u003c");  // or a text could end the script
    return result;
  }

 private:
  /// Finds the size of the mechanism, the diagonal of the box of all points, and its largest rates.
  void measure() {
    double squares = 0;
    for (int axis = 0; axis < scene_.mechanism.dimension; ++axis) {
      double low = INFINITY, high = -INFINITY;
      for (const EntityId point : points_) {
        const Entity& e = m_.entities[point];
        for (const RecordedInstant* i : shown_) {
          const double x = e.fixed ? m_.fixed_values[e.first + axis] : i->state[e.first + axis];
          low = std::min(low, x), high = std::max(high, x);
          for (int level = 1; level < 3 && !e.fixed; ++level)
            largest_[level] =
                std::max(largest_[level], std::abs(i->state[place(e.first + axis, level)]));
        }
      }
      squares += (high - low) * (high - low);
    }
    if (squares > 0) largest_[0] = std::sqrt(squares);
    for (double& largest : largest_)
      if (!(largest > 0)) largest = 1;
  }

  std::size_t place(int coordinate, int level) const {
    return static_cast<std::size_t>(level * m_.coordinates() + coordinate);
  }

  /// Packs a column and returns its number. step: 0 for floats. value: of an instant.
  template <class Value>
  int pack(Json column, double step, const Value& value) {
    std::vector<double> values;
    for (const RecordedInstant* i : shown_) values.push_back(value(*i));
    if (step > 0) {
      const double origin = values.front();
      for (double& x : values) x -= origin;
      column["origin"] = origin;
      column["step"] = step;
      packed_.add_multiples(values, step);
    } else {
      packed_.add_floats(values);
    }
    columns_.push_back(std::move(column));
    return static_cast<int>(columns_.size()) - 1;
  }

  void write_about() {
    const MonitoredSummary& s = motion_.summary;
    json_["mechanism"] = Json::parse(write_mechanism(scene_.mechanism));
    json_["title"] = scene_.mechanism.title;
    json_["scene"] = scene_.name;
    json_["formulation"] = motion_.formulation;
    json_["coordinates"] = m_.coordinates();
    json_["accuracy"] = describe_accuracy(s.condition, s.bound, Level::acceleration);
    json_["size"] = largest_[0];
    json_["largest"] = {{"velocity", largest_[1]}, {"acceleration", largest_[2]}};
    json_["time"] = {{"start", scene_.grid.start},
                     {"interval", scene_.grid.interval()},
                     {"instants", scene_.grid.instants},
                     {"solved", motion_.recording.solved()},
                     {"stride", stride_}};
    json_["shown"] = shown_.size();
    pack({{"name", "index"}}, 1, [](const RecordedInstant& i) { return i.index; });
    for (const Group& g : m_.groups)
      json_["groups"].push_back({{"name", g.name}, {"bodies", g.bodies}, {"constant", g.constant}});
  }

  /// Writes where a point or vector is found: the first of its columns, one for each component.
  Json geometry(EntityId entity) {
    const Entity& e = m_.entities[entity];
    Json result = {{"name", e.name}};
    if (e.fixed) {
      for (int i = 0; i < e.size; ++i) result["fixed"].push_back(m_.fixed_values[e.first + i]);
      return result;
    }
    const bool is_point = e.kind == EntityKind::point;
    const double position_step = e.size == 2 ? planar_step : spatial_step;
    for (int level = 0; level < (is_point ? 3 : 1); ++level) {
      const double step =
          !is_point ? direction_step : largest_[level] * (level == 0 ? position_step : rate_step);
      result[level_names[level]] = columns_.size();
      for (int i = e.first; i < e.first + e.size; ++i)
        pack(Json::object(), step,
             [&](const RecordedInstant& instant) { return instant.state[place(i, level)]; });
    }
    return result;
  }

  /// Writes all points, and the vectors that are drawn.
  void write_geometry() {
    const Mechanism& m = scene_.mechanism;
    for (const EntityId point : points_) json_["points"].push_back(geometry(point));
    std::vector<bool> drawn(m.vectors.size());
    for (const Mechanism::Joint& joint : m.joints)
      for (const int v : joint.vectors) drawn[v] = true;
    for (const Mechanism::Coordinate& c : m.coordinates)
      for (const int v : {c.of.vector, c.from.vector, c.vector})
        if (c.driven && v >= 0) drawn[v] = true;
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

  /// Packs a column that is plotted, unless it is packed already. Returns its number.
  int plot(const Column& column) {
    const auto [found, is_new] = plotted_.try_emplace(column.name, columns_.size());
    if (is_new)
      pack(
          {{"name", column.name}, {"unit", column.unit}, {"level", static_cast<int>(column.level)}},
          0, [&](const RecordedInstant& i) {
            return column.coordinate < 0
                       ? column.constant
                       : i.state[place(column.coordinate, static_cast<int>(column.level))];
          });
    return static_cast<int>(found->second);
  }

  void write_plots() {
    std::vector<Output> outputs = outputs_of(scene_, m_);
    json_["requested"] = !scene_.request.empty();
    if (scene_.request.empty()) {
      for (const Mechanism::Coordinate& c : scene_.mechanism.coordinates)
        outputs.push_back({m_.find(c.name), Level::acceleration});
      for (const EntityId point : points_)
        if (!m_.is_at_rest(point)) outputs.push_back({point, Level::acceleration});
    }
    for (const Driver& driver : m_.drivers)
      json_["driven"].push_back(plot(columns_of(m_, {driver.coordinate, Level::position})[0]));
    std::size_t wanted = 0;
    json_["plotted"] = Json::array();
    for (const Output& a : outputs) {
      const std::vector<Column> columns = columns_of(m_, a);
      wanted += columns.size();
      if ((plotted_.size() + columns.size()) * shown_.size() > max_plotted) continue;
      for (const Column& column : columns) json_["plotted"].push_back(plot(column));
    }
    json_["wanted"] = wanted;
    json_["condition"] = pack({{"name", "condition number"}, {"unit", "1"}}, 0,
                              [](const RecordedInstant& i) { return i.condition; });
    for (const Level level : all_levels)
      json_["bounds"].push_back(
          pack({{"name", std::string("error bound, ") + level_names[static_cast<int>(level)]},
                {"unit", "1"}},
               0, [&](const RecordedInstant& i) { return i.bound[level]; }));
  }

  const Scene& scene_;
  const Model& m_;
  const ShownMotion& motion_;
  std::vector<const RecordedInstant*> shown_;
  std::vector<EntityId> points_;
  int stride_;
  double largest_[3] = {0, 0, 0};  // size of the mechanism, largest velocity and acceleration
  std::map<std::string, std::size_t> plotted_;
  Json json_, columns_ = Json::array();
  PackedColumns packed_;
};

}  // namespace

PageData page_data(const ShownMotion& motion, int every) { return Writer(motion, every)(); }

}  // namespace desmo::cli
