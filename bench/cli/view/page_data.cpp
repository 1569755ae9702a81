#include "bench/cli/view/page_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/cli/solve/columns.h"
#include "bench/cli/view/packing.h"
#include "bench/cli/view/transmission.h"
#include "cases/mechanism/joint_forms.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double position_step = 2e-5;  // of the mechanism's size
constexpr double direction_step = 1e-4;
constexpr double rate_steps = 2000;           // the largest rate has as many
constexpr std::size_t max_plotted = 360'000;  // numbers

const char* text_of(Flag::Kind kind) {
  constexpr const char* names[] = {"degraded", "failed", "crossing", "branch"};
  return names[static_cast<int>(kind)];
}

const char* text_of(Mechanism::CoordinateType type) {
  constexpr const char* names[] = {"angle", "distance", "along", "component"};
  return names[static_cast<int>(type)];
}

/// Writes the JSON, and packs a column whenever it names one.
class Writer {
 public:
  Writer(const ShownMotion& motion, int every)
      : scene_(motion.scene), m_(motion.model), all_(motion) {
    const auto& instants = motion.recording.instants();
    stride_ = motion.recording.stride() * every;
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const bool before_gap = i + 1 == instants.size() ||
                              instants[i + 1].index > instants[i].index + motion.recording.stride();
      if (i % static_cast<std::size_t>(every) == 0 || before_gap) shown_.push_back(&instants[i]);
    }
    find_groups();
    find_size();
  }

  PageData operator()() {
    write_about();
    write_entities();
    write_bodies();
    write_joints();
    write_coordinates();
    write_flags();
    write_plots();
    json_["columns"] = columns_;
    PageData result{json_.dump(-1, ' ', false, Json::error_handler_t::replace), packed_.text()};
    for (std::size_t at = 0; (at = result.json.find('<', at)) != std::string::npos;)
      result.json.replace(at, 1, "\\u003c");  // or a name could end the script
    return result;
  }

 private:
  const Mechanism& mechanism() const { return scene_.mechanism; }

  void find_groups() {
    group_.assign(mechanism().bodies.size(), -1);
    std::map<std::string, GroupId> by_name;
    for (std::size_t g = 0; g < m_.groups.size(); ++g)
      for (const std::string& body : m_.groups[g].bodies) by_name[body] = static_cast<GroupId>(g);
    for (std::size_t b = 1; b < group_.size(); ++b) {
      const Mechanism::Body& body = mechanism().bodies[b];
      if (const auto found = by_name.find(body.name); found != by_name.end()) {
        group_[b] = found->second;
        continue;
      }
      for (const int point : body.points)  // fixed to another body
        group_[b] = std::max(group_[b], m_.entities[m_.find(mechanism().points[point].name)].group);
    }
  }

  void find_size() {
    double low[3], high[3];
    std::ranges::fill(low, INFINITY), std::ranges::fill(high, -INFINITY);
    for (const Mechanism::Point& point : mechanism().points) {
      const Entity& e = m_.entities[m_.find(point.name)];
      for (int axis = 0; axis < e.size; ++axis) {
        const auto include = [&](double x) {
          low[axis] = std::min(low[axis], x), high[axis] = std::max(high[axis], x);
        };
        if (e.fixed)
          include(m_.fixed_values[e.first + axis]);
        else
          for (const RecordedInstant* i : shown_) include(i->state[e.first + axis]);
      }
    }
    double squares = 0;
    for (int axis = 0; axis < mechanism().dimension; ++axis)
      if (high[axis] > low[axis]) squares += std::pow(high[axis] - low[axis], 2);
    size_ = squares > 0 ? std::sqrt(squares) : 1;
  }

  /// Packs a column and returns its place. value: of an instant.
  template <class Value>
  int pack(Json column, double step, const Value& value) {
    std::vector<double> values;
    for (const RecordedInstant* i : shown_) values.push_back(value(*i));
    if (step > 0) {
      const double origin = values.empty() ? 0 : values.front();
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
    json_["mechanism"] = m_.name;
    json_["title"] = mechanism().title;
    json_["scene"] = scene_.name;
    json_["dimension"] = mechanism().dimension;
    json_["unit"] = m_.length_unit;
    json_["size"] = size_;
    json_["formulation"] = all_.formulation;
    json_["coordinates"] = m_.coordinates();
    const MonitoredSummary& s = all_.summary;
    json_["accuracy"] = describe_accuracy(s.condition, s.bound, Level::acceleration);
    json_["time"] = {{"start", scene_.grid.start},
                     {"interval", scene_.grid.interval()},
                     {"instants", scene_.grid.instants},
                     {"solved", all_.recording.solved()},
                     {"stride", stride_}};
    json_["shown"] = shown_.size();
    json_["estimate"] = all_.recording.solved() == 0;
    pack({{"name", "index"}}, 1, [](const RecordedInstant& i) { return i.index; });
    Json groups = Json::array();
    for (const Group& g : m_.groups)
      groups.push_back({{"name", g.name}, {"bodies", g.bodies}, {"constant", g.constant}});
    json_["groups"] = groups;
  }

  /// Places of the first of an entity's columns, of which there is one for each component.
  Json entity(const std::string& name, bool is_point) {
    const Entity& e = m_.entities[m_.find(name)];
    Json result = {{"name", name}};
    if (e.fixed) {
      result["fixed"] = std::vector<double>(m_.fixed_values.begin() + e.first,
                                            m_.fixed_values.begin() + e.first + e.size);
      return result;
    }
    const int n = m_.coordinates();
    constexpr const char* level_names[] = {"position", "velocity", "acceleration"};
    for (int level = 0; level < (is_point ? 3 : 1); ++level) {
      const double step = !is_point    ? direction_step
                          : level == 0 ? position_step * size_
                                       : largest_[level] / rate_steps;
      for (int axis = 0; axis < e.size; ++axis) {
        const auto at = static_cast<std::size_t>(level * n + e.first + axis);
        const int place = pack({}, step, [&](const RecordedInstant& i) { return i.state[at]; });
        if (axis == 0) result[level_names[level]] = place;
      }
    }
    return result;
  }

  void write_entities() {
    for (int level = 1; level < 3; ++level) {
      double& largest = largest_[level] = 0;
      for (const Mechanism::Point& point : mechanism().points) {
        const Entity& e = m_.entities[m_.find(point.name)];
        if (e.fixed) continue;
        for (const RecordedInstant* i : shown_)
          for (int axis = 0; axis < e.size; ++axis)
            largest =
                std::max(largest, std::abs(i->state[level * m_.coordinates() + e.first + axis]));
      }
      if (largest == 0) largest = 1;
    }
    json_["largest"] = {largest_[1], largest_[2]};
    Json points = Json::array(), vectors = Json::array();
    for (const Mechanism::Point& point : mechanism().points)
      points.push_back(entity(point.name, true));
    std::vector<bool> drawn(mechanism().vectors.size());
    for (const Mechanism::Joint& joint : mechanism().joints)
      for (const int v : joint.vectors) drawn[v] = true;
    for (const Mechanism::Coordinate& c : mechanism().coordinates)
      for (const int v : {c.of.vector, c.from.vector, c.towards.vector, c.vector})
        if (c.driven && v >= 0) drawn[v] = true;
    for (std::size_t v = 0; v < drawn.size(); ++v)
      vectors.push_back(drawn[v] ? entity(mechanism().vectors[v].name, false) : Json());
    json_["points"] = points;
    json_["vectors"] = vectors;
  }

  void write_bodies() {
    Json bodies = Json::array();
    for (std::size_t b = 0; b < group_.size(); ++b) {
      const Mechanism::Body& body = mechanism().bodies[b];
      bodies.push_back({{"name", body.name}, {"points", body.points}, {"group", group_[b]}});
    }
    json_["bodies"] = bodies;
  }

  void write_joints() {
    Json joints = Json::array();
    for (const Mechanism::Joint& joint : mechanism().joints)
      joints.push_back({{"name", joint.name},
                        {"type", find_joint_form(joint.type, mechanism().dimension)->name},
                        {"bodies", joint.bodies},
                        {"points", joint.points},
                        {"vectors", joint.vectors}});
    json_["joints"] = joints;
  }

  void write_coordinates() {
    const auto direction = [](const Mechanism::Direction& d) -> Json {
      if (d.vector >= 0) return {{"vector", d.vector}};
      if (d.is_segment()) return {{"from", d.from}, {"to", d.to}};
      return nullptr;
    };
    Json drivers = Json::array(), measures = Json::array();
    for (const Mechanism::Coordinate& c : mechanism().coordinates) {
      if (c.type == Mechanism::CoordinateType::distance) measures.push_back({c.of.from, c.of.to});
      if (!c.driven) continue;
      drivers.push_back({{"name", c.name},
                         {"type", text_of(c.type)},
                         {"of", direction(c.of)},
                         {"from", direction(c.from)},
                         {"opposite", c.opposite},
                         {"vector", c.vector},
                         {"point", c.point},
                         {"axis", c.axis},
                         {"column", plotted(m_.find(c.name), Level::position)}});
    }
    json_["drivers"] = drivers;
    json_["measures"] = measures;
  }

  void write_flags() {
    Json flags = Json::array();
    for (const Flag& flag : all_.recording.flags()) {
      Json open = Json::array();
      for (const EntityId e : flag.open) open.push_back(m_.entities[e].name);
      flags.push_back({{"kind", text_of(flag.kind)},
                       {"from", flag.from},
                       {"to", flag.to},
                       {"text", flag.text},
                       {"open", open}});
    }
    json_["flags"] = flags;
  }

  /// Packs the components of an entity up to a level, unless they are packed. Returns the first.
  int plotted(EntityId entity, Level level) {
    int first = -1;
    for (const Column& column : columns_of(m_, {entity, level})) {
      const auto [found, is_new] =
          plotted_.try_emplace(column.name, static_cast<int>(columns_.size()));
      if (first < 0) first = found->second;
      if (!is_new) continue;
      const auto at = static_cast<std::size_t>(static_cast<int>(column.level) * m_.coordinates() +
                                               column.coordinate);
      pack(
          {{"name", column.name}, {"unit", column.unit}, {"level", static_cast<int>(column.level)}},
          0, [&](const RecordedInstant& i) {
            return column.coordinate < 0 ? column.constant : i.state[at];
          });
    }
    return first;
  }

  void write_plots() {
    std::vector<Asked> asked = asked_by(scene_, m_);
    json_["requested"] = !scene_.request.empty();
    if (scene_.request.empty()) {
      for (const Mechanism::Coordinate& c : mechanism().coordinates)
        asked.push_back({m_.find(c.name), Level::acceleration});
      for (const Mechanism::Point& p : mechanism().points)
        if (const EntityId e = m_.find(p.name); !m_.rests(e))
          asked.push_back({e, Level::acceleration});
    }
    std::size_t all = 0;
    const std::size_t first = columns_.size();
    for (const Asked& a : asked) {
      const std::size_t size = m_.entities[a.entity].size * (1 + static_cast<std::size_t>(a.level));
      all += size;
      if ((columns_.size() - first + size) * shown_.size() <= max_plotted)
        plotted(a.entity, a.level);
    }
    json_["wanted"] = all;
    Json names = Json::array();
    for (const Asked& a : asked)
      for (const Column& c : columns_of(m_, a))
        if (plotted_.contains(c.name)) names.push_back(plotted_[c.name]);
    json_["plotted"] = names;
    Json loops = Json::array();
    for (const FourBarLoop& loop : four_bar_loops(mechanism(), group_)) {
      if ((columns_.size() - first) * shown_.size() > 2 * max_plotted) break;
      loops.push_back(pack({{"name", loop.input + " → " + loop.follower}, {"unit", "deg"}}, 0,
                           [&](const RecordedInstant& i) {
                             return transmission_angle(loop, mechanism(), m_, i.state);
                           }));
    }
    json_["transmission"] = loops;
    json_["condition"] = pack({{"name", "condition number"}, {"unit", "1"}}, 0,
                              [](const RecordedInstant& i) { return i.condition; });
    Json bounds = Json::array();
    for (const auto& [level, name] : {std::pair{Level::position, "position"},
                                      {Level::velocity, "velocity"},
                                      {Level::acceleration, "acceleration"}})
      bounds.push_back(pack({{"name", std::string("error bound, ") + name}, {"unit", "1"}}, 0,
                            [&](const RecordedInstant& i) { return i.bound[level]; }));
    json_["bounds"] = bounds;
  }

  const Scene& scene_;
  const Model& m_;
  const ShownMotion& all_;
  std::vector<const RecordedInstant*> shown_;
  int stride_ = 1;
  double size_ = 1, largest_[3] = {1, 1, 1};
  std::vector<GroupId> group_;  // of each body
  std::map<std::string, int> plotted_;
  Json json_, columns_ = Json::array();
  PackedColumns packed_;
};

}  // namespace

PageData page_data(const ShownMotion& motion, int every) { return Writer(motion, every)(); }

}  // namespace desmo::cli
