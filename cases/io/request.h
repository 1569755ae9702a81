#pragma once

#include "cases/io/json_document.h"
#include "cases/mechanism/scene.h"

namespace desmo {

/// Reads `request` of a scene, in the order of first mention. An entity requested at several levels
/// is listed once, at the highest. Returns an empty list when the file has no request.
std::vector<Wanted> read_request(const JsonValue& root, const Mechanism& mechanism);

}  // namespace desmo
