// Sparse LU by SuiteSparse's KLU.

#include "formulations/algebra/backend.h"
#include "formulations/algebra/klu_factors.h"

namespace desmo {

extern const Backend klu_backend;
const Backend klu_backend{
    "klu", false,
    [](const Pattern& pattern,
       const PartSettings& settings) -> std::unique_ptr<LinearSolver<double>> {
      return std::make_unique<KluFactors>(pattern, settings.btf);
    },
    [] {
      return std::to_string(KLU_MAIN_VERSION) + "." + std::to_string(KLU_SUB_VERSION) + "." +
             std::to_string(KLU_SUBSUB_VERSION);
    }};

}  // namespace desmo
