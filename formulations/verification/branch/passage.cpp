#include "formulations/verification/branch/passage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/verification/branch/departure.h"
#include "formulations/verification/branch/straight_path.h"
#include "formulations/verification/certificate/table_enclosure.h"

namespace desmo {

namespace {

/// Proves the instant of the motion at a time, on the branch to which the line leads. Proves also
/// that the motion goes on from there to a later time. Writes point.before and point.first.
bool prove_beyond(const Model& m, SingularityCrossing& crossing, double time, double later,
                  TestBudget& budget, PassedPoint& point) {
  const PerLevel<std::vector<double>> z = drivers_at(m, time);
  const double s = crossing.line().arc(z.position);
  const CertifiedInstant* on_line = crossing.go_to(s);
  if (!on_line) return false;
  const double rate = crossing.line().along(z.velocity),
               change = crossing.line().along(z.acceleration);
  InstantCopy x;
  x.assign(*on_line);
  auto& [q, qd, qdd] = x.values;
  for (int i = 0; i < m.coordinates(); ++i) {
    qdd[i] = qdd[i] * rate * rate + qd[i] * change;
    qd[i] *= rate;
  }
  if (m.drivers.size() > 1 && !StraightPath(m).lead(crossing.line().at(s), z.position, q, budget))
    return false;
  budget.take();
  Refinement refinement(m);
  const RefinedInstant& r = refinement.refine(instant_of(time, x.view().values));
  if (!r.proven) return false;
  BranchPath path(m);
  if (!path.start_at(certified(r)) || path.go_to(later, budget).end != PathEnd::same) return false;
  point.before = time;
  point.first.assign(certified(r));
  return true;
}

/// Returns the model with each table replaced by its piece at positions q, which goes on for
/// the length of the table to both sides. Returns nothing if it has no tables. At a knot on a
/// change point third derivatives jump, so no continuation is smooth there. The branch that is
/// smooth in this model agrees with the motion up to second derivatives.
std::optional<Model> with_tables_continued(const Model& m, std::span<const double> q) {
  constexpr int table = TableCoupling::table, numbers = table + table_size(1);
  std::optional<Model> smooth;
  for (std::size_t i = 0; i < m.constraints.size(); ++i) {
    const Constraint& c = m.constraints[i];
    if (c.kind != kind_index<TableCoupling>()) continue;
    const Entity& e = m.entities[c.operands[1]];
    const TableNumbers number = [&c](int k) { return c.constants[table + k]; };
    const double at = c.constants[1].value * (e.fixed ? m.fixed_values : q)[e.first];
    const auto [piece, turns] = find_in_table<double>([&](int k) { return number(k).value; }, at);
    if (piece < 0) continue;
    const TablePieces pieces{number};
    const double far = pieces.length.value, begin = at - far;
    const auto [a0, a1, a2, a3] = pieces.about(piece, turns, begin);
    const std::array<Derived, table_size(1)> single{1, 0, 0, begin, at + far, a0, a1, a2, a3};
    if (!smooth) smooth = m;
    std::vector<Derived>& to = smooth->constraints[i].constants;
    to.resize(numbers);
    std::ranges::copy(single, to.begin() + table);
  }
  return smooth;
}

/// Passes a change point of model m. The crossing is found in `smooth`: m itself, or m with its
/// tables continued, so that no knot is on the point.
std::optional<PassedPoint> pass(const Model& m, const Model& smooth, const CertifiedInstant& last,
                                std::span<const double> direction, double start, GroupId group,
                                TestBudget budget) {
  SingularityCrossing crossing(smooth, last, direction, group, budget);
  if (!crossing.find()) return {};
  PassedPoint point{.time = start,
                    .after = start,
                    .before = INFINITY,
                    .line = crossing.line(),
                    .width = crossing.width(),
                    .polynomials = crossing.positions()};
  const Departure departure(m, crossing.line(), start);
  // Right next to the point rates may have too few digits to be proven: the distance is doubled
  // until they are.
  for (double d = std::max(4 * crossing.nearest(), Interval::unit); d < crossing.reach(); d *= 2) {
    const double time = departure.time_at(d);
    if (time == INFINITY) return point;
    if (departure.has_corner(d, crossing.reach()) || budget.left() == 0) break;
    // The motion must go on for as long again. Drivers may turn back later, to the same point.
    const double later = std::min(departure.time_at(crossing.reach()), time + (time - start));
    if (!prove_beyond(m, crossing, time, later, budget, point)) continue;
    point.time = start + (time - start) / 2;
    return point;
  }
  return {};
}

}  // namespace

/// Shifts the line to drivers z in those that are not its own. Leads the two ends of the
/// polynomials there by proven paths, and joins them anew. Returns whether this is possible.
bool PassedPoint::move_line_to(std::span<const double> z, StraightPath& path, TestBudget& budget) {
  DriverLine to = line;
  for (std::size_t k = 0; k < z.size(); ++k)
    if (!line.counts(k)) to.origin[k] = z[k];
  if (to.origin == line.origin) return true;
  std::array<InstantCopy, 2> ends;
  for (const int side : {0, 1}) {
    const double s = side ? width : -width;
    std::vector<double> q;
    for (const Quintic<double>& p : polynomials) q.push_back(value_at(p, side ? 1. : -1.));
    if (!path.lead(line.at(s), to.at(s), q, budget)) return false;
    const CertifiedInstant* const end = path.find(to, s, q);
    if (!end) return false;
    ends[side].assign(*end);
  }
  for (std::size_t i = 0; i < polynomials.size(); ++i) {
    const auto end = [&](const InstantCopy& x) {
      const auto& [q, qd, qdd] = x.values;
      return EndValues<double>{q[i], qd[i] * width, qdd[i] * (width * width)};
    };
    polynomials[i] = hermite(end(ends[0]), end(ends[1]), Level::acceleration);
  }
  line = std::move(to);
  return true;
}

std::vector<double> PassedPoint::find_positions(StraightPath& path, double at) {
  const Model& m = path.model();
  const std::vector<double> z = drivers_at(m, at).position;
  TestBudget budget(BranchPath::max_tests);
  if (!move_line_to(z, path, budget)) return {};
  const double s = line.arc(z) / width, end = std::clamp(s, -1., 1.);
  std::vector<double> q;
  for (const Quintic<double>& polynomial : polynomials) q.push_back(value_at(polynomial, end));
  if (s != end && !path.lead(line.at(end * width), z, q, budget)) return {};
  for (std::size_t k = 0; k < z.size(); ++k) q[m.entities[m.drivers[k].coordinate].first] = z[k];
  return q;
}

std::optional<PassedPoint> pass_change_point(const Model& m, const CertifiedInstant& last,
                                             GroupId group, TestBudget& budget) {
  return pass_change_point(m, last, drivers_at(m, last.time).velocity, last.time, group, budget);
}

/// Passes a change point with the drivers that `group` depends on. If they lead to no instant
/// beyond, another group may be singular there, too: then tries with all drivers.
std::optional<PassedPoint> pass_change_point(const Model& m, const CertifiedInstant& last,
                                             std::span<const double> direction, double start,
                                             GroupId group, TestBudget& budget) {
  const std::optional<Model> smooth = with_tables_continued(m, last.values.position);
  const auto by = [&](GroupId singular) {
    auto point = pass(m, m, last, direction, start, singular, budget.half());
    if (!point && smooth) point = pass(m, *smooth, last, direction, start, singular, budget.half());
    return point;
  };
  const DriverLine line(m, last.values.position, direction, group);
  auto point = by(group);
  return point || line.count() == std::ssize(m.drivers) ? point : by(no_position);
}

}  // namespace desmo
