// Row 10: invalid mechanisms, and drivers that stop being finite numbers.
#include <limits>
#include <string>
#include <utility>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr TimeGrid grid{0, 0.1, 41};

using Dyad = DyadChain::Dyad;

ExtremeCase refused(ExtremeCase c) {
  c.chains.clear();  // there is no answer
  c.is_refused = true;
  return c;
}

/// Makes a case that must be refused: `damage` changes the last dyad.
ExtremeCase damaged(std::string name, void (*damage)(Dyad&)) {
  DyadChain chain = usual_chain(2, chain_start);
  damage(chain.dyads.back());
  return refused(case_of(std::move(name), chain, 1, grid));
}

ExtremeCase driven_by(std::string name, Motion motion) {
  return case_of(std::move(name), std::vector{usual_chain(2, chain_start)}, {std::move(motion)},
                 grid);
}

/// Returns a motion that is NaN after `seconds`: there ω t of its second term overflows, and the
/// sine of infinity is NaN. Until then this term is 0, since its amplitude is 0.
Motion not_a_number_from(double seconds) {
  const double overflowing = std::numeric_limits<double>::max() / seconds;
  return HarmonicSum{chain_start, {{1, 0.5, 0}, {0, overflowing, 0}}};
}

/// Returns a motion with the term 1e-100 t¹⁶⁰, which is below 1e-23 up to 3 s and has overflowed at
/// 500 s.
Motion infinite_at_500_s() {
  std::vector<Derived> coefficients(161);
  coefficients[0] = chain_start;
  coefficients[1] = 0.001;
  coefficients.back() = 1e-100;
  return Polynomial{std::move(coefficients)};
}

}  // namespace

std::vector<ExtremeCase> bad_input(Extent) {
  ExtremeCase infinite = driven_by("a driver infinite at 500 s", infinite_at_500_s());
  infinite.scene.grid = {0, 500, 3};
  return {damaged("a length NaN", [](Dyad& d) { d.rocker = nan; }),
          damaged("an infinite length", [](Dyad& d) { d.rocker = infinity; }),
          damaged("a length of zero", [](Dyad& d) { d.rocker = 0; }),
          damaged("a negative length", [](Dyad& d) { d.rocker = -6; }),
          damaged("a point at NaN",
                  [](Dyad& d) {
                    d.pivot = {nan, 0, 0};
                  }),
          damaged("a rocker's pivots coincide", [](Dyad& d) { d.pivot = d.joint; }),
          refused(driven_by("a motion with NaN", Polynomial{{chain_start, nan}})),
          // No proof encloses the sine of a phase near 1e308 rad, even if its amplitude is 0.
          may_fail(driven_by("a driver NaN after 1.75 s", not_a_number_from(1.75))), infinite};
}

}  // namespace desmo::extremes
