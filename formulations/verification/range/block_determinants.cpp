#include "formulations/verification/range/block_determinants.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/part_system.h"
#include "formulations/motion/groupwise/dense_lu.h"

namespace desmo {

std::vector<int> Determinants::changed(const Determinants& other) const {
  std::vector<int> blocks;
  for (std::size_t b = 0; b < std::min(signs.size(), other.signs.size()); ++b)
    if (signs[b] != other.signs[b]) blocks.push_back(static_cast<int>(b));
  return blocks;
}

BlockDeterminants::BlockDeterminants(const Model& m)
    : m_(m), blocks_(make_partition(m, Partition::block)) {
  const std::vector<double> lengths = CharacteristicLengths(m).of_coordinates();
  for (const PartDefinition& block : blocks_) {
    double log = 0;
    for (const int i : block.unknowns) log += std::log(lengths[i]);
    unit_.push_back(log);
  }
}

Determinants BlockDeterminants::at(std::span<const double> state) const {
  ScalarState<double> wide(m_.state_size());
  std::ranges::copy(state, wide.q.begin());
  Determinants all;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    PartSystem<double> system(m_, blocks_[b], wide);
    const auto determinant = DenseLu(std::move(system.jacobian), system.n).determinant();
    all.logs.push_back(determinant.log + unit_[b]);
    all.signs.push_back(static_cast<signed char>(determinant.sign));
    if (!std::isfinite(all.logs.back())) return {};
  }
  return all;
}

}  // namespace desmo
