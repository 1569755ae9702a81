// Gears, belts, racks, screws and mimic joints, and bodies by tables of their points, against
// closed forms: in every partition, with automatic and generated equations, and proven.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/builder.h"
#include "formulations/motion/internals.h"
#include "formulations/verification/run/checked_run.h"
#include "tests/everything.h"
#include "tests/lanes_here.h"
#include "tests/library/geometry.h"
#include "tests/load/loading.h"

namespace desmo::load::couplings_test {
namespace {

using namespace desmo::exact;

constexpr Real degree = pi / 180;

/// Numbers of a model by their names.
using Values = std::map<std::string, Jet>;

template <std::size_t D>
void add(Values& values, const std::string& name, const Vec<D>& x) {
  for (std::size_t i = 0; i < D; ++i) values[name + "." + "xyz"[i]] = x[i];
}

/// Returns c0 + c1 t + c2 t² degrees.
Jet degrees(double time, Real c0, Real c1, Real c2) {
  const Jet t = Jet::time(time);
  return Jet(degree) * (Jet(c0) + t * (Jet(c1) + Jet(c2) * t));
}

Values gear_train(double t) {
  const Jet a = degrees(t, 900, 720, -90);
  const Jet c0 = atan2(Jet(5), Jet(-20)), b0 = Jet(pi / 2);
  const Jet b = b0 - Jet(20.0L / 30) * a, c = c0 + Jet(20.0L / 50) * a;
  Values v{{"b", b}, {"c", c}};
  add(v, "B", Vec2{{Jet(0.05L), 0}} + polar(Jet(0.02L), b));
  add(v, "C", Vec2{{Jet(0.13L), 0}} + polar(Jet(std::sqrt(0.02L * 0.02L + 0.005L * 0.005L)), c));
  return v;
}

/// The ratio of sun and arm is 1 + 60/24, as textbooks print it.
Values planetary_gear(double t) {
  const Jet sun = degrees(t, 0, 630, 60), drawn = atan2(Jet(3), Jet(10));
  const Jet arm = (sun - drawn) / Jet(1 + 60.0L / 24);
  const Jet planet = atan2(Jet(6), Jet(8)) - Jet(42.0L / 18) * arm;
  Values v{{"arm_angle", arm}, {"planet_angle", planet}};
  add(v, "Q", polar(Jet(0.042L), arm) + polar(Jet(0.01L), planet));
  return v;
}

Values rack_steering(double t) {
  const Jet pinion = Jet(-1.5L) + Jet(4) * sin(Jet(pi) * Jet::time(t));
  const Jet travel = Jet(0.3L) + Jet(0.015L) * (pinion + Jet(pi / 2));
  Values v{{"travel", travel}};
  const Jet rod = sqrt(Jet(0.28L * 0.28L + 0.03L * 0.03L)),
            arm = sqrt(Jet(0.02L * 0.02L + 0.13L * 0.13L));
  const Vec2 left{{travel - Jet(0.6L), 0}}, right{{travel, 0}};
  add(v, "EL", meet(left, rod, Vec2{{Jet(-0.6L), Jet(0.1L)}}, arm, Side::left));
  add(v, "ER", meet(right, rod, Vec2{{Jet(0.6L), Jet(0.1L)}}, arm, Side::right));
  return v;
}

/// The tip goes along the x axis, and the tool keeps its direction.
Values belt_arm(double t) {
  const Jet drawn = atan2(Jet(0.4L), Jet(0.3L)), shoulder = degrees(t, 750, 200, 40);
  const Jet turned = shoulder - drawn, elbow = Jet(-2) * drawn - Jet(2) * turned;
  const Jet wrist = Jet(pi / 2) + drawn + turned;
  const Vec2 W{{cos(shoulder), 0}};
  Values v{{"elbow", elbow}, {"wrist", wrist}};
  add(v, "E", polar(Jet(0.5L), shoulder));
  add(v, "W", W);
  add(v, "T", W + Vec2{{0, Jet(0.1L)}});
  return v;
}

Values screw_jack(double t) {
  const Jet turn = degrees(t, 20, 720, -100);
  const Jet lift = Jet(0.04L) + Jet(0.005L / 360 / degree) * turn;
  Values v{{"lift", lift}, {"A.z", lift}, {"B.z", lift}};
  add(v, "B", polar(Jet(0.02L), turn));
  return v;
}

Values mimic_gripper(double t) {
  const Vec2 H{{0, Jet(0.05L) + Jet(0.03L) * sin(Jet(pi) * Jet::time(t))}};
  const Vec2 P{{Jet(-0.2L), Jet(0.3L)}}, K0{{Jet(-0.25L), Jet(0.15L)}}, T0{{Jet(-0.1L), Jet(0.6L)}};
  const Vec2 K = meet(H, norm(K0 - Vec2{{0, Jet(0.05L)}}), P, norm(K0 - P), Side::left);
  const Vec2 T = carried(P, K, P, K0, T0);
  const Jet alpha = angle(T - P), beta = Jet(pi) - alpha;
  Values v{{"alpha", alpha}, {"beta", beta}};
  add(v, "TL", T);
  add(v, "TR", Vec2{{-T[0], T[1]}});
  return v;
}

/// What is geared to an angle that nothing drives starts three turns from the drawing, too.
Values wound_drum(double t) {
  const Jet theta = degrees(t, 1140, 300, 0), rel = theta - Jet(pi / 2);
  const Jet drum = Jet(pi / 2) - Jet(10.0L / 30) * theta;
  Values v{{"rel", rel}, {"drum", drum}};
  add(v, "B", Vec2{{3, 0}} + polar(Jet(1), drum));
  return v;
}

/// Nothing is coupled, nor drawn: bodies have frames, whose places are 14 % of its size off.
Values excavator(double t) {
  const auto cylinder = [&](Real mean, Real amplitude, Real frequency) {
    return Jet(mean) + Jet(amplitude) * sin(Jet(2 * pi * frequency) * Jet::time(t));
  };
  const Vec2 O{{0, 0}}, G{{Jet(0.45L), Jet(-0.35L)}};
  const Vec2 b{{Jet(1.9L), Jet(0.75L)}}, d{{Jet(2.2L), Jet(1.05L)}}, s{{Jet(3.8L), Jet(0.1L)}};
  const Vec2 B = meet(G, cylinder(2.15L, 0.1L, 0.5L), O, norm(b), Side::right);
  const Vec2 D = carried(O, B, O, b, d), S = carried(O, B, O, b, s);
  const Vec2 e{{Jet(-0.55L), Jet(0.15L)}}, k{{Jet(0.1L), Jet(0.45L)}}, h{{Jet(1.55L), 0}};
  const Vec2 E = meet(D, cylinder(1.95L, 0.2L, 0.5L), S, norm(e), Side::left);
  const Vec2 K = carried(S, E, O, e, k), H = carried(S, E, O, e, h),
             T = carried(S, E, O, e, {{Jet(1.85L), 0}});
  const Vec2 J = meet(K, cylinder(1.45L, 0.15L, 1), H, Jet(0.42L), Side::left);
  const Vec2 n{{Jet(0.05L), Jet(0.32L)}};
  const Vec2 N = meet(J, Jet(0.4L), T, norm(n), Side::left);
  Values v;
  add(v, "D", D), add(v, "S", S), add(v, "K", K), add(v, "J", J), add(v, "N", N);
  add(v, "u", unit(B - G)), add(v, "v", unit(E - D));
  add(v, "tip", carried(T, N, O, n, {{1, Jet(-0.1L)}}));
  return v;
}

/// The spline through a table, from its moments m = f″ at the knots by elimination: natural, or
/// closed, with the rise of a table that repeats.
class Interpolation {
 public:
  Interpolation(std::vector<Real> at, std::vector<Real> z, bool closed)
      : at_(std::move(at)), z_(std::move(z)), closed_(closed) {
    const std::size_t n = at_.size() - 1, rows = n + 1;
    std::vector<std::vector<Real>> a(rows, std::vector<Real>(rows + 1, 0));
    const auto add = [&](std::size_t row, std::size_t i, bool at_end, int sign) {
      const Real h = at_[i + 1] - at_[i], slope = (z_[i + 1] - z_[i]) / h;
      a[row][i] += (at_end ? 1 : 2) * h;
      a[row][i + 1] += (at_end ? 2 : 1) * h;
      a[row][rows] += sign * 6 * slope;
    };
    for (std::size_t i = 1; i < n; ++i) add(i, i - 1, true, -1), add(i, i, false, 1);
    if (closed) {
      add(0, n - 1, true, -1), add(0, 0, false, 1);
      a[n][0] = 1, a[n][n] = -1;
    } else {
      a[0][0] = a[n][n] = 1;
    }
    for (std::size_t k = 0; k < rows; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k; i < rows; ++i)
        if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
      std::swap(a[k], a[pivot]);
      for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = rows + 1; i != k && j-- > k;) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
    }
    for (std::size_t k = 0; k < rows; ++k) m_.push_back(a[k][rows] / a[k][k]);
  }

  Jet operator()(Jet x) const {
    const Real length = at_.back() - at_.front();
    const Real turns = closed_ ? std::floor((x.v - at_.front()) / length) : 0;
    x = x - Jet(turns * length);
    std::size_t i = 0;
    while (i + 2 < at_.size() && x.v >= at_[i + 1]) ++i;
    const Real h = at_[i + 1] - at_[i];
    const Jet right = (x - Jet(at_[i])) / Jet(h), left = Jet(1) - right, sixth = Jet(h * h / 6);
    return Jet(turns * (z_.back() - z_.front())) + left * Jet(z_[i]) + right * Jet(z_[i + 1]) +
           sixth * (Jet(m_[i]) * (left * left * left - left) +
                    Jet(m_[i + 1]) * (right * right * right - right));
  }

 private:
  std::vector<Real> at_, z_, m_;
  bool closed_;
};

Values cam_dwell(double t) {
  static const Interpolation lift({0, 60, 90, 120, 150, 180, 240, 300, 360},
                                  {0, 1, 5, 9, 10, 10, 10, 3, 0}, true);
  const Jet a = degrees(t, 750, 300, 60);
  const Jet s = Jet(0.001L) * (Jet(30) + lift(a / Jet(degree)));
  return {{"s", s}, {"F.y", s}};
}

Values indexing(double t) {
  static const Interpolation angle({0, 60, 120, 150, 180, 210, 240, 300, 360},
                                   {0, 0, 0, 10, 45, 80, 90, 90, 90}, true);
  const Real x = Real(0.06) - Real(0.05), y = Real(0.01);  // of the file, as doubles
  const Jet w = Jet(std::atan2(y, x)) + Jet(degree) * angle(degrees(t, -500, 700, 0) / Jet(degree));
  Values v{{"w", w}};
  add(v, "B", Vec2{{Jet(Real(0.05)), 0}} + polar(Jet(std::sqrt(x * x + y * y)), w));
  return v;
}

/// The pin's place along the rail is unknown: Newton's method, then rates by the chain rule.
Values curved_rail(double t) {
  static const Interpolation rail({0, 10, 20, 35, 50}, {80, 88, 100, 112, 140}, false);
  const Jet y = Jet(105) + Jet(20) * sin(Jet(pi) * Jet::time(t));
  Jet x(20);
  for (int i = 0; i < 60; ++i) {
    const Jet at = rail(Jet(x.v, 1, 0));
    x = Jet(x.v + (y.v - at.v) / at.d, y.d / at.d, 0);
    x.dd = (y.dd - at.dd * x.d * x.d) / at.d;
  }
  const Vec2 P{{Jet(0.001L) * x, Jet(0.001L) * y}};
  Values v{{"x", P[0]}};
  add(v, "P", P);
  add(v, "A", meet(Vec2{{0, 0}}, Jet(0.1L), P, Jet(std::sqrt(0.0068L)), Side::left));
  return v;
}

/// A crank on a tilted hinge leads a lever in space by a pin in its slot, and carries a plane on
/// which a puck lies. Q of the puck keeps to an upright line, R to an upright plane.
Values guides(double t) {
  const Jet seventh(1.0L / 7);
  const Vec3 u = seventh * Vec3{{6, 2, -3}}, v = seventh * Vec3{{-3, 6, -2}},
             w = seventh * Vec3{{2, 3, 6}};
  const Jet theta = degrees(t, 0, 200, 60), reach(0.7L);
  const Vec3 H = reach * w, B = reach * (cos(theta) * u + sin(theta) * v + w);
  const Vec3 way{{B[0] + Jet(2), B[1] - Jet(0.5L), 0}};
  const Vec3 slope = (Jet(1) / norm(way)) * way + Vec3{{0, 0, Jet(0.25L)}};
  const Vec3 D{{-2, Jet(0.5L), B[2] - Jet(0.25L) * norm(way)}};
  const Vec3 n0 = unit(Vec3{{1, 2, 6}}), n = rotated(n0, w, theta);
  const Vec3 Q0{{Jet(0.4L), 1, Jet(0.9L)}}, R0{{1, Jet(1.2L), Jet(0.5L)}};
  const Vec3 M{{Q0[0], Q0[1], 0}};
  const Vec3 Q = M + ((dot(n0, Q0 - H) - dot(n, M - H)) / n[2]) * z_axis;
  const Jet up = dot(n0, R0 - Q0), along = norm(R0 - Q0 - up * n0);
  const Vec3 level = unit(cross(y_axis, n)), rise = cross(n, level);
  const Jet sine = (R0[1] - Q[1] - up * n[1]) / (along * rise[1]);
  Values values{{"psi", angle(Vec2{{way[0], way[1]}})}, {"lift", D[2]}};
  add(values, "B", B), add(values, "D", D), add(values, "s", unit(slope));
  add(values, "Q", Q), add(values, "n", n);
  add(values, "R", Q + up * n + along * (sqrt(Jet(1) - sine * sine) * level + sine * rise));
  return values;
}

struct Coupled {
  const char* scene;
  Values (*at)(double t);
  bool exact = false;  ///< the closed form has the numbers of the file to their last digit
};

void PrintTo(const Coupled& coupled, std::ostream* out) { *out << coupled.scene; }

constexpr Coupled all[] = {
    {"cam_dwell", cam_dwell, true},
    {"indexing", indexing, true},
    {"curved_rail", curved_rail},
    {"gear_train", gear_train},
    {"planetary_gear", planetary_gear},
    {"rack_steering", rack_steering},
    {"belt_arm", belt_arm},
    {"screw_jack", screw_jack},
    {"mimic_gripper", mimic_gripper},
    {"wound_drum", wound_drum},
    {"excavator", excavator},
    {"guides", guides},
};

/// Every coupling counts whole turns, so angles are compared as they are.
class Couplings : public Loading, public testing::WithParamInterface<Coupled> {
 protected:
  void SetUp() override {
    scene_ = read_scene(fs::path(DESMO_SOURCE_DIR) / "tests/load/scenes" /
                        (std::string(GetParam().scene) + ".scene.json"));
    model_ = make_model(scene_);
    for (int i = 0; i < scene_.grid.instants; ++i)
      exact_.push_back(GetParam().at(scene_.grid.time(i)));
    for (const Values& values : exact_)
      for (const auto& [name, x] : values) {
        auto& largest = scale_.emplace(name, std::array{1.0, 1.0, 1.0}).first->second;
        const Real of_level[] = {x.v, x.d, x.dd};
        for (int level = 0; level < 3; ++level)
          largest[level] = std::max(largest[level], static_cast<double>(std::abs(of_level[level])));
      }
  }

  /// radius: of what is found, where it is to hold.
  void compare(int i, const PerLevel<std::span<const double>>& found, const std::string& what,
               const PerLevel<std::span<const double>>* radius = nullptr) {
    constexpr Real closed_form = 2e-17;  // its own error
    for (const auto& [name, x] : exact_[i]) {
      const Real of_level[] = {x.v, x.d, x.dd};
      for (const Level level : all_levels) {
        const int l = static_cast<int>(level);
        const Real off = std::abs(model_.value(name, found[level], level) - of_level[l]);
        EXPECT_LE(off, 1e-12 * scale_[name][l])
            << what << ": " << name << ", level " << l << ", row " << i;
        if (radius)
          EXPECT_LE(off,
                    model_.value(name, (*radius)[level], level) + closed_form * scale_[name][l])
              << what << ": " << name << ", level " << l << ", row " << i;
      }
    }
  }

  std::unique_ptr<Formulation> made(const std::string& id, KernelTable& table) {
    const Configuration c = parse_id(id, {.tolerance = 1e-14});
    if (c.variant->evaluation == Evaluation::symbolic) {
      EXPECT_EQ(load(table, id).problem, "") << id;
    }
    auto f = make_formulation(*c.variant, model_, c.settings, table);
    EXPECT_TRUE(std::ranges::all_of(parts_of(*f), &DefinedPart::as_named)) << id;
    return f;
  }

  /// Compares a run that is not checked.
  void compare_run(const std::string& id, KernelTable& table) {
    const auto f = made(id, table);
    Everything found(scene_.grid.instants);
    EXPECT_TRUE(f->run(scene_.grid, {}, found).ok()) << id;
    const std::size_t n = static_cast<std::size_t>(model_.coordinates());
    for (int i = 0; i < scene_.grid.instants; ++i) {
      const std::span<const double> all = found.all[i];
      ASSERT_EQ(all.size(), 3 * n) << id;
      compare(i, {all.first(n), all.subspan(n, n), all.last(n)}, id);
    }
  }

  std::vector<Values> exact_;
  std::map<std::string, std::array<double, 3>> scale_;  // largest of a motion, at least 1
};

TEST_P(Couplings, KeepTheClosedForm) {
  KernelTable table;
  for (const std::string id :
       {"global_automatic_klu", "group_automatic_lapack", "block_automatic_eigen",
        "global_symbolic_klu", "group_symbolic_lapack", "group_symbolic_inlined",
        "group_symbolic_explicit", "block_symbolic_inlined", "block_symbolic_explicit"}) {
    const auto f = made(id, table);
    CheckOptions options;
    int rows = 0, flagged = 0;
    options.checked = [&](const CheckedInstant& i) {
      ++rows;
      flagged += i.flag.has_value();
      compare(i.instant.index, {i.instant.q, i.instant.qd, i.instant.qdd}, id + ", checked",
              GetParam().exact ? &i.radius : nullptr);
    };
    Everything found(scene_.grid.instants);
    EXPECT_TRUE(run_checked(*f, scene_.grid, {}, found, options).ok()) << id;
    EXPECT_EQ(rows, scene_.grid.instants) << id;
    EXPECT_EQ(flagged, 0) << id;
    compare_run(id, table);
    if (HasFailure()) return;
  }
}

class CouplingsInSegments : public Couplings {};

TEST_P(CouplingsInSegments, CountWholeTurns) {
  KernelTable table;
  compare_run("group_symbolic_explicit/segments:4", table);
  compare_run("group_automatic_lapack/threads:2", table);
}

TEST_P(Couplings, AreReadAgainAsTheyAreWritten) {
  const Mechanism again = parse_mechanism(write_mechanism(scene_.mechanism), "again.json");
  for (std::size_t b = 0; b < again.bodies.size(); ++b)
    if (const auto& own = scene_.mechanism.bodies[b].own)
      EXPECT_EQ(again.bodies[b].own->origin, own->origin);
  ASSERT_EQ(again.couplings.size(), scene_.mechanism.couplings.size());
  for (std::size_t k = 0; k < again.couplings.size(); ++k) {
    const Mechanism::Coupling &a = again.couplings[k], &b = scene_.mechanism.couplings[k];
    EXPECT_EQ(a.name, b.name);
    ASSERT_EQ(a.terms.size(), b.terms.size());
    for (std::size_t i = 0; i < a.terms.size(); ++i) {
      EXPECT_EQ(a.terms[i].coordinate, b.terms[i].coordinate);
      EXPECT_EQ(a.terms[i].factor.value, b.table ? 1 : b.terms[i].factor.value);
    }
    ASSERT_EQ(a.table.has_value(), b.table.has_value());
    if (!b.table) continue;
    const auto compare = [](const std::vector<double>& in_si, const std::vector<double>& numbers,
                            const Derived& factor) {
      ASSERT_EQ(in_si.size(), numbers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i)
        EXPECT_EQ(in_si[i], (Derived(numbers[i]) / factor).value);
    };
    compare(a.table->arguments, b.table->arguments, b.terms[1].factor);
    compare(a.table->values, b.table->values, b.terms[0].factor);
    EXPECT_EQ(a.table->ends, b.table->ends);
    ASSERT_EQ(a.table->from.has_value(), b.table->from.has_value());
    if (b.table->from) EXPECT_EQ(a.table->from->value, b.table->from->value);
  }
}

std::string scene_name(const testing::TestParamInfo<Coupled>& info) { return info.param.scene; }

INSTANTIATE_TEST_SUITE_P(Table, Couplings, testing::ValuesIn(all), scene_name);
INSTANTIATE_TEST_SUITE_P(Table, CouplingsInSegments,
                         testing::Values(Coupled{"belt_arm", belt_arm},
                                         Coupled{"wound_drum", wound_drum},
                                         Coupled{"indexing", indexing}),
                         scene_name);

/// Five pins on curved rails, of which tables and motions differ. `longer` has one more knot.
class Rails : public Loading {
 protected:
  static constexpr int count = 5, longer = 4;

  void SetUp() override {
    MechanismBuilder b("rails", 2);
    scene_.motions.clear();
    for (int k = 0; k < count; ++k) {
      const double at = 0.3 * k;
      const auto named = [&](const char* name) { return name + std::to_string(k); };
      const int o = b.point(named("O"), {at, 0}), a = b.point(named("A"), {at - 0.06, 0.08}),
                p = b.point(named("P"), {at + 0.02, 0.1});
      b.carry(MechanismBuilder::ground, {o});
      const int crank = b.body(named("crank"), {o, a}), rod = b.body(named("rod"), {a, p});
      b.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, crank, {o});
      b.joint(Mechanism::JointType::revolute, crank, rod, {a});
      for (const int axis : {0, 1}) {
        Mechanism::Coordinate& c =
            b.coordinate(named(axis ? "y" : "x"), Mechanism::CoordinateType::component);
        c.point = p, c.axis = axis, c.driven = axis == 1;
      }
      b.couple(named("rail"), {{2 * k + 1, 1}, {2 * k, 1}});
      scene_.motions.push_back(HarmonicSum{0.105, {{0.02, 3, 0.9 * k}}});
    }
    scene_.mechanism = b.release();
    for (int k = 0; k < count; ++k) {
      const double at = 0.3 * k, bend = 0.0004 * k;
      scene_.mechanism.couplings[k].table = {
          {at, at + 0.01, at + 0.02, at + 0.035 - bend, at + 0.05},
          {0.08, 0.088 + bend, 0.1, 0.112, 0.14}};
    }
    Mechanism::Coupling::Table& table = *scene_.mechanism.couplings[longer].table;
    table.arguments.push_back(table.arguments.back() + 0.01);
    table.values.push_back(0.15);
    scene_.grid = {0, 0.01, 300};
    scene_.request.clear();
    model_ = make_model(scene_);
  }
};

TEST_F(Rails, AreSolvedAtOnceAsOneByOne) {
  KernelTable table;
  const auto run = [&](const std::string& id, int parts, Everything& found) {
    const Configuration c = parse_id(id);
    EXPECT_EQ(load(table, id).problem, "") << id;
    const auto f = make_formulation(*c.variant, model_, c.settings, table);
    EXPECT_TRUE(f->run(scene_.grid, {}, found).ok()) << id;
    EXPECT_EQ(static_cast<int>(parts_of(*f).size()), parts) << id;
  };
  Everything expected(scene_.grid.instants);
  const std::string id = "group_symbolic_explicit";
  run(id, count, expected);
  for (const int lanes : lanes_here()) {
    Everything found(scene_.grid.instants);
    run(id + "/lanes:" + std::to_string(lanes), 2, found);
    expect_same(found, expected, id + "/lanes:" + std::to_string(lanes));
  }
}

/// Outside of a table that does not repeat there is no position: neither an unchecked run nor a
/// checked one delivers any.
TEST(CouplingByTable, HasNoPositionsOutside) {
  Scene scene = read_scene(fs::path(DESMO_SOURCE_DIR) / "tests/load/scenes/curved_rail.scene.json");
  std::get<HarmonicSum>(scene.motions[0]).terms[0].amplitude = 0.05;  // m: the table has 0.035
  const Model model = make_model(scene);
  for (const char* id : {"global_automatic_klu", "group_automatic_lapack"}) {
    const auto f = make_formulation(find_variant(id), model);
    Everything found(scene.grid.instants);
    const Summary summary = f->run(scene.grid, {}, found);
    EXPECT_FALSE(summary.ok()) << id;
    EXPECT_LT(summary.instants, scene.grid.instants) << id;
    EXPECT_NE(describe(summary, model).find("'rail: coupling', which is outside of its table"),
              std::string::npos)
        << describe(summary, model);
    CheckOptions options;
    options.checked = [&](const CheckedInstant& i) {
      EXPECT_TRUE(i.flag || i.instant.q[model.coordinate("x")] <= 0.05 + 1e-10) << id;
    };
    EXPECT_FALSE(run_checked(*f, scene.grid, {}, found, options).ok()) << id;
  }
}

}  // namespace
}  // namespace desmo::load::couplings_test
