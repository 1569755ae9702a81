#include <desmo/cases/generators/cases.h>
#include <desmo/formulations/modelling/model.h>
#include <desmo/formulations/variants.h>

#include <cstdio>

int main() {
  const desmo::Mechanism mechanism = desmo::make_mechanism(desmo::four_bar(3));
  const auto formulation =
      desmo::make_formulation(desmo::find_variant("group_symbolic_inlined"), mechanism);
  const desmo::Summary summary = formulation->assemble(0);
  std::puts(desmo::describe(summary, mechanism).c_str());
  return summary.ok() ? 0 : 1;
}
