#pragma once

#include <span>

namespace desmo {

/// How many lanes fill a register of 512 bits.
inline constexpr int wide = 8;

/// Numbers in lanes, and the array that they go to.
struct LaneCopy {
  const double* from;  ///< begins a cache line
  double* to;
};

/// to[l][k] = from[offsets[k] + l], of eight lanes. from: begins a cache line; offsets: multiples
/// of eight. To be called where has_lanes(wide) alone.
void unpack_wide(const double* from, std::span<const int> offsets, std::span<double* const> to);
/// The same of several copies, of one to eight lanes: as many as `places` has, lane l at
/// to[places[l]] and behind it.
void unpack_wide(std::span<const LaneCopy> copies, std::span<const int> offsets,
                 std::span<const int> places);

}  // namespace desmo
