#include "formulations/algebra/backend.h"

namespace desmo {

// The list of this build: one line DESMO_BACKEND(name) each, written by CMake.
#define DESMO_BACKEND(name) extern const Backend name##_backend;
#include "backends.inc"
#undef DESMO_BACKEND

std::span<const Backend* const> backends() {
  static constexpr const Backend* table[] = {
#define DESMO_BACKEND(name) &name##_backend,
#include "backends.inc"
#undef DESMO_BACKEND
  };
  return table;
}

}  // namespace desmo
