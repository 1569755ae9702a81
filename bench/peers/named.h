#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace desmo {

/// The point, vector, body … of that name. Throws std::invalid_argument when there is none.
template <class Named>
const Named& named(const std::vector<Named>& all, const std::string& name) {
  const auto it = std::ranges::find(all, name, &Named::name);
  if (it == all.end()) throw std::invalid_argument("there is no '" + name + "'");
  return *it;
}

}  // namespace desmo
