#include "formulations/verification/certificate/certified_groups.h"

#include <algorithm>
#include <map>
#include <utility>

#include "formulations/scaling/characteristic_lengths.h"

namespace desmo {

namespace {

/// Number of groups in a chain, above which errors are handed on in bases.
constexpr int max_boxed_chain = 8;
constexpr int level_count = static_cast<int>(levels.size());

class Builder {
 public:
  explicit Builder(const Model& m)
      : m_(m),
        magnitudes_(CharacteristicLengths(m).of_coordinates()),
        group_(m.coordinates(), -1),
        row_(m.coordinates(), -1) {}

  CertifiedGroups build() {
    const std::vector<PartDefinition> definitions = make_partition(m_, Partition::group);
    find_chains(definitions);
    for (const PartDefinition& definition : definitions) add(definition);
    return std::move(result_);
  }

 private:
  /// Finds what each group reads, and how long the longest chain through it is.
  void find_chains(const std::vector<PartDefinition>& definitions) {
    const std::size_t size = definitions.size();
    reads_.resize(size);
    std::vector<int> depth(size, 1), height(size, 1);
    for (std::size_t g = 0; g < size; ++g) {
      const IntervalBlock equations(m_, definitions[g]);
      for (const int i : equations.inputs()) reads_[g][group_[i]].push_back(i);
      for (const auto& [from, coordinates] : reads_[g])
        if (from >= 0) depth[g] = std::max(depth[g], depth[from] + 1);
      for (const int i : definitions[g].unknowns) group_[i] = static_cast<int>(g);
    }
    for (std::size_t g = size; g-- > 0;)
      for (const auto& [from, coordinates] : reads_[g])
        if (from >= 0) height[from] = std::max(height[from], height[g] + 1);
    for (std::size_t g = 0; g < size; ++g) chain_.push_back(depth[g] + height[g] - 1);
  }

  void add(const PartDefinition& definition) {
    CertifiedGroup group{definition.groups.front(), {}, {}, {}};
    int rows = 0;
    std::vector<int> row = row_;  // of inputs, in this group
    for (const auto& [from, coordinates] : reads_[result_.groups.size()]) {
      const int size = static_cast<int>(coordinates.size());
      if (from >= 0 && chain_[from] > max_boxed_chain) {
        group.sources.push_back({interface(from, coordinates), -1, rows, group.symbols});
        group.symbols += size;
      } else {
        for (int k = 0; k < size; ++k) group.sources.push_back({-1, coordinates[k], rows + k, 0});
      }
      for (const int i : coordinates) row[i] = rows++;
    }
    const int columns = level_count * group.symbols;
    for (const PartDefinition& part : irreducible_blocks(m_, definition)) {
      IntervalBlock equations(m_, part);
      std::vector<int> block_rows;
      std::vector<double> magnitudes;
      for (const int i : equations.unknowns()) {
        block_rows.push_back(row[i] = row_[i] = rows++);
        magnitudes.push_back(magnitudes_[i]);
      }
      for (const int i : equations.inputs()) block_rows.push_back(row[i]);
      group.blocks.emplace_back(std::move(equations), std::move(block_rows), columns,
                                std::move(magnitudes));
    }
    result_.max_rows = std::max(result_.max_rows, rows);
    result_.max_generators = std::max(result_.max_generators, rows * columns);
    result_.groups.push_back(std::move(group));
  }

  /// Returns the interface of these coordinates of a group.
  int interface(int group, const std::vector<int>& coordinates) {
    CertifiedGroup& from = result_.groups[group];
    for (const int i : from.interfaces)
      if (result_.interfaces[i].coordinates == coordinates) return i;
    const int index = static_cast<int>(result_.interfaces.size());
    from.interfaces.push_back(index);
    const int size = static_cast<int>(coordinates.size());
    GroupInterface made{coordinates, {}, {level_count * size, level_count * from.symbols}, {}};
    for (const int i : coordinates) made.rows.push_back(row_[i]);
    for (const Level level : levels) made.center[level].resize(size);
    result_.interfaces.push_back(std::move(made));
    return index;
  }

  const Model& m_;
  const std::vector<double> magnitudes_;
  std::vector<std::map<int, std::vector<int>>> reads_;  // coordinates by group; -1: driven
  std::vector<int> chain_;                              // length of the longest through each group
  std::vector<int> group_, row_;                        // of each coordinate; -1: driven
  CertifiedGroups result_;
};

}  // namespace

CertifiedGroups certified_groups(const Model& model) { return Builder(model).build(); }

}  // namespace desmo
