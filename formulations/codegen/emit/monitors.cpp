#include "formulations/codegen/emit/monitors.h"

#include "cases/mechanism/names.h"

namespace desmo::generate {

std::vector<Expr> monitored(const Monitors& monitors) {
  std::vector<Expr> result;
  for (const SizeMonitor& m : monitors.sizes) {
    result.push_back(m.value);
    result.push_back(m.bound * m.against);
  }
  for (const PivotMonitor& m : monitors.pivots)
    for (const auto* list : {&m.magnified, &m.against})
      for (const PivotMonitor::Bound& bound : *list) result.push_back(bound.value);
  for (const PivotMonitor& m : monitors.pivots) result.push_back(m.pivot);
  return result;
}

std::vector<std::string> conditions(const Emitter& emitter, const Monitors& monitors) {
  const std::string& functions = emitter.style().functions;
  std::vector<std::string> result;
  for (const SizeMonitor& m : monitors.sizes)
    result.push_back("(" + emitter.text(m.value) + " > " + emitter.text(m.bound * m.against) + ")");
  for (const PivotMonitor& m : monitors.pivots) {
    for (const auto& [multiplier, bound] : m.magnified)
      result.push_back("(" + functions + "abs(" + emitter.text(multiplier) + ") < " +
                       literal(bound) + ")");
    for (const auto& [above, bound] : m.against)
      result.push_back("(" + functions + "abs(" + emitter.text(m.pivot) + ") > " + literal(bound) +
                       " * " + functions + "abs(" + emitter.text(above) + "))");
  }
  return result;
}

std::string all_of(const std::vector<std::string>& conditions) {
  return conditions.empty() ? "true" : joined(conditions, {}, "\n        & ");
}

}  // namespace desmo::generate
