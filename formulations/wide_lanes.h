#pragma once

#include <span>

namespace desmo {

/// How many lanes fill a register of 512 bits.
inline constexpr int wide = 8;

/// to[l][k] = from[offsets[k] + l], of one to eight lanes: as many as `to` has. from: begins a
/// cache line; offsets: multiples of eight. To be called where has_lanes(wide) alone.
void unpack_wide(const double* from, std::span<const int> offsets, std::span<double* const> to);
/// The same with lane l at to[places[l]] and behind it.
void unpack_wide(const double* from, std::span<const int> offsets, double* to,
                 std::span<const int> places);

}  // namespace desmo
