// Row 10: invalid mechanisms, and drivers that stop being finite numbers.
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double start = std::numbers::pi / 3;
constexpr TimeGrid grid{0, 0.1, 41};

ExtremeCase refused(std::string name, const DyadChain& chain) {
  ExtremeCase c = case_of(std::move(name), chain, 1, grid);
  c.chains.clear();  // there is no answer
  c.is_refused = true;
  return c;
}

ExtremeCase with_rocker(std::string name, double length) {
  DyadChain chain = usual_chain(2, start);
  chain.dyads.back().rocker = length;
  return refused(std::move(name), chain);
}

ExtremeCase with_pivot(std::string name, const Mechanism::Vec& at) {
  DyadChain chain = usual_chain(2, start);
  chain.dyads.back().pivot = at;
  return refused(std::move(name), chain);
}

ExtremeCase coincident_pivots() {
  DyadChain chain = usual_chain(2, start);
  chain.dyads.back().pivot = chain.dyads.back().joint;
  return refused("a rocker's pivots coincide", chain);
}

ExtremeCase driven_by(std::string name, Motion motion) {
  return case_of(std::move(name), std::vector{usual_chain(2, start)}, {std::move(motion)}, grid);
}

/// sin(ω t) is no number once ω t has overflowed, here after 1.8 s, and nothing before: its
/// amplitude is 0.
Motion not_a_number_from(double seconds) {
  const double overflowing = std::numeric_limits<double>::max() / seconds;
  return HarmonicSum{start, {{1, 0.5, 0}, {0, overflowing, 0}}};
}

/// t⁴⁰⁰⁰ is beneath notice at 0.8 s and has overflowed at 1.2 s.
Motion infinite_after_a_second() {
  std::vector<double> coefficients(4001, 0);
  coefficients[0] = start;
  coefficients[1] = 0.5;
  coefficients.back() = 1;
  return Polynomial{std::move(coefficients)};
}

ExtremeCase undefined_motion() {
  ExtremeCase c = driven_by("a motion with NaN", Polynomial{{start, nan}});
  c.is_refused = true;
  c.chains.clear();
  return c;
}

}  // namespace

std::vector<ExtremeCase> bad_input(Extent) {
  ExtremeCase infinite = driven_by("a driver infinite after 1 s", infinite_after_a_second());
  infinite.scene.grid = {0, 0.4, 6};
  return {with_rocker("a length NaN", nan),
          with_rocker("an infinite length", infinity),
          with_rocker("a length of zero", 0),
          with_rocker("a negative length", -6),
          with_pivot("a point at NaN", {nan, 0, 0}),
          coincident_pivots(),
          undefined_motion(),
          driven_by("a driver NaN after 1.75 s", not_a_number_from(1.75)),
          infinite};
}

}  // namespace desmo::extremes
