#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// Returns a model that encloses every mechanism that rounds to the same file. Each number of the
/// file varies by its last digit: by u times itself when it is read, and again when it is turned
/// into metres. The radii of dimensions and fixed values, and Constraint::slack of rows, grow by
/// what that makes of them; values and corrections are unchanged. Dimensions are measured anew at
/// the estimate, which is the drawing. Each varies by itself, although they share points.
///
/// Motions do not vary, nor do zeros outside directions.
Model with_file_variation(const Model& model);

}  // namespace desmo
