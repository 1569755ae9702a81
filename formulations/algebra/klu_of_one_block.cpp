// A file of its own: where a compiler meets every call twice it makes none in line, which in small
// blocks costs KLU more than a hundredth.

#include "formulations/algebra/klu_of_one_block.h"

#include "formulations/algebra/klu_factors.h"

namespace desmo {

namespace {

/// All unknowns as one block, whatever structure they have.
class KluOfOneBlock : public KluFactors {
 public:
  explicit KluOfOneBlock(const Pattern& pattern) : KluFactors(pattern, BlockTriangularForm::off) {}
};

}  // namespace

std::unique_ptr<Part> make_klu_of_one_block(const PartContext& context) {
  return make_newton_part<KluOfOneBlock>(context);
}

}  // namespace desmo
