#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace desmo {

/// Lanes are brought together and apart so many at a time: what registers of 256 bits hold.
inline constexpr int quad = 4;

/// to[l][n] = number which[n] of lane l; as many lanes as there are arrays, a multiple of four.
void unpack(const double* from, std::span<const int> which, std::span<double* const> to);

/// By lane, where each of the numbers that it holds stands in an array; negative: nowhere.
using LanePlaces = std::vector<std::vector<int>>;

/// Numbers of an array that lanes hold side by side, one in each.
class LaneSources {
 public:
  LaneSources() = default;
  /// which: numbers, ascending, that have a place for every lane.
  LaneSources(std::span<const int> which, const LanePlaces& places);

  /// Number n of each lane, from its place, for those n.
  void gather(const double* from, double* to) const;

 private:
  /// Numbers whose places follow each other in every lane of a quad: the components of an entity,
  /// or the entities of a copy.
  struct Run {
    int first, size;
    std::array<int, quad> place;  // of the first
  };
  // Compiled for each number of lanes: it is in every address.
  template <std::size_t lanes>
  void gather_lanes(const double* from, double* to) const;

  std::vector<std::vector<Run>> quads_;
};

/// The other way.
class LaneTargets {
 public:
  LaneTargets() = default;
  /// which: numbers, ascending; of lanes from `used` on none goes anywhere.
  LaneTargets(std::span<const int> which, const LanePlaces& places, std::size_t used);

  /// Those numbers of each lane to where they have a place.
  void scatter(const double* from, double* to) const;

 private:
  template <std::size_t lanes>
  void scatter_lanes(const double* from, double* to) const;

  struct QuadRun {
    int from, size;  // of the first lane and the first number
    std::array<int, quad> place;
  };
  /// Of one lane, beside which not all of its quad have a place.
  struct LaneRun {
    int from, size, place;
  };
  std::vector<QuadRun> quads_;
  std::vector<LaneRun> singles_;
  std::size_t lanes_ = quad;
};

}  // namespace desmo
