#include "bench/experiments/extremes/applicability.h"

namespace desmo::extremes {

namespace {

constexpr int max_dense = 400;         // unknowns: a step costs O(n³)
constexpr int largest_any = 5'000;     // for all but the fastest formulations
constexpr long longest_any = 100'000;  // instants, likewise
/// Coordinates: every part keeps a workspace of some kilobytes, and blocks are more than groups.
constexpr int largest_in_blocks = 1'000'000;

/// The formulations that do without a library's work on every small part.
bool is_fast(const Variant& v) {
  return !v.backend || (v.partition == Partition::global && algebra_name(v) == "klu");
}

}  // namespace

std::string why_not_tried(const Configuration& configuration, const Problem& problem) {
  const Variant& v = *configuration.variant;
  if (std::string why = unsupported_reason(v, configuration.settings); !why.empty()) return why;
  const int coordinates = problem.modelled->model.coordinates();
  if (is_dense_global(v) && coordinates > max_dense)
    return "dense matrices of all unknowns: a step costs O(n³)";
  if (v.partition == Partition::block && coordinates > largest_in_blocks)
    return "workspaces of so many blocks take too much memory";
  if (is_fast(v)) return {};
  if (coordinates > largest_any) return "it takes too long with so many coordinates";
  if (algebra_name(v) != "eigen" && static_cast<long>(problem.solvable.size()) > longest_any)
    return "it takes too long with so many instants";
  return {};
}

std::string lacks_generated_code(const Formulation& formulation) {
  for (const DefinedPart& part : formulation.parts())
    if (!part.as_named) return "there is no generated code for groups of this type";
  return {};
}

}  // namespace desmo::extremes
