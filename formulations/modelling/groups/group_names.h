#pragma once

#include <map>
#include <string>
#include <vector>

namespace desmo {

/// Names groups as the paper does, SG-I, SG-II, …, after what the names of their bodies have in
/// common up to a "/": "axle1/SG-I".
class GroupNames {
 public:
  /// bodies: at least one.
  std::string next(const std::vector<std::string>& bodies);

 private:
  std::map<std::string, int> numbers_;  // by prefix
};

}  // namespace desmo
