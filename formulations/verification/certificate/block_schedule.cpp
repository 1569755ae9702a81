#include "formulations/verification/certificate/block_schedule.h"

#include <algorithm>
#include <map>
#include <utility>

#include "formulations/model/characteristic_lengths.h"

namespace desmo {

namespace {

/// Largest number of groups of a chain that is not long.
constexpr int max_boxed_chain = 8;
constexpr int level_count = static_cast<int>(all_levels.size());

class ScheduleBuilder {
 public:
  ScheduleBuilder(const Model& m, std::span<const Level> up_to)
      : m_(m),
        up_to_(up_to),
        magnitudes_(CharacteristicLengths(m).of_coordinates()),
        group_(m.coordinates(), -1),
        row_(m.coordinates(), -1),
        depth_(m.coordinates(), 0) {}

  BlockSchedule build() {
    const std::vector<PartDefinition> definitions = make_partition(m_, Partition::group);
    find_chains(definitions);
    for (std::size_t g = 0; g < definitions.size(); ++g)
      is_link_[g] ? add_link(definitions[g], static_cast<int>(g)) : add_group(definitions[g]);
    for (auto& [depth, of_depth] : depths_) {
      std::ranges::move(of_depth.links, std::back_inserter(result_.steps));
      if (!of_depth.blocks.empty()) result_.steps.push_back(batched(of_depth.blocks));
    }
    for (const CertificationStep& step : result_.steps)
      for (const BlockBatch& batch : step.batches) {
        const BlockShape& shape = batch.equations.shape();
        BatchSizes& largest = result_.largest;
        largest.unknowns = std::max(largest.unknowns, shape.unknowns);
        largest.width = std::max(largest.width, shape.width());
        largest.states = std::max(largest.states, shape.states());
      }
    return std::move(result_);
  }

 private:
  /// Links and other blocks whose inputs all have lower depths. They can be certified once all
  /// lower depths are.
  struct Depth {
    std::vector<CertificationStep> links;
    std::vector<BlockBatch::PlacedBlock> blocks;
  };

  /// Finds the inputs of each group, how long the longest chain through it is, and which are links.
  void find_chains(const std::vector<PartDefinition>& definitions) {
    const std::size_t size = definitions.size();
    inputs_.resize(size);
    is_link_.resize(size);
    std::vector<int> depth(size, 1), height(size, 1);
    for (std::size_t g = 0; g < size; ++g) {
      const ShapedBlock whole = shaped_block(m_, definitions[g]);
      for (const int i : whole.inputs()) inputs_[g][group_[i]].push_back(i);
      for (auto& [from, coordinates] : inputs_[g]) {
        std::ranges::sort(coordinates);
        if (from >= 0) depth[g] = std::max(depth[g], depth[from] + 1);
      }
      for (const int i : definitions[g].unknowns) group_[i] = static_cast<int>(g);
    }
    for (std::size_t g = size; g-- > 0;)
      for (const auto& [from, coordinates] : inputs_[g])
        if (from >= 0) height[from] = std::max(height[from], height[g] + 1);
    for (std::size_t g = 0; g < size; ++g) chain_.push_back(depth[g] + height[g] - 1);
    for (std::size_t g = 0; g < size; ++g)
      for (const auto& [from, coordinates] : inputs_[g])
        if (is_long(from)) is_link_[g] = is_link_[from] = true;
  }
  bool is_long(int group) const { return group >= 0 && chain_[group] > max_boxed_chain; }

  /// Returns a block with the rows of its columns in ErrorTable. row: row of each coordinate;
  /// empty: coordinate i has row i.
  BlockBatch::PlacedBlock placed(const PartDefinition& part, const std::vector<int>& row) {
    BlockBatch::PlacedBlock made{
        shaped_block(m_, part), part.groups.front(), order_++, Level::acceleration, {}};
    for (const int i : made.block.coordinates) made.rows.push_back(row.empty() ? i : row[i]);
    if (!up_to_.empty()) {
      made.solved = Level::position;
      for (const int i : part.unknowns) made.solved = std::max(made.solved, up_to_[i]);
    }
    return made;
  }
  int depth_of(std::span<const int> inputs) const {
    int depth = 0;
    for (const int i : inputs) depth = std::max(depth, depth_[i]);
    return depth + 1;
  }

  void add_group(const PartDefinition& definition) {
    for (const PartDefinition& part : irreducible_blocks(m_, definition)) {
      BlockBatch::PlacedBlock made = placed(part, {});
      const int depth = depth_of(made.block.inputs());
      for (const int i : part.unknowns) depth_[i] = depth;
      depths_[depth].blocks.push_back(std::move(made));
    }
  }

  /// Returns a step of batches, each of up to LaneNumbers::count equal blocks.
  CertificationStep batched(const std::vector<BlockBatch::PlacedBlock>& blocks) const {
    std::vector<std::vector<BlockBatch::PlacedBlock>> batches;
    for (const BlockBatch::PlacedBlock& made : blocks) {
      const auto equal = std::ranges::find_if(batches, [&](const auto& batch) {
        return batch.size() < LaneNumbers::count && batch.front().block.shape == made.block.shape &&
               batch.front().block.constants.size() == made.block.constants.size();
      });
      if (equal == batches.end())
        batches.push_back({made});
      else
        equal->push_back(made);
    }
    CertificationStep step;
    for (const auto& batch : batches) step.batches.emplace_back(batch, magnitudes_, 0);
    return step;
  }

  void add_link(const PartDefinition& definition, int group) {
    ChainLink link;
    int rows = 0, depth = 0;
    std::vector<int> row = row_;  // row of each coordinate while this group is certified
    const int lent = m_.state_size();
    for (const auto& [from, coordinates] : inputs_[group]) {
      const int size = static_cast<int>(coordinates.size());
      depth = std::max(depth, depth_of(coordinates));
      if (is_long(from)) {
        link.sources.push_back({interface(from, coordinates), lent + rows, link.symbols});
        link.symbols += size;
        for (const int i : coordinates) row[i] = lent + rows++;
      } else {
        for (const int i : coordinates) row[i] = i;
      }
    }
    for (const int i : definition.unknowns) {
      row[i] = row_[i] = lent + rows++;
      depth_[i] = depth;
    }
    const int columns = level_count * link.symbols;
    CertificationStep step{{}, static_cast<int>(result_.links.size())};
    for (const PartDefinition& part : irreducible_blocks(m_, definition)) {
      const BlockBatch::PlacedBlock made = placed(part, row);
      step.batches.emplace_back(std::span(&made, 1), magnitudes_, columns);
    }
    depths_[depth].links.push_back(std::move(step));
    result_.lent_rows = std::max(result_.lent_rows, rows);
    result_.largest.columns = std::max(result_.largest.columns, columns);
    result_.max_generators = std::max(result_.max_generators, rows * columns);
    link_of_[group] = static_cast<int>(result_.links.size());
    result_.links.push_back(std::move(link));
  }

  /// Returns the interface of these coordinates of a group; makes it if it is new.
  int interface(int group, const std::vector<int>& coordinates) {
    ChainLink& from = result_.links[link_of_[group]];
    for (const int i : from.interfaces)
      if (result_.interfaces[i].coordinates == coordinates) return i;
    const int index = static_cast<int>(result_.interfaces.size());
    from.interfaces.push_back(index);
    const int size = static_cast<int>(coordinates.size());
    GroupInterface made{coordinates, {}, {level_count * size, level_count * from.symbols}, {}};
    for (const int i : coordinates) made.rows.push_back(row_[i]);
    for (const Level level : all_levels) made.centre[level].resize(size);
    result_.interfaces.push_back(std::move(made));
    return index;
  }

  const Model& m_;
  std::span<const Level> up_to_;
  const std::vector<double> magnitudes_;
  // Inputs of each group, by the group that solves them; -1: they are driven.
  std::vector<std::map<int, std::vector<int>>> inputs_;
  std::vector<int> chain_;     // groups in the longest chain through each
  std::vector<bool> is_link_;  // groups that get a ChainLink
  std::map<int, int> link_of_;
  std::vector<int> group_;  // group that solves each coordinate; -1: it is driven
  std::vector<int> row_;    // row of each coordinate in its link; -1: it is in none
  std::vector<int> depth_;  // depth of each coordinate; 0: it is driven
  int order_ = 0;
  std::map<int, Depth> depths_;
  BlockSchedule result_;
};

}  // namespace

BlockSchedule block_schedule(const Model& model, std::span<const Level> levels) {
  return ScheduleBuilder(model, levels).build();
}

}  // namespace desmo
