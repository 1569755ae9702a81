#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "formulations/batch/wide_lanes.h"

namespace desmo {

/// Lanes are brought together and apart so many at a time, what registers of 256 bits hold,
/// wherever wider ones gain nothing.
inline constexpr int quad = 4;

/// to[l][n] = from[offsets[n] + l]: numbers of as many lanes as there are arrays, four or eight.
/// from: begins a cache line; offsets: where numbers begin, multiples of that.
void unpack(const double* from, std::span<const int> offsets, std::span<double* const> to);

/// By lane, where each of the numbers that it holds stands in an array; negative: nowhere.
using LanePlaces = std::vector<std::vector<int>>;

/// Numbers of an array that lanes hold side by side, one in each.
class LaneSources {
 public:
  LaneSources() = default;
  /// which: numbers, ascending, that have a place for every lane.
  LaneSources(std::span<const int> which, const LanePlaces& places);

  bool empty() const { return quads_.empty() || quads_.front().empty(); }

  /// Number n of each lane, from its place, for those n: of several arrays at once.
  template <std::size_t arrays>
  void gather(const std::array<const double*, arrays>& from,
              const std::array<double*, arrays>& to) const;

 private:
  /// Numbers whose places follow each other in every lane of a quad: the components of an entity,
  /// or the entities of a copy.
  struct Run {
    int first, size;
    std::array<int, quad> place;  // of the first
  };
  // Compiled for each number of lanes: it is in every address.
  template <std::size_t lanes, std::size_t arrays>
  void gather_lanes(const std::array<const double*, arrays>& from,
                    std::array<double*, arrays> to) const;

  std::vector<std::vector<Run>> quads_;
};

/// The other way: numbers in lanes to places of their own, where those that follow each other in an
/// array are put together.
class LaneTargets {
 public:
  LaneTargets() = default;
  /// which: numbers; of lanes from `used` on none goes anywhere.
  LaneTargets(std::span<const int> which, const LanePlaces& places, std::size_t used);

  /// Those numbers of each lane to where they have a place: the same of several copies.
  void scatter(std::span<const LaneCopy> copies) const;

 private:
  /// Numbers whose places follow each other in so many lanes.
  template <std::size_t lanes>
  struct Run {
    int size;
    std::size_t first;              // in offsets_
    std::array<int, lanes> places;  // of the first number
  };
  template <std::size_t lanes>
  void add(std::vector<int> numbers, const LanePlaces& places, std::size_t first_lane,
           std::vector<Run<lanes>>& runs);

  void scatter_run(const Run<quad>& run, const double* from, double* to) const;
  void scatter_run(const Run<1>& run, const double* from, double* to) const;

  std::vector<Run<wide>> wides_;  // of all lanes used, where registers hold them
  std::vector<Run<quad>> quads_;
  std::vector<Run<1>> singles_;  // where not all of these lanes have a place for a number
  std::vector<int> offsets_;     // of numbers in the first lane of their run
  std::size_t lanes_ = 0, used_ = 0;
};

}  // namespace desmo
