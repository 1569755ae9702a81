#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace desmo {

/// How many lanes fill a register of 512 bits.
inline constexpr int wide = 8;

/// to[l][k] = from[offsets[k] + l]. from: begins a cache line; offsets: multiples of eight. To be
/// called where has_lanes(wide) alone.
void unpack_wide(const double* from, std::span<const int> offsets,
                 const std::array<double*, wide>& to);

}  // namespace desmo
