#include "formulations/batch/layout.h"

#if defined(__x86_64__) && defined(__GNUC__)

#include <immintrin.h>

#include <array>
#include <cstddef>

// Only these functions are compiled for wide registers, not the whole file. Otherwise inline
// functions of standard headers would be, too, and the linker might choose those copies for callers
// on processors without such registers.
#define DESMO_WIDE [[gnu::target("arch=x86-64-v4")]]

namespace desmo {

namespace {

/// Return four numbers a, b, c, d of the first two or the last two of four lanes, one lane after
/// the other. ab, cd: the pairs a, b and c, d of the four lanes, one lane after the other.
DESMO_WIDE inline __m512d lower_pairs(__m512d ab, __m512d cd) {
  return _mm512_permutex2var_pd(ab, _mm512_set_epi64(11, 10, 3, 2, 9, 8, 1, 0), cd);
}
DESMO_WIDE inline __m512d upper_pairs(__m512d ab, __m512d cd) {
  return _mm512_permutex2var_pd(ab, _mm512_set_epi64(15, 14, 7, 6, 13, 12, 5, 4), cd);
}

/// The destination of each used lane.
template <std::size_t used>
using Targets = std::array<double*, used>;

/// Writes eight numbers of lanes `lane` and `lane + 2`, from two registers with four numbers of
/// each.
template <std::size_t lane, std::size_t used>
DESMO_WIDE inline void put(__m512d first, __m512d second, const Targets<used>& to, std::size_t k) {
  if constexpr (lane < used)
    _mm512_storeu_pd(to[lane] + k, _mm512_shuffle_f64x2(first, second, 0x44));
  if constexpr (lane + 2 < used)
    _mm512_storeu_pd(to[lane + 2] + k, _mm512_shuffle_f64x2(first, second, 0xee));
}

/// Writes eight numbers of each lane to elements k … k + 7.
template <std::size_t used>
DESMO_WIDE inline void unpack_eight(const double* from, const int* offsets, const Targets<used>& to,
                                    std::size_t k) {
  const __m512d a = _mm512_load_pd(from + offsets[0]), b = _mm512_load_pd(from + offsets[1]),
                c = _mm512_load_pd(from + offsets[2]), d = _mm512_load_pd(from + offsets[3]),
                e = _mm512_load_pd(from + offsets[4]), f = _mm512_load_pd(from + offsets[5]),
                g = _mm512_load_pd(from + offsets[6]), h = _mm512_load_pd(from + offsets[7]);
  const __m512d even_ab = _mm512_unpacklo_pd(a, b), odd_ab = _mm512_unpackhi_pd(a, b),
                even_cd = _mm512_unpacklo_pd(c, d), odd_cd = _mm512_unpackhi_pd(c, d),
                even_ef = _mm512_unpacklo_pd(e, f), odd_ef = _mm512_unpackhi_pd(e, f),
                even_gh = _mm512_unpacklo_pd(g, h), odd_gh = _mm512_unpackhi_pd(g, h);
  put<0>(lower_pairs(even_ab, even_cd), lower_pairs(even_ef, even_gh), to, k);
  put<1>(lower_pairs(odd_ab, odd_cd), lower_pairs(odd_ef, odd_gh), to, k);
  put<4>(upper_pairs(even_ab, even_cd), upper_pairs(even_ef, even_gh), to, k);
  put<5>(upper_pairs(odd_ab, odd_cd), upper_pairs(odd_ef, odd_gh), to, k);
}

/// Writes two numbers of a lane: pair `lane / 2` of the register.
template <std::size_t lane, std::size_t used>
DESMO_WIDE inline void put_pair(__m512d pairs, const Targets<used>& to, std::size_t k) {
  if constexpr (lane < used)
    _mm_storeu_pd(to[lane] + k, _mm512_extractf64x2_pd(pairs, static_cast<int>(lane / 2)));
}

/// Writes two numbers of each lane to elements k and k + 1.
template <std::size_t used>
DESMO_WIDE inline void unpack_two(const double* from, const int* offsets, const Targets<used>& to,
                                  std::size_t k) {
  const __m512d a = _mm512_load_pd(from + offsets[0]), b = _mm512_load_pd(from + offsets[1]);
  const __m512d even = _mm512_unpacklo_pd(a, b), odd = _mm512_unpackhi_pd(a, b);
  put_pair<0>(even, to, k), put_pair<1>(odd, to, k);
  put_pair<2>(even, to, k), put_pair<3>(odd, to, k);
  put_pair<4>(even, to, k), put_pair<5>(odd, to, k);
  put_pair<6>(even, to, k), put_pair<7>(odd, to, k);
}

/// Writes numbers of each lane, one after the other. target(l): where lane l is written.
template <std::size_t used, class Target>
DESMO_WIDE void unpack_lanes(const double* from, std::span<const int> offsets, Target target) {
  Targets<used> to;  // a copy: stores might alias the original
  for (std::size_t l = 0; l < used; ++l) to[l] = target(l);
  std::size_t k = 0;
  for (; k + wide <= offsets.size(); k += wide) unpack_eight(from, &offsets[k], to, k);
  for (; k + 2 <= offsets.size(); k += 2) unpack_two(from, &offsets[k], to, k);
  if (k < offsets.size())
    for (std::size_t l = 0; l < used; ++l) to[l][k] = from[offsets[k] + l];
}

template <std::size_t used>
DESMO_WIDE void unpack_copies(std::span<const LaneCopy> copies, std::span<const int> offsets,
                              const int* places) {
  for (const auto& [from, to] : copies)
    unpack_lanes<used>(from, offsets, [to = to, places](std::size_t l) { return to + places[l]; });
}

}  // namespace

void unpack_wide(const double* from, std::span<const int> offsets, std::span<double* const> to) {
  unpack_lanes<wide>(from, offsets, [to](std::size_t l) { return to[l]; });
}

void unpack_wide(std::span<const LaneCopy> copies, std::span<const int> offsets,
                 std::span<const int> places) {
  using Unpack = void(std::span<const LaneCopy>, std::span<const int>, const int*);
  static constexpr std::array<Unpack*, wide> by_lanes{
      unpack_copies<1>, unpack_copies<2>, unpack_copies<3>, unpack_copies<4>,
      unpack_copies<5>, unpack_copies<6>, unpack_copies<7>, unpack_copies<8>};
  by_lanes[places.size() - 1](copies, offsets, places.data());
}

}  // namespace desmo

#else

namespace desmo {

void unpack_wide(const double*, std::span<const int>, std::span<double* const>) {}
void unpack_wide(std::span<const LaneCopy>, std::span<const int>, std::span<const int>) {}

}  // namespace desmo

#endif
