// Dimensions that are derived from numbers of the file, against Arb.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "cases/io/files.h"
#include "cases/mechanism/formatted.h"
#include "formulations/constraints/constraints.h"
#include "formulations/modelling/modelling.h"
#include "tests/certificate/arb/ball.h"

namespace desmo::arb_test {
namespace {

double number(std::mt19937& generator) {
  return std::uniform_real_distribution<double>(-1, 1)(generator);
}

/// Largest quotients of an error and its radius.
struct Attained {
  double largest = 0;

  void add(const Derived& x, const Ball& exact) {
    const double error = exact.distance(Ball(x.value) + Ball(x.correction));  // to 1e-75
    EXPECT_LE(error, x.radius * (1 + 1e-9) + 1e-70);
    // A second double leaves little.
    EXPECT_LE(error, 0x1p-95 * (std::abs(x.value) + 1));
    if (x.radius > 1e-60) largest = std::max(largest, error / x.radius);
  }
};

/// Radii of sums and products take up rounding, by a factor of up to four.
TEST(Derived, HoldsEachOperation) {
  std::mt19937 generator(1);
  std::map<std::string, Attained> attained;
  for (int sample = 0; sample < (DESMO_SANITIZED ? 1000 : 100'000); ++sample) {
    const double p = number(generator), q = number(generator), r = number(generator);
    const Derived a = Derived(p) * q, b = Derived(r) * r + 1;
    // Operands are exact here, so that each operation stands for itself.
    const Derived u(a.value, {a.correction, 0}), v(b.value, {b.correction, 0});
    const Ball s(u), t(v);
    attained["sum"].add(u + v, s + t);
    attained["product"].add(u * v, s * t);
    attained["quotient"].add(u / v, s / t);
    attained["root"].add(sqrt(v), sqrt(t));
  }
  for (const auto& [operation, a] : attained) {
    EXPECT_GT(a.largest, 0.25) << operation;
    EXPECT_LE(a.largest, 1) << operation;
  }
}

using Place = std::array<Ball, 3>;

Place difference(const Place& a, const Place& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Ball norm(const Place& a) { return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }
Place unit(const Place& a) { return {a[0] / norm(a), a[1] / norm(a), a[2] / norm(a)}; }

/// A mechanism file of random numbers, and where it draws everything.
struct RandomFile {
  int dimension;
  std::string text;
  std::map<std::string, Place> places;

  /// Draws a list of entities.
  std::string draw(const std::vector<std::string>& names, bool vectors, std::mt19937& g) {
    std::string list;
    for (const std::string& name : names) {
      Place& place = places[name];
      list += (list.empty() ? "\"" : ", \"") + name + "\": [";
      for (int i = 0; i < dimension; ++i) {
        const double x = number(g);
        place[i] = Ball(x);
        list += formatted(i == 0 ? "%.17g" : ", %.17g", x);
      }
      list += ']';
      if (vectors) place = unit(place);
    }
    return list;
  }
};

/// A crank and a plate, with points, vectors and lines in all manners of definition.
RandomFile random_plane(std::mt19937& g) {
  RandomFile f{2, {}, {}};
  const std::string points = f.draw({"O", "A", "P", "Q"}, false, g), u = f.draw({"u"}, true, g);
  f.places["w"] = unit(difference(f.places["O"], f.places["A"]));
  f.text = R"({"format": "desmo-mechanism", "version": 1, "name": "random", "dimension": 2,
    "points": {)" +
           points + R"(}, "vectors": {)" + u + R"(, "w": {"along": ["O", "A"]}},
    "ground": {"points": ["O"]},
    "bodies": {"crank": {"points": ["O", "A"], "vectors": ["w"]},
               "plate": {"points": ["A", "P", "Q"], "vectors": ["u"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
               {"type": "revolute", "bodies": ["crank", "plate"], "points": ["A"]}],
    "coordinates": {"a": {"angle": ["O", "A"]}, "b": {"angle": ["A", "P"], "from": ["O", "A"]}},
    "drivers": ["a", "b"]})";
  return f;
}

/// An arm with two vectors and a plate with one, about two axes.
RandomFile random_space(std::mt19937& g) {
  RandomFile f{3, {}, {}};
  const std::string points = f.draw({"O", "A", "P", "Q", "R", "S"}, false, g),
                    vectors = f.draw({"z", "y"}, true, g);
  f.places["n"] = f.places["k"] = unit(cross(f.places["z"], f.places["y"]));
  f.places["m"] = unit(cross(f.places["n"], f.places["z"]));
  f.text = R"({"format": "desmo-mechanism", "version": 1, "name": "random", "dimension": 3,
    "points": {)" +
           points + R"(}, "vectors": {)" + vectors + R"(,
      "n": {"normal": ["z", "y"]}, "k": {"normal": ["z", "y"]}, "m": {"normal": ["n", "z"]}},
    "ground": {"points": ["O"], "vectors": ["z", "n", "m"]},
    "bodies": {"arm": {"points": ["O", "A", "P"], "vectors": ["z", "y", "k"]},
               "plate": {"points": ["A", "Q", "R", "S"], "vectors": ["y"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "arm"], "points": ["O"], "vectors": ["z"]},
               {"type": "revolute", "bodies": ["arm", "plate"], "points": ["A"],
                "vectors": ["y"]}],
    "coordinates": {"a": {"angle": "k", "from": "n", "towards": "m"},
                    "b": {"distance": ["O", "Q"]}},
    "drivers": ["a", "b"]})";
  return f;
}

/// Expects that every equation between points and vectors holds where the file draws these, within
/// the radii of its dimensions. Kinds with one dimension tell its error.
void expect_closed(const RandomFile& file, std::map<std::string, Attained>& attained) {
  const Mechanism mechanism = parse_mechanism(file.text, "random.json");
  const Model m =
      model_mechanism(mechanism, {Motion(Polynomial{{0.1}}), Motion(Polynomial{{0.1}})}).model;
  const auto place = [&](const Entity& e) {
    const auto found = file.places.find(e.name.starts_with("ground: ") ? e.name.substr(8) : e.name);
    return found == file.places.end() ? nullptr : &found->second;
  };
  for (const Entity& e : m.entities)
    for (int i = 0; e.fixed && i < e.size; ++i)
      attained["direction"].add(m.fixed_value(e.first + i), (*place(e))[i]);
  for (const Constraint& c : m.constraints)
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      std::array<const Ball*, Kind::operand_sizes.size()> x;
      for (std::size_t k = 0; k < x.size(); ++k) {
        const Place* p = place(m.entities[c.operands[k]]);
        if (!p) return;
        x[k] = p->data();
      }
      std::array<Ball, Kind::constants + 1> dimensions;
      for (int k = 0; k < Kind::constants; ++k) dimensions[k] = Ball(c.constants[k]);
      std::array<Ball, Kind::rows> phi;
      Kind::residual(x.data(), dimensions.data(), phi.data());
      for (Ball& row : phi) EXPECT_TRUE(arb_contains_zero(row.get())) << c.name;
      if constexpr (Kind::constants == 1 && Kind::rows == 1) {
        dimensions[0] = Ball(0);
        Kind::residual(x.data(), dimensions.data(), phi.data());
        attained[std::string(Kind::name)].add(c.constants[0], phi[0]);
      }
    });
}

TEST(Dimensions, AreThoseOfTheFile) {
  std::mt19937 generator(1);
  std::map<std::string, Attained> attained;
  for (int sample = 0; sample < (DESMO_SANITIZED ? 25 : 100); ++sample) {
    expect_closed(random_plane(generator), attained);
    expect_closed(random_space(generator), attained);
  }
  for (const char* name : {"direction", "length2", "length3", "dot3", "projection3"}) {
    EXPECT_GT(attained[name].largest, 0.1) << name;
    EXPECT_LE(attained[name].largest, 1) << name;
  }
}

}  // namespace
}  // namespace desmo::arb_test
