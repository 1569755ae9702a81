#pragma once

#include <string_view>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/model/model.h"
#include "formulations/structure/partition.h"

namespace desmo::bench {

/// So many parts with so many unknowns each.
struct PartSizes {
  int unknowns;
  int count;
  bool operator==(const PartSizes&) const = default;
};

/// How one partition cuts one case at one size.
struct Structure {
  const Case* definition;
  int coordinates;
  std::string_view partition;    ///< as in the ids: "global", "group", "block"
  std::vector<PartSizes> parts;  ///< largest first; constant parts are not counted
};

std::vector<PartSizes> part_sizes(const Model& model, Partition partition);

/// Coordinates that are to be found at every instant: neither driven nor at rest.
int moving_unknowns(const Model& model);

/// Every partition of one case at one size.
std::vector<Structure> structures(const Case& definition, int coordinates);

}  // namespace desmo::bench
