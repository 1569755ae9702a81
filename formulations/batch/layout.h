#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace desmo {

/// Lanes of a register of 512 bits.
inline constexpr int wide = 8;

/// Numbers in lanes, and the array that they are scattered to.
struct LaneCopy {
  const double* from;  ///< begins a cache line
  double* to;
};

/// Writes to[l][k] = from[offsets[k] + l] for eight lanes. from: begins a cache line; offsets:
/// multiples of eight. Only where has_lanes(wide).
void unpack_wide(const double* from, std::span<const int> offsets, std::span<double* const> to);
/// Does so for several arrays, and for one to eight lanes, as many as there are places: lane l is
/// written from to[places[l]] on.
void unpack_wide(std::span<const LaneCopy> copies, std::span<const int> offsets,
                 std::span<const int> places);

/// Lanes that are gathered and scattered at a time, wherever wider registers gain nothing: those of
/// a register of 256 bits.
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
  /// which: numbers, ascending, that have a place for every lane.
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
    std::array<int, quad> place;  // of the first
  };
  // Compiled for each number of lanes: it is in every address.
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
    std::size_t first;              // in offsets_
    std::array<int, lanes> places;  // of the first number
  };
  template <std::size_t lanes>
  void add(std::vector<int> numbers, const LanePlaces& places, std::size_t first_lane,
           std::vector<Range<lanes>>& ranges);

  void scatter_range(const Range<quad>& range, const double* from, double* to) const;
  void scatter_range(const Range<1>& range, const double* from, double* to) const;

  std::vector<Range<wide>> wides_;  // ranges of all used lanes, where registers hold them
  std::vector<Range<quad>> quads_;
  std::vector<Range<1>> singles_;  // numbers that not all of these lanes have
  std::vector<int> offsets_;       // of numbers in the first lane of their range
  std::size_t lanes_ = 0, used_ = 0;
};

}  // namespace desmo
