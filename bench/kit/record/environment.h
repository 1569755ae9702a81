#pragma once

#include <string>
#include <vector>

namespace desmo::bench {

/// The machine, as far as it says; "unknown" where it does not.
struct Machine {
  std::string cpu;  ///< name, with family, model and stepping where they are told
  int cores;
  std::vector<std::string> caches;
  std::string kernel;
  std::string governor;
  std::string turbo;  ///< "on", "off": whether the clock may exceed its nominal frequency
};
Machine this_machine();

/// Load averages over 1, 5 and 15 minutes; empty when unknown.
std::vector<double> load_averages();

/// How this binary was built.
struct Build {
  std::string type, compiler, flags, commit;
  bool dirty;
};
Build this_build();

/// Now, UTC, ISO 8601 to the second.
std::string utc_now();

}  // namespace desmo::bench
