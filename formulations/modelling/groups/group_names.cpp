#include "formulations/modelling/groups/group_names.h"

#include <algorithm>
#include <utility>

namespace desmo {

namespace {

/// I, II, III, IV, …
std::string roman(int n) {
  if (n >= 4000) return std::to_string(n);
  static constexpr std::pair<int, const char*> digits[] = {
      {1000, "M"}, {900, "CM"}, {500, "D"}, {400, "CD"}, {100, "C"}, {90, "XC"}, {50, "L"},
      {40, "XL"},  {10, "X"},   {9, "IX"},  {5, "V"},    {4, "IV"},  {1, "I"}};
  std::string text;
  for (const auto& [value, digit] : digits)
    for (; n >= value; n -= value) text += digit;
  return text;
}

/// What the names of the bodies have in common up to a "/": "axle1/".
std::string common_prefix(const std::vector<std::string>& names) {
  std::string prefix = names.front();
  for (const std::string& name : names)
    prefix.resize(std::ranges::mismatch(prefix, name).in1 - prefix.begin());
  const std::size_t slash = prefix.rfind('/');
  return slash == std::string::npos ? "" : prefix.substr(0, slash + 1);
}

}  // namespace

std::string GroupNames::next(const std::vector<std::string>& bodies) {
  const std::string prefix = common_prefix(bodies);
  return prefix + "SG-" + roman(++numbers_[prefix]);
}

}  // namespace desmo
