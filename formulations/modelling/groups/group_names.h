#pragma once

#include <map>
#include <string>
#include <vector>

namespace desmo {

/// A generator of the paper's group names: SG-I, SG-II, …. The common prefix of the bodies' names,
/// up to a "/", precedes the name: "axle1/SG-I".
class GroupNames {
 public:
  /// Returns the next name for a group with these bodies (at least one).
  std::string next(const std::vector<std::string>& bodies);

 private:
  std::map<std::string, int> numbers_;  // by prefix
};

}  // namespace desmo
