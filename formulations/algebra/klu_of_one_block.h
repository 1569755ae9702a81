#pragma once

#include <memory>

#include "formulations/algebra/backend.h"

namespace desmo {

/// KLU without block triangular form (BlockTriangularForm::off).
std::unique_ptr<Part> make_klu_of_one_block(const PartContext& context);

}  // namespace desmo
