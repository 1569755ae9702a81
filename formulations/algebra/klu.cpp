// Sparse LU by SuiteSparse's KLU.

#include "formulations/algebra/klu_factors.h"

namespace desmo {

extern const Backend klu_backend;
const Backend klu_backend{"klu", false, &make_newton_part<KluFactors>, [] {
                            return std::to_string(KLU_MAIN_VERSION) + "." +
                                   std::to_string(KLU_SUB_VERSION) + "." +
                                   std::to_string(KLU_SUBSUB_VERSION);
                          }};

}  // namespace desmo
