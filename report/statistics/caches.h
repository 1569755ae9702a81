// The caches of a machine, as its record names them.
#pragma once

#include <string>
#include <vector>

#include "report/read/record.h"

namespace desmo::report {

struct Cache {
  std::string name;  ///< "L2"
  double bytes = 0;
};

/// Those that hold data, smallest first: of "L2 Unified 1024 KiB, shared by 1" and the like, what
/// does not read so is left out.
std::vector<Cache> data_caches(const Machine& machine);

/// "in L1", …, "beyond L3": the smallest cache that holds so many bytes; empty when no cache is
/// known.
std::string held_by(const std::vector<Cache>& caches, double bytes);

/// What held_by says, from small to large.
std::vector<std::string> holders(const std::vector<Cache>& caches);

}  // namespace desmo::report
