#pragma once

#include <span>

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

}  // namespace desmo
