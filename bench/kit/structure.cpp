#include "bench/kit/structure.h"

#include <array>
#include <functional>
#include <map>
#include <utility>

#include "formulations/modelling/modelling.h"

namespace desmo::bench {

namespace {

constexpr std::array<std::pair<Partition, std::string_view>, 3> partitions{
    {{Partition::global, "global"}, {Partition::group, "group"}, {Partition::block, "block"}}};

}  // namespace

std::vector<PartSizes> part_sizes(const Model& m, Partition partition) {
  std::map<int, int, std::greater<>> counts;
  for (const PartDefinition& part : make_partition(m, partition))
    if (!part.constant) ++counts[static_cast<int>(part.unknowns.size())];
  std::vector<PartSizes> sizes;
  for (const auto& [unknowns, count] : counts) sizes.push_back({unknowns, count});
  return sizes;
}

int moving_unknowns(const Model& m) {
  int unknowns = 0;
  for (const PartSizes& parts : part_sizes(m, Partition::group))
    unknowns += parts.unknowns * parts.count;
  return unknowns;
}

std::vector<Structure> structures(const Case& definition, int coordinates) {
  const Model m = make_model(describe(definition, coordinates));
  std::vector<Structure> result;
  for (const auto& [partition, name] : partitions)
    result.push_back({&definition, coordinates, name, part_sizes(m, partition)});
  return result;
}

}  // namespace desmo::bench
