#include <desmo/cases/generators/cases.h>
#include <desmo/formulations/modelling/modelling.h>
#include <desmo/formulations/variants.h>

#include <cstdio>

int main() {
  const desmo::Model model = desmo::make_model(desmo::four_bar(3));
  const auto formulation =
      desmo::make_formulation(desmo::find_variant("group_symbolic_inlined"), model);
  const desmo::Summary summary = formulation->assemble(0);
  std::puts(desmo::describe(summary, model).c_str());
  return summary.ok() ? 0 : 1;
}
