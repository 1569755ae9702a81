#include <initializer_list>

#include "bench/experiments/promise/tally.h"
#include "formulations/variants.h"

namespace desmo::promise {

using Suffixes = std::initializer_list<const char*>;

std::vector<std::string> canonical_ids() {
  std::vector<std::string> ids;
  for (const Variant& v : variants()) ids.push_back(v.id);
  const auto add = [&](const std::string& id, Suffixes suffixes) {
    for (const char* suffix : suffixes) ids.push_back(id + suffix);
  };
  add("global_automatic_klu", {"/guess:linear",
                               "/guess:quadratic",
                               "/guess:hermite3",
                               "/guess:hermite5",
                               "/guess:adams8",
                               "/jacobian:step",
                               "/jacobian:chord",
                               "/factorisation:per_level",
                               "/btf:off",
                               "/stride:2",
                               "/stride:4",
                               "/stride:16",
                               "/stride:64",
                               "/iterations:1",
                               "/iterations:2",
                               "/iterations:3",
                               "/tolerance:1e-6",
                               "/tolerance:1e-9",
                               "/tolerance:1e-15",
                               "/threads:2",
                               "/guess:hermite5/stride:4",
                               "/guess:hermite5/iterations:1"});
  add("global_automatic_lapack",
      {"/scalar:float/tolerance:1e-4", "/scalar:mixed", "/jacobian:step/scalar:mixed",
       "/jacobian:chord", "/guess:hermite5"});
  add("group_automatic_eigen", {"/scalar:float/tolerance:1e-3", "/scalar:mixed",
                                "/guess:hermite5/jacobian:chord", "/stride:8", "/iterations:1"});
  add("block_symbolic_inlined",
      {"/guess:hermite5", "/guess:linear", "/guess:adams8", "/stride:2", "/stride:8", "/stride:32",
       "/iterations:1", "/iterations:2", "/tolerance:1e-15", "/tolerance:1e-8", "/threads:2"});
  add("group_symbolic_explicit", {"/guess:hermite5", "/guess:adams8", "/stride:4", "/segments:4",
                                  "/lanes:4", "/iterations:1", "/tolerance:1e-15"});
  add("block_symbolic_explicit", {"/guess:linear", "/segments:4", "/stride:16", "/iterations:2"});
  return ids;
}

}  // namespace desmo::promise
