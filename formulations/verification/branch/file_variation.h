#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// Returns a model whose derived numbers stand for those of every mechanism that rounds to the same
/// file: radii of dimensions, rows and fixed values hold what becomes of them when each number of
/// the file varies by its last digit (u times itself when it is read, and again when it is turned
/// into metres). Values and corrections are unchanged. A model's estimate is its drawing, at which
/// dimensions are measured anew. They vary each by itself, although they come from the same points.
///
/// Not varied are motions, and zeros outside directions.
Model with_file_variation(const Model& model);

}  // namespace desmo
