#include <algorithm>
#include <vector>

#include "formulations/algebra/backend.h"

namespace desmo {

// The list of this build's libraries: a line DESMO_BACKEND(name) for each, written by CMake.
#define DESMO_BACKEND(name) extern const Backend name##_backend;
#include "backends.inc"
#undef DESMO_BACKEND

namespace {

constexpr const Backend* built[] = {
#define DESMO_BACKEND(name) &name##_backend,
#include "backends.inc"
#undef DESMO_BACKEND
};

std::vector<const Backend*> built_and(bool there) {
  std::vector<const Backend*> found;
  for (const Backend* b : built)
    if ((!b->absence || b->absence().reason.empty()) == there) found.push_back(b);
  return found;
}

}  // namespace

std::span<const Backend* const> backends() {
  static const std::vector<const Backend*> there = built_and(true);
  return there;
}

const Backend* find_backend(std::string_view name) {
  const auto found = std::ranges::find(backends(), name, &Backend::name);
  return found == backends().end() ? nullptr : *found;
}

std::span<const Backend* const> absent_backends() {
  static const std::vector<const Backend*> absent = built_and(false);
  return absent;
}

}  // namespace desmo
