#include "formulations/modelling/measures/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "cases/mechanism/drawing.h"
#include "cases/mechanism/joint_forms.h"
#include "cases/mechanism/names.h"
#include "cases/numbers/space.h"
#include "formulations/modelling/measures/body_frames.h"
#include "formulations/modelling/measures/rate_ratio.h"

namespace desmo {

namespace {

using namespace frames;

Eigen::Vector3d part(const Vector& a, double Number::*which) {
  return {a[0].*which, a[1].*which, a[2].*which};
}

Eigen::Matrix3d matrix(const Frame& frame) {
  Eigen::Matrix3d columns;
  for (int k = 0; k < 3; ++k) columns.col(k) = part(frame[k], &Number::value);
  return columns;
}

/// Returns ½ Σ eₖ × dₖ over the axes eₖ of a frame. It is ω when dₖ are their first derivatives,
/// and α when dₖ are their second ones.
Eigen::Vector3d spin(const Frame& frame, double Number::*derivative) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Vector& axis : frame) sum += part(axis, &Number::value).cross(part(axis, derivative));
  return 0.5 * sum;
}

/// Returns the angle of a rotation about an axis, in (−π, π]. A further rotation about that axis
/// adds its own angle, up to whole turns, whatever else the rotation does.
double angle_about(const Eigen::Vector3d& axis, const Eigen::Quaterniond& rotation) {
  const double half = std::atan2(axis.dot(rotation.vec()), rotation.w());
  const double angle = std::remainder(2 * half, 2 * std::numbers::pi);
  return angle <= -std::numbers::pi ? std::numbers::pi : angle;
}

class Builder {
 public:
  Builder(const Scene& scene, const Model& model, Measures::DrivenBy driven_by)
      : mechanism_(scene.mechanism),
        m_(model),
        driven_by_(driven_by),
        bodies_(mechanism_, m_, inputs) {
    for (EntityId e = 0; e < static_cast<EntityId>(m_.entities.size()); ++e)
      for (int i = 0; i < m_.entities[e].size; ++i)
        taken_.insert(coordinate_name(m_, e, m_.entities[e].first + i));
    using enum RequestedMeasure::Kind;
    auto unmet = scene.patterns;
    for (const RequestedMeasure& wanted : scene.measures) {
      bodies_.level = wanted.level;
      const std::size_t before = list.size();
      if (wanted.kind == rotation && has_turn(wanted, {wanted.index})) add_rotation(wanted.index);
      if (wanted.kind == joint) add_joint(wanted);
      if (wanted.kind == ratio) add_ratio(wanted);
      if (list.size() == before) continue;
      std::erase_if(unmet, [&](const auto& pattern) {
        return pattern.first == wanted.kind &&
               matches(pattern.second, wanted.kind == rotation
                                           ? mechanism_.bodies[wanted.index].name
                                           : mechanism_.joints[wanted.index].name);
      });
    }
    if (!unmet.empty())
      throw std::invalid_argument(
          "request: the pattern " + in_quotes(unmet.begin()->second) +
          " gives nothing: the points and vectors of the bodies do not tell how they are turned; "
          "give them others that are not in line, or ask for angles or vectors");
  }

  std::vector<Measure> list;
  std::vector<Output> inputs;
  std::vector<std::pair<std::size_t, Measures::Rule>> rules;

 private:
  using Axes = std::vector<Eigen::Vector3d>;

  void add_rotation(int body) {
    const std::string& name = mechanism_.bodies[body].name;
    Axes axes{Eigen::Vector3d::UnitZ()};
    std::vector<std::string> components{""};
    if (mechanism_.dimension == 3) {
      axes = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
      components = {".x", ".y", ".z"};
    }
    const std::size_t first = list.size();
    for (const std::string& i : components)
      add({name + ".rotation" + i, name + ".omega" + i, name + ".alpha" + i}, EntityKind::angle);
    add_turn(first, 0, body, std::move(axes), bodies_.turn_of_frame(body));
  }

  /// Returns whether to measure a turn between bodies: false when only a pattern asks for it and
  /// one of them does not tell how it is turned.
  bool has_turn(const RequestedMeasure& wanted, std::initializer_list<int> bodies) const {
    return !wanted.by_pattern ||
           std::ranges::all_of(bodies, [&](int body) { return bodies_.tells_turn(body); });
  }

  void add_joint(const RequestedMeasure& wanted) {
    const Mechanism::Joint& joint = mechanism_.joints[wanted.index];
    const Drawing<double> drawing{mechanism_};
    const auto add_with_rates = [&](const std::string& name, EntityKind kind) {
      add({name, "d/dt " + name, "d2/dt2 " + name}, kind);
      return list.size() - 1;
    };
    if (turns(joint.type) && has_turn(wanted, {joint.bodies[0], joint.bodies[1]})) {
      Vector axis{0., 0., 1.};
      if (mechanism_.dimension == 3)
        axis = unit(bodies_.drawn(joint.bodies[0], joint.vectors.empty()
                                                       ? joint.line()
                                                       : Mechanism::Direction{joint.vectors[0]}));
      const std::size_t place = add_with_rates(joint.name + ".angle", EntityKind::angle);
      const Frame first = bodies_.find_frame(joint.bodies[0]).drawn;
      add_turn(place, joint.bodies[0], joint.bodies[1],
               {matrix(first).transpose() * part(axis, &Number::value)});
    }
    if (slides(joint.type)) {
      const Line along = bodies_.find_line({joint.vectors[0]}),
                 line_of_both = bodies_.find_line(joint.line());
      const auto u = drawing.vector(joint.vectors[0]), s0 = drawing.direction(joint.line());
      const double start = dot(u, s0);
      const std::size_t place = add_with_rates(joint.name + ".travel", EntityKind::distance);
      rules.emplace_back(place, [=](const Instant& instant, auto values) {
        const Number s = dot(line_of_both(instant), along(instant));
        values[0] = {s.value - start, s.first, s.second};
      });
    }
  }

  /// Adds the rule for the turn of a body relative to another one, `in`, about axes of that one.
  /// - place: position of its first measure in `list`
  /// - start: the turn in the drawing
  void add_turn(std::size_t place, int in, int body, Axes axes,
                const Eigen::Matrix3d& start = Eigen::Matrix3d::Identity()) {
    const BodyFrame a = bodies_.find_frame(in), b = bodies_.find_frame(body);
    const Eigen::Matrix3d drawn = start.transpose() * matrix(seen_from(a.drawn, b.drawn));
    rules.emplace_back(place, [=, axes = std::move(axes)](const Instant& instant, auto values) {
      const Frame frame = seen_from(a(instant), b(instant));
      const Eigen::Quaterniond since(Eigen::Matrix3d(matrix(frame) * drawn.transpose()));
      const Eigen::AngleAxisd turned(since);
      const Eigen::Vector3d omega = spin(frame, &Number::first),
                            alpha = spin(frame, &Number::second);
      for (std::size_t k = 0; k < axes.size(); ++k)
        values[k] = {axes.size() > 1 ? turned.angle() * axes[k].dot(turned.axis())
                                     : angle_about(axes[k], since),
                     axes[k].dot(omega), axes[k].dot(alpha)};
    });
  }

  void add_ratio(const RequestedMeasure& wanted) {
    const std::vector<EntityId> owner = entity_of_coordinate(m_);
    std::array<int, 2> of;
    std::array<EntityKind, 2> kinds;
    for (int k = 0; k < 2; ++k) {
      of[k] = m_.coordinate(wanted.of[k]);
      kinds[k] = m_.entities[owner[of[k]]].kind;
      inputs.push_back({owner[of[k]], Level::acceleration});
    }
    const std::size_t place = list.size();
    add({"", wanted.name, ""}, kinds[0]);
    list.back().per = kinds[1];
    rules.emplace_back(place, rate_ratio(m_, of, driven_by_));
  }

  void add(PerLevel<std::string> names, EntityKind kind) {
    for (const Level level : all_levels) {
      if (level > bodies_.level) names[level].clear();
      if (!names[level].empty() && !taken_.insert(names[level]).second)
        throw std::invalid_argument("request: the name '" + names[level] +
                                    "' is taken by a coordinate of the mechanism, or by another "
                                    "rotation, joint or ratio; rename one of them");
    }
    list.push_back({std::move(names), kind});
  }

  const Mechanism& mechanism_;
  const Model& m_;
  Measures::DrivenBy driven_by_;
  BodyFrames bodies_;
  std::set<std::string> taken_;
};

}  // namespace

Measures::Measures(const Scene& scene, const Model& model, DrivenBy driven_by)
    : coordinates_(model.coordinates()) {
  if (scene.measures.empty()) return;
  Builder builder(scene, model, driven_by);
  list_ = std::move(builder.list);
  inputs_ = std::move(builder.inputs);
  rules_ = std::move(builder.rules);
  values_.resize(list_.size());
}

Instant Measures::extend(const Instant& instant) {
  Instant result = instant;
  if (list_.empty() || instant.q.empty()) return result;
  for (const auto& [first, rule] : rules_) rule(instant, std::span(values_).subspan(first));
  const auto append = [&](std::span<const double>& solved, Level level) {
    if (solved.empty()) return;
    std::vector<double>& all = extended_[level];
    all.assign(solved.begin(), solved.begin() + coordinates_);
    for (const PerLevel<double>& value : values_) all.push_back(value[level]);
    solved = all;
  };
  append(result.q, Level::position);
  append(result.qd, Level::velocity);
  append(result.qdd, Level::acceleration);
  return result;
}

std::vector<Output> outputs_of(const Scene& scene, const Model& whole) {
  std::vector<Output> result;
  for (const RequestedEntity& w : scene.request) {
    const std::string& name =
        w.kind == RequestedEntity::Kind::point    ? scene.mechanism.points[w.index].name
        : w.kind == RequestedEntity::Kind::vector ? scene.mechanism.vectors[w.index].name
                                                  : scene.mechanism.coordinates[w.index].name;
    result.push_back({whole.find(name), w.level});
  }
  const Measures measures(scene, whole);
  result.insert(result.end(), measures.inputs().begin(), measures.inputs().end());
  return result;
}

}  // namespace desmo
