#pragma once

#include <string>
#include <vector>

namespace desmo::bench {

/// SHA-256 of the running program's file; "unknown" where it cannot be read.
std::string binary_digest();

/// How the running program was linked.
struct Link {
  std::string type;                    ///< "dynamic", or "static": no other file was loaded
  std::string flags;                   ///< the build's, for every program
  std::vector<std::string> libraries;  ///< names of the shared objects loaded, sorted
};
Link this_link();

}  // namespace desmo::bench
