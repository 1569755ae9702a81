#include "formulations/verification/branch/passage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "formulations/constraints/constraints.h"

namespace desmo {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

PerLevel<std::vector<double>> drivers_at(const Model& m, double time) {
  PerLevel<std::vector<double>> z;
  for (const Driver& d : m.drivers) {
    const MotionSample<double> x = sample(d.motion, time);
    z.position.push_back(x.position);
    z.velocity.push_back(x.velocity);
    z.acceleration.push_back(x.acceleration);
  }
  return z;
}

/// The motion of the drivers as it leaves a point.
class Departure {
 public:
  Departure(const Model& m, const DriverLine& line, double start)
      : m_(m), line_(line), start_(start) {}

  /// Returns about the first time at which the drivers are `distance` away from the line's origin,
  /// in the unit of arc; infinity where they never are. Steps are doubled from each knot on, since
  /// drivers that rest there depart as a power of time; so they end at infinity.
  double time_at(double distance) const {
    const auto is_away = [&](double t) {
      return line_.distance(drivers_at(m_, t).position, 0) >= distance;
    };
    if (is_away(start_)) return start_;
    double begin = start_, inside = start_, step = 0;
    const auto next_knot = [&] { return first_knot(m_, begin, infinity).value_or(infinity); };
    for (double knot = next_knot();;) {
      step = std::max(2 * step, std::nextafter(begin, infinity) - begin);
      const double next = std::min(begin + step, knot);
      if (next == infinity) return infinity;
      if (is_away(next)) return last_inside(inside, next, is_away);
      inside = next;
      if (next == knot) begin = knot, step = 0, knot = next_knot();
    }
  }

  /// Returns about the time after `time` at which a driver first turns back; `until` where none
  /// does before it. Steps are doubled: a turn and its return between two of them are not seen.
  double turn_after(double time, double until) const {
    const std::vector<double> rates = drivers_at(m_, time).velocity;
    const auto has_turned = [&](double t) {
      return !std::ranges::equal(rates, drivers_at(m_, t).velocity,
                                 [](double at_first, double now) { return at_first * now >= 0; });
    };
    double inside = time;
    const double last_digit = std::nextafter(time, infinity) - time;
    for (double step = std::max(time - start_, last_digit); inside < until; step *= 2) {
      const double next = std::min(inside + step, until);
      if (has_turned(next)) return last_inside(inside, next, has_turned);
      inside = next;
    }
    return until;
  }

  /// Returns whether the drivers' path fails to be tangent to the line at the line's origin, or the
  /// drivers never reach the distance `far`. near < far: distances from the origin in the unit of
  /// arc.
  bool has_corner(double near, double far) const {
    if (m_.drivers.size() == 1) return false;
    const double first = time_at(near), second = time_at(far);
    if (second == infinity) return true;  // there is too little to see
    const std::vector<double> z = drivers_at(m_, first).position;
    double rounding = 0;
    for (std::size_t k = 0; k < z.size(); ++k)
      rounding += 4 * Interval::unit * std::abs(z[k]) / line_.magnitudes[k];
    const double off = line_.distance(z, line_.arc(z));
    return off > rounding && off / near > sine(second) / 2;
  }

 private:
  static double last_inside(double inside, double away, const auto& is_away) {
    for (int i = 0; i < 64; ++i) {
      const double middle = inside + (away - inside) / 2;
      (is_away(middle) ? away : inside) = middle;
    }
    return away;
  }
  /// Returns the sine of the angle between the line and the way to the drivers.
  double sine(double time) const {
    const std::vector<double> z = drivers_at(m_, time).position;
    return line_.distance(z, line_.arc(z)) / line_.distance(z, 0);
  }

  const Model& m_;
  const DriverLine& line_;
  double start_;
};

/// Leads positions from one point of the drivers straight to another one. Returns whether all the
/// way is proven.
bool lead(Model m, std::span<const double> from, std::span<const double> to,
          std::vector<double>& q) {
  if (std::ranges::equal(from, to)) return true;
  for (std::size_t k = 0; k < from.size(); ++k)
    m.drivers[k].motion = Polynomial{{from[k], to[k] - from[k]}};
  BranchPath path(m);
  if (!path.start_at({0, {q, {}, {}}, {}}) || path.go_to(1).end != PathEnd::same) return false;
  std::ranges::copy(path.present().values.position, q.begin());
  return true;
}

/// Proves the instant of the motion at a time, on the branch to which the line leads, and that the
/// motion goes on from there to a later time.
bool prove_beyond(const Model& m, StraightCrossing& crossing, double time, double later,
                  PassedPoint& point) {
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
  if (m.drivers.size() > 1 && !lead(m, crossing.line().at(s), z.position, q)) return false;
  Refinement refinement(m);
  const RefinedInstant& r = refinement.refine(instant_of(time, x.view().values));
  if (!r.proven) return false;
  BranchPath path(m);
  if (!path.start_at(certified(r)) || path.go_to(later).end != PathEnd::same) return false;
  point.before = time;
  point.first.assign(certified(r));
  return true;
}

/// Returns the model whose tables go on for ever as the pieces do that are read at positions q;
/// nothing where it has no tables. A knot on a change point, where third derivatives jump, is none
/// of this model: what continues smoothly here is where the motion goes on to within third order.
std::optional<Model> with_tables_continued(const Model& m, std::span<const double> q) {
  constexpr int table = TableCoupling::table, numbers = table + table_size(1);
  std::optional<Model> smooth;
  for (std::size_t i = 0; i < m.constraints.size(); ++i) {
    const Constraint& c = m.constraints[i];
    if (c.kind != kind_index<TableCoupling>()) continue;
    const Entity& e = m.entities[c.operands[1]];
    const auto number = [&c](int k) { return c.dimension(table + k); };
    const double at = c.constants[1] * (e.fixed ? m.fixed_values : q)[e.first];
    const auto [piece, turns] = find_in_table<double>([&](int k) { return number(k).value; }, at);
    if (piece < 0) continue;
    const int n = static_cast<int>(c.constants[table]);
    const Derived length = number(3 + n) - number(3), begin = at - 8 * length.value,
                  t = begin - (number(3 + piece) + length * turns);
    const auto a = [&](int k) { return number(4 + n + 4 * piece + k); };
    const Derived a1 = a(1), a2 = a(2), a3 = a(3);
    const std::array<Derived, table_size(1)> single{
        1,
        0,
        0,
        begin,
        at + 8 * length.value,
        ((a3 * t + a2) * t + a1) * t + a(0) + number(2) * turns,
        (a3 * 3 * t + a2 * 2) * t + a1,
        a3 * 3 * t + a2,
        a3};
    if (!smooth) smooth = m;
    Constraint& to = smooth->constraints[i];
    to.constants.resize(numbers);
    to.remainders.resize(numbers);
    for (std::size_t k = 0; k < single.size(); ++k) {
      to.constants[table + k] = single[k].value;
      to.remainders[table + k] = single[k].remainder();
    }
  }
  return smooth;
}

/// Passes a change point of a model on the branches of another one, which is the same on this side
/// and smooth.
std::optional<PassedPoint> pass(const Model& m, const Model& smooth, const CertifiedInstant& last,
                                std::span<const double> direction, double start) {
  StraightCrossing crossing(smooth, last, direction);
  if (!crossing.find()) return {};
  PassedPoint point{.time = start,
                    .after = start,
                    .before = infinity,
                    .line = crossing.line(),
                    .width = crossing.width(),
                    .polynomials = crossing.positions()};
  const Departure departure(m, crossing.line(), start);
  // Nearest to the point, rates may have too few digits to be proven.
  for (double d = std::max(4 * crossing.nearest(), Interval::unit); d < crossing.reach(); d *= 2) {
    const double time = departure.time_at(d);
    if (time == infinity) return point;
    if (departure.has_corner(d, crossing.reach())) return {};
    // Where they turn back, they may be at the point again.
    const double far = departure.time_at(crossing.reach());
    const double later = departure.turn_after(time, far < infinity ? far : time + (time - start));
    if (!prove_beyond(m, crossing, time, later, point)) continue;
    point.time = start + (time - start) / 2;
    return point;
  }
  return {};
}

}  // namespace

std::vector<double> PassedPoint::positions(const Model& m, double at) const {
  const std::vector<double> z = drivers_at(m, at).position;
  const double s = line.arc(z) / width;
  std::vector<double> q;
  for (const Quintic<double>& polynomial : polynomials) q.push_back(value_at(polynomial, s));
  for (std::size_t k = 0; k < z.size(); ++k) q[m.entities[m.drivers[k].coordinate].first] = z[k];
  return q;
}

std::optional<PassedPoint> pass_change_point(const Model& m, const CertifiedInstant& last) {
  return pass_change_point(m, last, drivers_at(m, last.time).velocity, last.time);
}

std::optional<PassedPoint> pass_change_point(const Model& m, const CertifiedInstant& last,
                                             std::span<const double> direction, double start) {
  std::optional<PassedPoint> point = pass(m, m, last, direction, start);
  if (point) return point;
  const std::optional<Model> smooth = with_tables_continued(m, last.values.position);
  return smooth ? pass(m, *smooth, last, direction, start) : point;
}

}  // namespace desmo
