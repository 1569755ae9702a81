#pragma once

#include <array>
#include <span>
#include <vector>

#include "formulations/equations/lanes.h"

namespace desmo {

/// to[l][k] = lane l of from[k].
void unpack(std::span<const Lanes> from, const std::array<double*, lane_count>& to);
/// The same for these k alone.
void unpack(std::span<const Lanes> from, std::span<const int> which,
            const std::array<double*, lane_count>& to);

/// Where values that lanes hold side by side stand in a state, a part in each lane.
class LanePlaces {
 public:
  /// inputs: local inputs, ascending; in: by lane, the position of each local input in the state.
  LanePlaces(std::span<const int> inputs, const std::array<const int*, lane_count>& in);

  /// to[input] = the values of all lanes, for the inputs given.
  void gather(const double* state, Lanes* to) const;
  /// The other way; only lanes l of which bit l of `lanes` is set.
  void scatter(const Lanes* from, unsigned lanes, double* state) const;

 private:
  /// Inputs whose places follow each other in every lane: the components of an entity.
  struct Run {
    int first, size;
    std::array<int, lane_count> place;  // of the first
  };
  std::vector<Run> runs_;
};

}  // namespace desmo
