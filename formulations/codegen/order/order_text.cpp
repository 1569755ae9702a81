#include <set>
#include <string_view>

#include "formulations/codegen/order/explicit_order.h"

namespace desmo::generate {

namespace {

/// Each once.
std::string list(const std::vector<std::string>& names) {
  std::string result;
  std::set<std::string_view> seen;
  for (const std::string& name : names)
    if (seen.insert(name).second) result += (result.empty() ? "" : "; ") + name;
  return result;
}

}  // namespace

std::string names_of(const PartType& type, const std::vector<int>& inputs) {
  std::string result;
  for (const int i : inputs) result += (result.empty() ? "" : ", ") + type.inputs[i].name;
  return result;
}

std::string describe(const PartType& type, const std::vector<OrderSection>& order) {
  std::string text;
  for (const OrderSection& s : order) {
    if (!s.torn.empty())
      text += "  core of " + std::to_string(s.torn.size()) + ": " + names_of(type, s.torn) + "\n";
    for (const Definition& d : s.definitions)
      text += std::string(s.torn.empty() ? "  " : "    ") + names_of(type, d.unknowns) + ": " +
              d.form.rule + " (" + list(d.because) + ")\n";
    if (!s.torn.empty()) text += "    left to Newton: " + list(s.residual_names) + "\n";
  }
  return text;
}

}  // namespace desmo::generate
