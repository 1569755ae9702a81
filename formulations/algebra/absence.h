#pragma once

#include <string>

namespace desmo {

/// Reason why a library that is loaded at run time is absent.
struct Absence {
  std::string reason;   ///< text for unsupported_reason; empty: it is present
  bool faulty = false;  ///< a library was found or named, but cannot be used
};

}  // namespace desmo
