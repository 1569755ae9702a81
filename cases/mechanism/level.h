#pragma once

namespace desmo {

/// Levels of an analysis; each includes those before it.
enum class Level { position, velocity, acceleration };

}  // namespace desmo
