#pragma once

#include "formulations/model/model.h"

namespace desmo {

/// Returns a model that encloses every mechanism that rounds to the same file. Each number of the
/// file varies by 2 u times itself, u = 2⁻⁵³: it is rounded when read and when converted to metres.
/// Components of directions vary by 2 u, even zeros. Radii of fixed values grow accordingly. So do
/// those of dimensions, which are measured anew at the estimate (the drawing). Radii also grow for
/// factors of couplings, and for lengths and advances of tables that repeat: their errors count
/// with each turn. All else in linear kinds and in tables gives rows a Constraint::slack.
/// Dimensions that share a point vary independently. Values, corrections and motions stay.
Model with_file_variation(const Model& model);

}  // namespace desmo
