#pragma once

namespace desmo {

/// How far an analysis goes; each level includes those before it.
enum class Level { position, velocity, acceleration };

}  // namespace desmo
