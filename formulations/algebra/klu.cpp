// Sparse LU by SuiteSparse's KLU.

#include "formulations/algebra/klu_factors.h"
#include "formulations/algebra/klu_of_one_block.h"

namespace desmo {

namespace {

std::unique_ptr<Part> make_klu_part(const PartContext& c) {
  return c.settings.btf == BlockTriangularForm::on ? make_newton_part<KluFactors>(c)
                                                   : make_klu_of_one_block(c);
}

}  // namespace

extern const Backend klu_backend;
const Backend klu_backend{"klu", false, &make_klu_part, [] {
                            return std::to_string(KLU_MAIN_VERSION) + "." +
                                   std::to_string(KLU_SUB_VERSION) + "." +
                                   std::to_string(KLU_SUBSUB_VERSION);
                          }};

}  // namespace desmo
