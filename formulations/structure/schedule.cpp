#include "formulations/structure/schedule.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

#include "formulations/structure/part_type.h"

namespace desmo {

std::vector<int> gather_types(const Model& m, std::vector<PartDefinition>& parts) {
  // Depth: the longest chain of parts that must be solved before. Then first come, first served.
  std::vector<int> depth_of_coordinate(m.coordinates(), -1);
  std::map<std::string, int> number_of_type;
  std::vector<std::tuple<bool, int, int>> rank;
  for (const PartDefinition& part : parts) {
    const PartType type = describe_type(m, part);
    int depth = 0;
    for (const PartType::Input& input : type.inputs)
      if (input.role == Role::known) depth = std::max(depth, depth_of_coordinate[input.state] + 1);
    for (const int i : part.unknowns) depth_of_coordinate[i] = depth;
    const int number = static_cast<int>(number_of_type.size());
    rank.emplace_back(!part.constant, depth,
                      number_of_type.try_emplace(type.fingerprint, number).first->second);
  }
  std::vector<int> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return rank[i]; });
  std::vector<PartDefinition> sorted;
  std::vector<int> type_ends;
  for (std::size_t k = 0; k < order.size(); ++k) {
    sorted.push_back(std::move(parts[order[k]]));
    if (k + 1 == order.size() || rank[order[k]] != rank[order[k + 1]])
      type_ends.push_back(static_cast<int>(k) + 1);
  }
  parts = std::move(sorted);
  return type_ends;
}

}  // namespace desmo
