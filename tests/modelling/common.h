#pragma once

#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <optional>

#include "formulations/constraints/constraints.h"
#include "tests/describing.h"
#include "tests/mechanisms.h"

namespace desmo {

/// An equation in comparable form: kind, operands, numbers.
struct Stated {
  std::string kind;
  std::vector<std::string> operands;
  std::vector<double> constants;
};

inline std::vector<double> values_of(const Constraint& c) {
  std::vector<double> values;
  for (const Derived& constant : c.constants) values.push_back(constant.value);
  return values;
}

/// Returns the equation with interchangeable operands in alphabetical order.
inline Stated canonical(Stated s) {
  const auto starts = [&](const char* prefix) { return s.kind.starts_with(prefix); };
  auto& o = s.operands;
  if (starts("length") || starts("dot") || starts("distance")) {
    if (o[1] < o[0]) std::swap(o[0], o[1]);
  } else if (starts("projection") && o[2] < o[1]) {
    std::swap(o[1], o[2]);
    s.constants[0] = -s.constants[0];
  } else if (starts("rigid")) {
    std::map<std::string, double> terms;
    for (std::size_t k = 2; k < o.size(); ++k) terms[o[k]] = s.constants[k - 2];
    std::size_t k = 0;
    for (const auto& [name, c] : terms) o[k + 2] = name, s.constants[k++] = c;
  }
  return s;
}

/// Returns the equations of a group that are not left out, each in canonical form.
inline std::vector<Stated> equations_of(const Model& m, GroupId g) {
  std::vector<Stated> result;
  for (const Constraint& c : m.constraints) {
    if (c.group != g || kept_rows(c) == 0) continue;
    Stated s{std::string(constraint_kind_name(c.kind)), {}, values_of(c)};
    for (const EntityId e : c.operands) s.operands.push_back(m.entities[e].name);
    result.push_back(canonical(std::move(s)));
  }
  return result;
}

inline void expect_equations(const Model& m, GroupId g, std::vector<Stated> expected) {
  std::vector<Stated> actual = equations_of(m, g);
  for (Stated& s : expected) s = canonical(std::move(s));
  const auto what = [](const Stated& s) { return std::pair(s.kind, s.operands); };
  std::ranges::sort(actual, {}, what);
  std::ranges::sort(expected, {}, what);
  const auto listed = [&](const std::vector<Stated>& equations) {
    std::vector<std::pair<std::string, std::vector<std::string>>> all;
    std::ranges::transform(equations, std::back_inserter(all), what);
    return all;
  };
  ASSERT_EQ(listed(actual), listed(expected)) << m.groups[g].name;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    SCOPED_TRACE(testing::PrintToString(what(actual[i])));
    ASSERT_EQ(actual[i].constants.size(), expected[i].constants.size());
    for (std::size_t k = 0; k < actual[i].constants.size(); ++k)
      EXPECT_NEAR(actual[i].constants[k], expected[i].constants[k], 1e-14);
  }
}

inline const std::vector<Motion> turning{Polynomial{{1.0, 1}}};

/// Returns cranks of length 1 on pivots along the x axis, connected by one coupler; the first is
/// driven.
/// - pivots: x of each crank's pivot.
/// - angle: nominal angle of the cranks [rad].
/// - last_length: length of the last crank, whose pivot is moved accordingly.
inline Mechanism parallelogram(const std::vector<double>& pivots, double angle = 1,
                               double last_length = 1) {
  Sketch d("parallelogram", 2);
  std::vector<int> feet, ends;
  for (std::size_t i = 0; i < pivots.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    // The end lies on the coupler; another crank length moves the pivot.
    const bool last = i + 1 == pivots.size();
    const Vec end = Vec{pivots[i], 0, 0} + polar(1, angle);
    feet.push_back(d.ground_point("D" + n, end - polar(last ? last_length : 1, angle)));
    ends.push_back(d.point("C" + n, end));
  }
  for (std::size_t i = 0; i < pivots.size(); ++i)
    d.body("crank" + std::to_string(i + 1), {feet[i], ends[i]});
  d.body("coupler", ends);
  d.angle("theta", line(feet[0], ends[0])).driven = true;
  return d.release_pinned();
}

/// Returns a four-bar with the angles theta (crank) and psi (rocker), neither of them driven. Its
/// bodies are to be pinned.
inline Sketch four_bar_sketch(std::optional<double> coupler_length = {}) {
  Sketch d("linkage", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0});
  d.body("crank", {A, B});
  coupler_length ? d.link("coupler", B, C, *coupler_length) : d.body("coupler", {B, C});
  d.body("rocker", {D, C});
  d.angle("theta", line(A, B));
  d.angle("psi", line(D, C));
  return d;
}

/// Returns a four-bar in space, where parallel axes make three of its restrictions redundant.
inline Mechanism spatial_four_bar() {
  Sketch d("bennett_no_more", 3);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0});
  const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
            z = d.ground_vector("z", {0, 0, 1});
  d.bodies({{"crank", {A, B}, {z}}, {"coupler", {B, C}, {z}}, {"rocker", {D, C}, {z}}});
  d.spatial_angle("theta", line(A, B), x, y).driven = true;
  return d.release_pinned({z});
}

inline Mechanism driven(Mechanism mechanism, const std::vector<std::string>& names) {
  for (Mechanism::Coordinate& c : mechanism.coordinates)
    c.driven = std::ranges::find(names, c.name) != names.end();
  return mechanism;
}

}  // namespace desmo
