#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "cases/mechanism/checks.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

using Part = MechanismError::Part;

void check_table(const Mechanism& mechanism, int i) {
  const EntryRefusal refuse{mechanism, Part::coupling, i};
  const Mechanism::Coupling& coupling = mechanism.couplings[i];
  const auto& [arguments, values, ends, from] = *coupling.table;
  if (coupling.terms.size() != 2) refuse("has a table, and not two coordinates; give two");
  try {
    make_spline(arguments, values, ends);
  } catch (const std::invalid_argument& error) {
    refuse(std::string(error.what()) + "; change the table or its ends");
  }
  if (from && !std::isfinite(from->value))
    refuse("what is added to its table is not finite; give a number");
}

void check(const Mechanism& mechanism, int i) {
  const EntryRefusal refuse{mechanism, Part::coupling, i};
  const Mechanism::Coupling& coupling = mechanism.couplings[i];
  const int count = static_cast<int>(coupling.terms.size());
  if (count < Mechanism::Coupling::min_terms || count > Mechanism::Coupling::max_terms)
    refuse("relates " + std::to_string(count) + (count == 1 ? " coordinate" : " coordinates") +
           "; give two to four");
  std::set<int> seen;
  for (const auto& [c, factor] : coupling.terms) {
    if (!is_in(c, mechanism.coordinates)) refuse("refers to a coordinate that does not exist");
    const std::string name = in_quotes(mechanism.coordinates[c].name);
    if (!seen.insert(c).second) refuse("lists " + name + " twice; list it once");
    if (!std::isfinite(factor.value) || factor.value == 0)
      refuse("the factor of " + name + " is 0 or not finite; give another number");
  }
  if (coupling.table) check_table(mechanism, i);
  if (std::ranges::all_of(seen, [&](int c) { return mechanism.coordinates[c].driven; }))
    refuse("all its coordinates are driven; let one of them follow");
}

}  // namespace

void check_couplings(const Mechanism& mechanism) {
  for (int i = 0; i < static_cast<int>(mechanism.couplings.size()); ++i) check(mechanism, i);
}

}  // namespace desmo
