#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// Returns a model that encloses every mechanism that rounds to the same file. Each number of the
/// file varies by its last digit: by u = 2⁻⁵³ times itself when read, and again when turned into
/// metres. The radii of dimensions and fixed values grow accordingly, and rows get a
/// Constraint::slack. Values and corrections are unchanged. Radii follow from measuring dimensions
/// anew at the estimate, which is the drawing. Dimensions that share a point vary independently.
///
/// Motions do not vary, nor do zeros outside directions.
Model with_file_variation(const Model& model);

}  // namespace desmo
