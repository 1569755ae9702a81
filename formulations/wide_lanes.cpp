#include "formulations/wide_lanes.h"

#if defined(__x86_64__) && defined(__GNUC__)

#include <immintrin.h>

// These functions are compiled for wide registers, and not the file: what the language's headers
// define in it would be, too, and the linker might choose that for everybody.
#define DESMO_WIDE [[gnu::target("arch=x86-64-v4")]]

namespace desmo {

namespace {

using Lanes = std::array<double*, wide>;

/// Four numbers of two lanes, one lane behind the other, from pairs of two numbers.
DESMO_WIDE inline __m512d lower_pairs(__m512d ab, __m512d cd) {
  return _mm512_permutex2var_pd(ab, _mm512_set_epi64(11, 10, 3, 2, 9, 8, 1, 0), cd);
}
DESMO_WIDE inline __m512d upper_pairs(__m512d ab, __m512d cd) {
  return _mm512_permutex2var_pd(ab, _mm512_set_epi64(15, 14, 7, 6, 13, 12, 5, 4), cd);
}

/// Eight numbers of a lane and of the next but one, from two registers with four of each.
DESMO_WIDE inline void put(__m512d first, __m512d second, std::size_t lane, const Lanes& to,
                           std::size_t k) {
  _mm512_storeu_pd(to[lane] + k, _mm512_shuffle_f64x2(first, second, 0x44));
  _mm512_storeu_pd(to[lane + 2] + k, _mm512_shuffle_f64x2(first, second, 0xee));
}

/// Eight numbers of all lanes to element k and the seven behind it.
DESMO_WIDE inline void unpack_eight(const double* from, const int* offsets, const Lanes& to,
                                    std::size_t k) {
  const __m512d a = _mm512_load_pd(from + offsets[0]), b = _mm512_load_pd(from + offsets[1]),
                c = _mm512_load_pd(from + offsets[2]), d = _mm512_load_pd(from + offsets[3]),
                e = _mm512_load_pd(from + offsets[4]), f = _mm512_load_pd(from + offsets[5]),
                g = _mm512_load_pd(from + offsets[6]), h = _mm512_load_pd(from + offsets[7]);
  const __m512d even_ab = _mm512_unpacklo_pd(a, b), odd_ab = _mm512_unpackhi_pd(a, b),
                even_cd = _mm512_unpacklo_pd(c, d), odd_cd = _mm512_unpackhi_pd(c, d),
                even_ef = _mm512_unpacklo_pd(e, f), odd_ef = _mm512_unpackhi_pd(e, f),
                even_gh = _mm512_unpacklo_pd(g, h), odd_gh = _mm512_unpackhi_pd(g, h);
  put(lower_pairs(even_ab, even_cd), lower_pairs(even_ef, even_gh), 0, to, k);
  put(lower_pairs(odd_ab, odd_cd), lower_pairs(odd_ef, odd_gh), 1, to, k);
  put(upper_pairs(even_ab, even_cd), upper_pairs(even_ef, even_gh), 4, to, k);
  put(upper_pairs(odd_ab, odd_cd), upper_pairs(odd_ef, odd_gh), 5, to, k);
}

}  // namespace

DESMO_WIDE void unpack_wide(const double* from, std::span<const int> offsets,
                            const std::array<double*, wide>& to) {
  const Lanes lanes = to;  // stores might change what they are read from
  std::size_t k = 0;
  for (; k + wide <= offsets.size(); k += wide) unpack_eight(from, &offsets[k], lanes, k);
  for (; k < offsets.size(); ++k)
    for (std::size_t l = 0; l < wide; ++l) lanes[l][k] = from[offsets[k] + l];
}

}  // namespace desmo

#else

namespace desmo {

void unpack_wide(const double*, std::span<const int>, const std::array<double*, wide>&) {}

}  // namespace desmo

#endif
