// Sparse LU by SuiteSparse's KLU.

#include "formulations/algebra/klu_factors.h"

namespace desmo {

namespace {

/// All unknowns as one block, whatever structure they have.
class KluOfOneBlock : public KluFactors {
 public:
  explicit KluOfOneBlock(const Pattern& pattern) : KluFactors(pattern, BlockTriangularForm::off) {}
};

std::unique_ptr<Part> make_klu_part(const PartContext& c) {
  return c.settings.btf == BlockTriangularForm::on ? make_newton_part<KluFactors>(c)
                                                   : make_newton_part<KluOfOneBlock>(c);
}

}  // namespace

extern const Backend klu_backend;
const Backend klu_backend{"klu", false, &make_klu_part, [] {
                            return std::to_string(KLU_MAIN_VERSION) + "." +
                                   std::to_string(KLU_SUB_VERSION) + "." +
                                   std::to_string(KLU_SUBSUB_VERSION);
                          }};

}  // namespace desmo
