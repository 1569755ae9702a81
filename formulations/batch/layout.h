#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace desmo {

/// Number of lanes in a register of 512 bits.
inline constexpr int wide = 8;

/// Numbers in lanes, and the array that they are scattered to.
struct LaneCopy {
  const double* from;  ///< begins a cache line
  double* to;
};

/// Writes to[l][k] = from[offsets[k] + l] for eight lanes. from: begins a cache line; offsets:
/// multiples of eight. Call it only where has_lanes(wide) is true.
void unpack_wide(const double* from, std::span<const int> offsets, std::span<double* const> to);
/// Does the same for several arrays and for one to eight lanes, one for each place. Lane l is
/// written from to[places[l]] on.
void unpack_wide(std::span<const LaneCopy> copies, std::span<const int> offsets,
                 std::span<const int> places);

/// Number of lanes in a register of 256 bits. So many are gathered or scattered at a time where
/// wider registers gain nothing.
inline constexpr int quad = 4;

/// Writes to[l][n] = from[offsets[n] + l] for as many lanes as there are arrays, four or eight.
/// from: begins a cache line; offsets: where numbers begin, multiples of the lanes.
void unpack(const double* from, std::span<const int> offsets, std::span<double* const> to);

/// For each lane the place of each of its numbers in an array; negative: none.
using LanePlaces = std::vector<std::vector<int>>;

/// A table by which numbers are gathered from an array to lanes side by side.
class Gather {
 public:
  Gather() = default;
  /// which: numbers, ascending, that have a place in every lane.
  Gather(std::span<const int> which, const LanePlaces& places);

  bool empty() const { return quads_.empty() || quads_.front().empty(); }

  /// Reads these numbers of each lane from their places, in several arrays at once.
  template <std::size_t arrays>
  void gather(const std::array<const double*, arrays>& from,
              const std::array<double*, arrays>& to) const;

 private:
  /// Numbers whose places follow each other in every lane of a quad: the components of an entity,
  /// or the entities of a subsystem.
  struct Range {
    int first, size;
    std::array<int, quad> place;  // place of the first number in each lane
  };
  // Compiled for each number of lanes, which every address depends on.
  template <std::size_t lanes, std::size_t arrays>
  void gather_lanes(const std::array<const double*, arrays>& from,
                    std::array<double*, arrays> to) const;

  std::vector<std::vector<Range>> quads_;
};

/// A table by which numbers are scattered from lanes to places in an array, range by range.
class Scatter {
 public:
  Scatter() = default;
  /// which: numbers. Lanes from `used` on are left out.
  Scatter(std::span<const int> which, const LanePlaces& places, std::size_t used);

  /// Writes these numbers of each lane to their places, in several arrays at once.
  void scatter(std::span<const LaneCopy> copies) const;

 private:
  /// Numbers whose places follow each other in each of these lanes.
  template <std::size_t lanes>
  struct Range {
    int size;
    std::size_t first;              // position of its first number in offsets_
    std::array<int, lanes> places;  // place of the first number in each lane
  };
  template <std::size_t lanes>
  void add(std::vector<int> numbers, const LanePlaces& places, std::size_t first_lane,
           std::vector<Range<lanes>>& ranges);

  void scatter_range(const Range<quad>& range, const double* from, double* to) const;
  void scatter_range(const Range<1>& range, const double* from, double* to) const;

  std::vector<Range<wide>> wides_;  // ranges of all used lanes, where a register holds them
  std::vector<Range<quad>> quads_;  // ranges of four lanes
  std::vector<Range<1>> singles_;   // ranges of one lane: numbers that other lanes lack
  std::vector<int> offsets_;        // where each number begins, in the first lane of its range
  std::size_t lanes_ = 0, used_ = 0;
};

}  // namespace desmo
