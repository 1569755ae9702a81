#include "report/statistics/families.h"

#include <string_view>

namespace desmo::report {
namespace {

std::string cut(std::string_view formulation) {
  if (formulation.starts_with("global_")) return "global";
  if (formulation.starts_with("group_")) return "groups";
  if (formulation.starts_with("block_")) return "blocks";
  return "other";
}

std::string algebra(std::string_view formulation) {
  const std::string_view name = formulation.substr(formulation.rfind('_') + 1);
  if (name == "lapack" || name == "eigen") return "dense";
  if (name == "inlined" || name == "explicit") return "generated";
  return "sparse";
}

}  // namespace

std::string family_of(const Configuration& configuration) {
  if (!configuration.solves_every_instant()) return "interpolated";
  return cut(configuration.formulation) + ", " + algebra(configuration.formulation);
}

}  // namespace desmo::report
