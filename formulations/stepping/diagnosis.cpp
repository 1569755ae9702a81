#include "formulations/stepping/diagnosis.h"

#include <vector>

#include "formulations/stepping/dense_group.h"
#include "formulations/structure/partition.h"

namespace desmo {

Culprit find_culprit(const Model& m, std::span<const GroupId> groups, std::vector<double> state,
                     const Settings& settings) {
  const Magnitudes magnitudes(m);
  std::vector<bool> suspected(m.groups.size(), false);
  for (const GroupId g : groups) suspected[g] = true;
  for (const PartDefinition& group : make_partition(m, Partition::group)) {
    const GroupId g = group.groups.front();
    if (!suspected[g]) continue;
    const int row = DenseGroup(m, group, magnitudes).solve(state, settings);
    if (row >= 0) return {g, group.equations[row].constraint};
  }
  return {};
}

}  // namespace desmo
