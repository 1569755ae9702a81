#include "formulations/verification/certificate/block_batch.h"

namespace desmo {

namespace {

std::vector<const ShapedBlock*> lanes_of(const BlockBatch& batch) {
  std::vector<const ShapedBlock*> all;
  for (int lane = 0; lane < LaneNumbers::count; ++lane) all.push_back(&batch.in_lane(lane).block);
  return all;
}

}  // namespace

BlockBatch::BlockBatch(std::span<const PlacedBlock> of_lanes,
                       const std::vector<double>& all_magnitudes, int columns)
    : blocks(of_lanes.begin(), of_lanes.end()), equations(lanes_of(*this)) {
  const BlockShape& shape = equations.shape();
  const int n = shape.unknowns, w = shape.width();
  rounding = 32 * (w + columns) * Interval::unit;
  for (int i = 0; i < shape.states(); ++i)
    if (shape.columns[i] < n && shape.columns[i] != BlockShape::unread) plain.push_back(i);
  locals.resize(w);
  for (int i = 0; i < shape.states(); ++i)
    if (shape.columns[i] >= 0) locals[shape.columns[i]] = i;
  magnitudes.resize(w);
  initial.resize(blocks.front().block.initial.size());
  for (int lane = 0; lane < LaneNumbers::count; ++lane) {
    const PlacedBlock& placed = in_lane(lane);
    const auto place = [&](std::vector<int>& to, const std::vector<int>& from) {
      to.resize(LaneNumbers::count * from.size());
      for (std::size_t k = 0; k < from.size(); ++k) to[LaneNumbers::count * k + lane] = from[k];
    };
    std::vector<int> plain_states;
    for (const int i : plain) plain_states.push_back(placed.block.states[i]);
    place(states, plain_states);
    place(coordinates, placed.block.coordinates);
    place(rows, placed.rows);
    for (int i = 0; i < w; ++i)
      magnitudes[i].set(lane, all_magnitudes[placed.block.coordinates[i]]);
    for (std::size_t r = 0; r < initial.size(); ++r) initial[r].set(lane, placed.block.initial[r]);
  }
  jacobian.resize(static_cast<int>(shape.entries.size()));
  equations.linear().jacobian(jacobian);
  if (shape.linear) {
    constant.resize(n, shape.inputs);
    constant.find(shape, jacobian.mid.data(), LaneMask::all());
    condition = constant.condition(shape, jacobian.mid.data(), magnitudes.data());
  }
}

}  // namespace desmo
