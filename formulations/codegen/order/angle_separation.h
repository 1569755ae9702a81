#pragma once

#include <optional>

#include "formulations/codegen/order/explicit_order.h"
#include "formulations/codegen/order/type_blocks.h"

namespace desmo::generate {

/// What two equations of an angle say of everything else, and how the angle follows from that.
struct SeparatedAngle {
  Said rest;
  Definition angle;
};

/// Two equations M (cos θ, sin θ)ᵀ + c = 0, M a known turn stretched by R, say ‖c‖ = R and which
/// way. In the block the former takes their place; the angle follows when c is known. angle: an
/// unknown of the block. Nothing when there are no two such equations.
std::optional<SeparatedAngle> separate_angle(const Block& block, int angle, const PartType& type,
                                             const RecordedPart& part);

}  // namespace desmo::generate
