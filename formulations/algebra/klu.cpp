// Sparse LU by SuiteSparse's KLU.

#include "formulations/algebra/backend.h"
#include "formulations/algebra/klu_factors.h"

namespace desmo {

extern const Backend klu_backend{
    .name = "klu",
    .make_solver = [](const Pattern& pattern,
                      const Settings& settings) -> std::unique_ptr<LinearSolver> {
      return std::make_unique<KluFactors>(pattern, settings.btf);
    },
    .version = [] { return version_text(KLU_MAIN_VERSION, KLU_SUB_VERSION, KLU_SUBSUB_VERSION); },
    .has_btf = true};

}  // namespace desmo
