#pragma once

#include "cases/io/json_document.h"
#include "cases/mechanism/scene.h"

namespace desmo {

/// `request` of a scene, in the order in which things are first asked for; what is asked for at
/// several levels is there once, at the highest. Empty when the file has none.
std::vector<Wanted> read_request(const JsonValue& root, const Mechanism& mechanism);

}  // namespace desmo
