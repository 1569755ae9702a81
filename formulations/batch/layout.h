#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace desmo {

/// Number of lanes, each a double, in a register of 512 bits.
inline constexpr int wide = 8;

/// Source and target of a scatter: numbers in lanes, and the array that they go to.
struct LaneCopy {
  const double* from;  ///< begins a cache line
  double* to;
};

/// Writes to[l][k] = from[offsets[k] + l] for eight lanes. from: begins a cache line; offsets:
/// multiples of eight. Call it only where has_lanes(wide) is true.
void unpack_wide(const double* from, std::span<const int> offsets, std::span<double* const> to);
/// Does the same for each copy, but writes lane l from copy.to + places[l] on. places: one for each
/// lane to write, the first one to eight.
void unpack_wide(std::span<const LaneCopy> copies, std::span<const int> offsets,
                 std::span<const int> places);

/// Number of lanes in a register of 256 bits. Numbers are gathered into four lanes at a time even
/// in a batch of eight: wider registers gain nothing there.
inline constexpr int quad = 4;

/// Writes to[l][k] = from[offsets[k] + l] for each lane l. to: an array for each lane, four or
/// eight; from: begins a cache line; offsets: multiples of the number of lanes.
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

  /// Writes to[a][n * lanes + l] = from[a][places[l][n]] for each of these numbers n, each lane l
  /// and each array a.
  template <std::size_t arrays>
  void gather(const std::array<const double*, arrays>& from,
              const std::array<double*, arrays>& to) const;

 private:
  /// Numbers whose places follow each other in each of four lanes: the components of an entity, or
  /// the entities of a subsystem.
  struct Range {
    int first, size;
    std::array<int, quad> place;  // place of the first number in each lane
  };
  // A template, so that the number of lanes is a constant: every address depends on it.
  template <std::size_t lanes, std::size_t arrays>
  void gather_lanes(const std::array<const double*, arrays>& from,
                    std::array<double*, arrays> to) const;

  std::vector<std::vector<Range>> quads_;  // ranges of each four lanes
};

/// A table by which numbers are scattered from lanes to places in an array, range by range.
class Scatter {
 public:
  Scatter() = default;
  /// which: numbers. A number is not written for a lane in which its place is negative, nor for
  /// lanes from `used` on.
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

  // Eight lanes on registers that hold them are scattered together (wides_), others by fours
  // (quads_). Numbers that not all of these lanes have are scattered lane by lane (singles_). So
  // are all numbers of the last four lanes where some are not used.
  std::vector<Range<wide>> wides_;
  std::vector<Range<quad>> quads_;
  std::vector<Range<1>> singles_;
  std::vector<int> offsets_;  // of each number in `from`, at the first lane of its range
  std::size_t used_ = 0;
};

}  // namespace desmo
