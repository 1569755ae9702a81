#include "tests/properties/formulations.h"

#include <sstream>

#include "formulations/variants.h"

namespace desmo::properties {

namespace {

struct Additions {
  const char *id, *suffixes;
};
constexpr Additions additions[] = {
    {"global_automatic_klu",
     "/guess:linear /guess:quadratic /guess:hermite3 /guess:hermite5 /guess:adams8 /jacobian:step "
     "/btf:off /stride:2 /stride:4 /stride:16 /stride:64 "
     "/iterations:1 /iterations:2 /iterations:3 /tolerance:1e-6 /tolerance:1e-9 /tolerance:1e-15 "
     "/threads:2 /guess:hermite5/stride:4 /guess:hermite5/iterations:1 "
     "/guess:hermite5/jacobian:step /guess:adams8/jacobian:step"},
    {"global_automatic_lapack",
     "/jacobian:step /guess:hermite5 /guess:hermite5/jacobian:step /tolerance:1e-6"},
    {"group_automatic_eigen",
     "/jacobian:step /guess:hermite5/jacobian:step /stride:8 /iterations:1 /iterations:2"},
    {"block_symbolic_inlined",
     "/guess:hermite5 /guess:linear /guess:adams8 /stride:2 /stride:8 /stride:32 /iterations:1 "
     "/iterations:2 /tolerance:1e-15 /tolerance:1e-8 /threads:2"},
    {"group_symbolic_explicit",
     "/guess:hermite5 /guess:adams8 /stride:4 /segments:4 /lanes:4 /iterations:1 "
     "/tolerance:1e-15"},
    {"block_symbolic_explicit", "/guess:linear /guess:adams8 /segments:4 /stride:16 /iterations:2"},
};

}  // namespace

std::vector<std::string> drawn_ids() {
  std::vector<std::string> ids;
  for (const Variant& v : variants()) ids.push_back(v.id);
  for (const auto& [id, suffixes] : additions) {
    std::istringstream all(suffixes);
    for (std::string suffix; all >> suffix;) ids.push_back(id + suffix);
  }
  return ids;
}

}  // namespace desmo::properties
