// Condensed Jacobians and right-hand sides against the closed forms of textbooks: Haug (1989) for
// reference points, the recursion of velocities and accelerations for relative coordinates.

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/io/files.h"
#include "tests/coordinates/textbook_motion.h"
#include "tests/mechanisms.h"

namespace desmo::textbook_test {
namespace {

/// A row of the Jacobian as textbooks have it, and Φ̈ where accelerations of unknowns are 0.
struct Row {
  VectorXd by;  // derivative by each unknown
  double gamma;
};

/// Returns Σ kᵢ·(rates)ᵢ as a row.
Row combined(int columns, const std::vector<std::pair<Vector3d, Instant::Rates>>& terms) {
  Row row{VectorXd::Zero(columns), 0};
  for (const auto& [factor, rates] : terms) {
    for (const auto& [column, moved] : rates.by) row.by[column] += factor.dot(moved);
    row.gamma += factor.dot(rates.bias);
  }
  return row;
}

/// Returns the closed form of an equation, or nothing for kinds that none is written for.
std::optional<Row> closed_form(const Instant& now, const Equation& equation) {
  const Constraint& c = now.m.constraints[equation.constraint];
  const std::string_view kind = constraint_kind_name(c.kind);
  const int n = static_cast<int>(now.column.size());
  const auto rates = [&](int k) { return now.rates(c.operands[k]); };
  if (c.name.ends_with(" rigid")) {  // pᵢ − pⱼ
    const int body = now.body_of(c.name);
    if (body < 0 || !now.framed.tree.has_frame[body]) return {};
    const bool is_point = now.m.entities[c.operands[0]].kind == EntityKind::point;
    const Vector3d axis = Vector3d::Unit(equation.row);
    return combined(n, {{axis, rates(0)}, {-axis, now.rates(c.operands[0], body, is_point)}});
  }
  if (kind == "dot2" || kind == "dot3") {
    const auto u = rates(0), v = rates(1);
    Row row = combined(n, {{v.value, u}, {u.value, v}});
    row.gamma += 2 * u.velocity.dot(v.velocity);
    return row;
  }
  if (kind == "projection3") {
    const auto u = rates(0), p = rates(1), q = rates(2);
    Row row = combined(n, {{q.value - p.value, u}, {u.value, q}, {-u.value, p}});
    row.gamma += 2 * u.velocity.dot(q.velocity - p.velocity);
    return row;
  }
  if (kind == "length2" || kind == "length3") {
    const auto p = rates(0), q = rates(1);
    const Vector3d s = 2 * (q.value - p.value);
    Row row = combined(n, {{s, q}, {-s, p}});
    row.gamma += 2 * (q.velocity - p.velocity).squaredNorm();
    return row;
  }
  return {};
}

TEST(Coordinates, CondenseToTheClosedFormsOfTextbooks) {
  std::vector<Scene> scenes = library_scenes();
  scenes.push_back(four_bar(2));
  scenes.push_back(truck_suspension(1));
  std::map<std::string, int> compared;
  for (const Scene& scene : scenes)
    for (const Modelling kind : {Modelling::reference, Modelling::relative}) {
      const Instant now(scene, kind, 0.01);
      SCOPED_TRACE(now.m.name + (kind == Modelling::relative ? " relative" : " reference"));
      for (std::size_t i = 0; i < now.closures.size(); ++i) {
        const Constraint& c = now.m.constraints[now.closures[i].constraint];
        const std::optional<Row> expected = closed_form(now, now.closures[i]);
        if (!expected) continue;
        const VectorXd actual = now.jacobian.row(static_cast<Eigen::Index>(i)).transpose();
        const double size = std::max(1.0, expected->by.lpNorm<Eigen::Infinity>());
        EXPECT_LE((actual - expected->by).lpNorm<Eigen::Infinity>(), 1e-12 * size) << c.name;
        EXPECT_NEAR(now.gamma[static_cast<Eigen::Index>(i)], expected->gamma,
                    1e-12 * std::max(1.0, std::abs(expected->gamma)))
            << c.name;
        ++compared[std::string(constraint_kind_name(c.kind)) +
                   (kind == Modelling::relative ? " relative" : " reference")];
      }
    }
  for (const char* kind : {"dot3 reference", "projection3 reference", "rigid3_1 reference",
                           "rigid3_1 relative", "length3 reference", "length3 relative",
                           "planar_point_by_vector reference", "planar_point_by_vector relative"})
    EXPECT_GE(compared[kind], 9) << kind;
}

}  // namespace
}  // namespace desmo::textbook_test
