#pragma once

#include <string>

namespace desmo {

/// Why a library that is looked for when the program runs is not there.
struct Absence {
  std::string reason;   ///< as unsupported_reason says it; empty: it is there
  bool faulty = false;  ///< something is there, or was named, that does not serve
};

}  // namespace desmo
