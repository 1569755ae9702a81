#include "tests/properties/truth.h"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <span>

#include "formulations/constraints/kind_functions.h"
#include "formulations/model/constraint_at.h"
#include "tests/properties/assembled_drawing.h"

namespace desmo::properties {

namespace {

constexpr double quadruple_roundoff = 1e-32;  // of two doubles; of quadruple precision 1e-34
constexpr double singular = 1e14;             // κ above which doubles have no answer

using Values = std::vector<Quadruple>;

/// Goes to a parameter; where the way is lost once, again from the last regular place, past what is
/// singular.
bool reaches(Continuation& c, const Quadruple& parameter) {
  return c.go_to(parameter) || c.go_to(parameter);
}

/// Goes from the drawing to the first instant, all drivers straight. Returns whether it could.
bool reaches_start(Continuation& c, const Model& m, double time) {
  Values from, way;
  for (const Driver& d : m.drivers) {
    from.push_back(m.estimate[m.entities[d.coordinate].first]);
    way.push_back(sample(d.motion, Quadruple(time)).position - from.back());
  }
  if (std::ranges::all_of(way, [](const Quadruple& x) { return x == 0; })) return true;
  c.begin(straight_path(from, way), 0);
  return reaches(c, 1);
}

/// Returns what is to be added to each coordinate: measured angles begin less than half a turn from
/// the drawing, and are continuous from there. Driven and coupled ones count as they are.
std::vector<Quadruple> turns_to_drawing(const Model& m, const Values& start) {
  const Quadruple turn = 2 * boost::math::constants::pi<Quadruple>();
  std::vector<Quadruple> turns(m.coordinates());
  const std::vector<bool> driven = independent_coordinates(m), coupled = coupled_angles(m);
  for (std::size_t i = 0; i < m.entities.size(); ++i) {
    const Entity& e = m.entities[i];
    if (e.kind == EntityKind::angle && !e.fixed && !driven[e.first] && !coupled[i])
      turns[e.first] = turn * round((m.estimate[e.first] - start[e.first]) / turn);
  }
  return turns;
}

void find_sizes(Truth& truth, const Model& m) {
  const double size = nominal_size(m);
  double largest = size, least = size;
  std::vector<std::vector<double>> points;
  for (const Entity& e : m.entities) {
    if (e.kind != EntityKind::point) continue;
    const auto first = (e.fixed ? m.fixed_values : m.estimate).begin() + e.first;
    points.emplace_back(first, first + e.size);
    for (const double x : points.back()) largest = std::max(largest, std::abs(x));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double squares = 0;
      for (std::size_t k = 0; k < points[i].size(); ++k)
        squares += std::pow(points[i][k] - points[j][k], 2);
      if (squares > 0) least = std::min(least, std::sqrt(squares));
    }
  truth.far = std::max(1.0, largest / size);
  truth.size_ratio = largest / least;
}

}  // namespace

bool has_answer(const TrueInstant& t) { return !t.instant.q.empty(); }

TrueInstant answer_near(const Model& m, double time, std::span<const double> q) {
  TrueInstant t;
  t.instant.time = time;
  GlobalSolver<Quadruple> solver(m);
  solver.place({q.begin(), q.end()});
  try {
    solver.solve_positions(time);
    solver.solve_rates();
  } catch (const std::runtime_error&) {
    return t;
  }
  const ReferenceInstant found = rounded({time, solver.q(), solver.qd(), solver.qdd()});
  t.condition = ConditionNumber(m)(found.q);
  if (t.condition < singular) t.instant = found;
  return t;
}

double largest_misfit(const Model& m, std::span<const double> q, bool of_all) {
  const double size = nominal_size(m);
  Values state(q.begin(), q.end());
  for (std::size_t i = 0; i < m.fixed_values.size(); ++i)
    state.push_back(as<Quadruple>(m.fixed_value(i)));
  double largest = 0;
  for (const Constraint& constraint : m.constraints) {
    const ConstraintAt<Quadruple> at(m, constraint, state.data());
    std::array<Quadruple, max_rows> phi;
    at.residual(phi.data());
    std::array<double, max_rows> slope{};
    at.jacobian([&](int r, int operand, int, const Quadruple& value) {
      const bool length = is_length(m.entities[constraint.operands[operand]].kind);
      const double s = std::abs(static_cast<double>(value)) * (length ? size : 1);
      slope[r] = std::max(slope[r], s);
    });
    for (int r = 0; r < at.kind.rows; ++r)
      if (of_all || constraint.left_out >> r & 1)
        largest = std::max(largest, std::abs(static_cast<double>(phi[r])) / slope[r]);
  }
  return largest;
}

PerLevel<double> floor_of(const Truth& truth, const TrueInstant& t) {
  PerLevel<double> floor = accuracy_limit(t.condition, quadruple_roundoff);
  for (const Level level : all_levels) floor[level] *= truth.far;
  return floor;
}

Truth true_answers(const Model& given, const TimeGrid& grid) {
  const Model m = with_assembled_drawing(given);
  Truth truth;
  find_sizes(truth, m);
  truth.instants.resize(grid.instants);
  for (int i = 0; i < grid.instants; ++i) truth.instants[i].instant.time = grid.time(i);
  truth.regular.resize(grid.instants);
  truth.decided.resize(grid.instants);
  Continuation c(m);
  if (!reaches_start(c, m, grid.time(0))) return truth;
  double way = c.crossings() == 0 ? c.max_condition() : INFINITY;
  bool decided = way < undecided || way >= crossing;
  c.begin(motions_of(m), grid.time(0));
  const std::vector<Quadruple> turns = turns_to_drawing(m, c.instant().q);
  std::vector<ReferenceInstant> answers;
  int missed = 0;  // instants in a row: two are more than a passage
  for (int i = 0; i < grid.instants && missed < 2; ++i) {
    missed = reaches(c, grid.time(i)) ? 0 : missed + 1;
    if (missed > 0) {
      way = INFINITY;
      decided = false;
      continue;
    }
    TrueInstant& t = truth.instants[i];
    t.condition = c.condition();
    t.path_condition = c.max_condition();
    way = std::max({way, t.condition, t.path_condition});
    truth.regular[i] = way < well_conditioned;
    decided = decided && (t.path_condition < undecided || t.path_condition >= crossing);
    truth.decided[i] = decided;
    if (!(t.condition < singular)) continue;
    WideInstant answer = c.instant();
    for (std::size_t k = 0; k < turns.size(); ++k) answer.q[k] += turns[k];
    t.instant = rounded(answer);
    answers.push_back(t.instant);
  }
  truth.scales = make_scales(m, answers);
  return truth;
}

}  // namespace desmo::properties
