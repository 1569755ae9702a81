#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "cases/mechanism/checks.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

using Part = MechanismError::Part;

void check(const Mechanism& d, int i) {
  const Mechanism::Coupling& coupling = d.couplings[i];
  const int count = static_cast<int>(coupling.terms.size());
  if (count < Mechanism::Coupling::min_terms || count > Mechanism::Coupling::max_terms)
    refuse(d, Part::coupling, i,
           "relates " + std::to_string(count) + (count == 1 ? " coordinate" : " coordinates") +
               "; give two to four");
  std::set<int> seen;
  for (const auto& [c, factor] : coupling.terms) {
    if (!is_in(c, d.coordinates))
      refuse(d, Part::coupling, i, "refers to a coordinate that does not exist");
    const std::string name = in_quotes(d.coordinates[c].name);
    if (!seen.insert(c).second)
      refuse(d, Part::coupling, i, "lists " + name + " twice; list it once");
    if (!std::isfinite(factor.value) || factor.value == 0)
      refuse(d, Part::coupling, i,
             "the factor of " + name + " is 0 or not finite; give another number");
  }
  if (std::ranges::all_of(seen, [&](int c) { return d.coordinates[c].driven; }))
    refuse(d, Part::coupling, i, "all its coordinates are driven; let one of them follow");
}

}  // namespace

void check_couplings(const Mechanism& d) {
  for (int i = 0; i < static_cast<int>(d.couplings.size()); ++i) check(d, i);
}

}  // namespace desmo
