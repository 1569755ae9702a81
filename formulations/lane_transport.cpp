#include "formulations/lane_transport.h"

#include <algorithm>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace desmo {

namespace {

using Places = std::array<int, quad>;

Places places_of(int number, const LanePlaces& places, std::size_t first_lane) {
  Places result;
  for (int l = 0; l < quad; ++l) result[l] = places[first_lane + l][number];
  return result;
}

/// Whether these follow `size` numbers that begin at others.
bool follow(const Places& places, const Places& begin, int size) {
  for (int l = 0; l < quad; ++l)
    if (places[l] != begin[l] + size) return false;
  return true;
}

#ifdef __AVX__
/// One component of all lanes.
void put_one(__m256d x, int component, const Places& place, double* to) {
  const __m128d low = _mm256_castpd256_pd128(x), high = _mm256_extractf128_pd(x, 1);
  _mm_storel_pd(to + place[0] + component, low);
  _mm_storeh_pd(to + place[1] + component, low);
  _mm_storel_pd(to + place[2] + component, high);
  _mm_storeh_pd(to + place[3] + component, high);
}

/// Two components of all lanes, side by side.
void put_two(__m256d x, __m256d y, int component, const Places& place, double* to) {
  const __m256d even = _mm256_unpacklo_pd(x, y), odd = _mm256_unpackhi_pd(x, y);
  to += component;
  _mm_storeu_pd(to + place[0], _mm256_castpd256_pd128(even));
  _mm_storeu_pd(to + place[1], _mm256_castpd256_pd128(odd));
  _mm_storeu_pd(to + place[2], _mm256_extractf128_pd(even, 1));
  _mm_storeu_pd(to + place[3], _mm256_extractf128_pd(odd, 1));
}

/// Four numbers of a quad to element k and the three behind it.
void unpack_four(const std::array<const double*, 4>& from, const std::array<double*, quad>& to,
                 std::size_t k) {
  const __m256d a = _mm256_load_pd(from[0]), b = _mm256_load_pd(from[1]),
                c = _mm256_load_pd(from[2]), d = _mm256_load_pd(from[3]);
  const __m256d even_ab = _mm256_unpacklo_pd(a, b), odd_ab = _mm256_unpackhi_pd(a, b);
  const __m256d even_cd = _mm256_unpacklo_pd(c, d), odd_cd = _mm256_unpackhi_pd(c, d);
  _mm256_storeu_pd(to[0] + k, _mm256_permute2f128_pd(even_ab, even_cd, 0x20));
  _mm256_storeu_pd(to[1] + k, _mm256_permute2f128_pd(odd_ab, odd_cd, 0x20));
  _mm256_storeu_pd(to[2] + k, _mm256_permute2f128_pd(even_ab, even_cd, 0x31));
  _mm256_storeu_pd(to[3] + k, _mm256_permute2f128_pd(odd_ab, odd_cd, 0x31));
}
#endif

}  // namespace

void unpack(const double* from, std::span<const int> which, std::span<double* const> to) {
  const std::size_t lanes = to.size();
  std::size_t unpacked = 0;
#ifdef __AVX__
  unpacked = which.size() / 4 * 4;
  for (std::size_t l = 0; l < lanes; l += quad) {
    const std::array<double*, quad> of_quad{to[l], to[l + 1], to[l + 2], to[l + 3]};
    const auto row = [&](std::size_t n) { return from + which[n] * lanes + l; };
    for (std::size_t n = 0; n < unpacked; n += 4)
      unpack_four({row(n), row(n + 1), row(n + 2), row(n + 3)}, of_quad, n);
  }
#endif
  for (std::size_t n = unpacked; n < which.size(); ++n)
    for (std::size_t l = 0; l < lanes; ++l) to[l][n] = from[which[n] * lanes + l];
}

LaneSources::LaneSources(std::span<const int> which, const LanePlaces& places)
    : quads_(places.size() / quad) {
  for (std::size_t number = 0; number < quads_.size(); ++number) {
    std::vector<Run>& runs = quads_[number];
    for (const int n : which) {
      const Places place = places_of(n, places, number * quad);
      if (!runs.empty() && runs.back().first + runs.back().size == n &&
          follow(place, runs.back().place, runs.back().size))
        ++runs.back().size;
      else
        runs.push_back({n, 1, place});
    }
  }
}

template <std::size_t lanes>
void LaneSources::gather_lanes(const double* __restrict from, double* __restrict to) const {
  for (const std::vector<Run>& runs : quads_) {
    for (const Run& r : runs) {
      const auto [first, size, place] = r;  // stores might change what they are read from
      const auto [a, b, c, d] = place;
      double* values = to + first * lanes;
      for (int k = 0; k < size; ++k, values += lanes) {
#ifdef __AVX__
        _mm256_store_pd(values, _mm256_set_pd(from[d + k], from[c + k], from[b + k], from[a + k]));
#else
        for (int l = 0; l < quad; ++l) values[l] = from[place[l] + k];
#endif
      }
    }
    to += quad;
  }
}

void LaneSources::gather(const double* from, double* to) const {
  quads_.size() == 1 ? gather_lanes<4>(from, to) : gather_lanes<8>(from, to);
}

LaneTargets::LaneTargets(std::span<const int> which, const LanePlaces& places, std::size_t used)
    : lanes_(places.size()) {
  const auto index = [&](int number, std::size_t lane) {
    return static_cast<int>(number * lanes_ + lane);
  };
  const int stride = static_cast<int>(lanes_);
  const auto put = [&](int number, std::size_t lane) {
    const int from = index(number, lane), place = places[lane][number];
    if (place < 0) return;
    if (!singles_.empty()) {
      LaneRun& last = singles_.back();
      if (from == last.from + last.size * stride && place == last.place + last.size) {
        ++last.size;
        return;
      }
    }
    singles_.push_back({from, 1, place});
  };
  for (std::size_t first = 0; first < used; first += quad) {
    std::vector<int> apart;  // not all lanes of the quad have a place for them
    for (const int n : which) {
      const Places place = places_of(n, places, first);
      if (first + quad > used || std::ranges::any_of(place, [](int p) { return p < 0; })) {
        apart.push_back(n);
        continue;
      }
      const int from = index(n, first);
      if (!quads_.empty() && from == quads_.back().from + quads_.back().size * stride &&
          follow(place, quads_.back().place, quads_.back().size))
        ++quads_.back().size;
      else
        quads_.push_back({from, 1, place});
    }
    for (std::size_t l = first; l < std::min(first + quad, used); ++l)
      for (const int n : apart) put(n, l);
  }
}

template <std::size_t lanes>
void LaneTargets::scatter_lanes(const double* __restrict from, double* __restrict to) const {
  for (const QuadRun& r : quads_) {
    const auto [first, size, place] = r;  // stores might change what they are read from
    const auto [a, b, c, d] = place;
    const double* x = from + first;
    int k = 0;
#ifdef __AVX__
    for (; k + 4 <= size; k += 4, x += 4 * lanes)
      unpack_four({x, x + lanes, x + 2 * lanes, x + 3 * lanes}, {to + a, to + b, to + c, to + d},
                  k);
    if (k + 2 <= size) {
      put_two(_mm256_load_pd(x), _mm256_load_pd(x + lanes), k, place, to);
      k += 2, x += 2 * lanes;
    }
    if (k < size) put_one(_mm256_load_pd(x), k, place, to);
#else
    for (; k < size; ++k, x += lanes)
      for (int l = 0; l < quad; ++l) to[place[l] + k] = x[l];
#endif
  }
  for (const LaneRun& r : singles_) {
    const auto [first, size, place] = r;
    const double* x = from + first;
    int k = 0;
#ifdef __AVX__
    for (; k + 4 <= size; k += 4, x += 4 * lanes)
      _mm256_storeu_pd(to + place + k, _mm256_set_pd(x[3 * lanes], x[2 * lanes], x[lanes], x[0]));
#endif
    for (; k < size; ++k, x += lanes) to[place + k] = x[0];
  }
}

void LaneTargets::scatter(const double* from, double* to) const {
  lanes_ == 4 ? scatter_lanes<4>(from, to) : scatter_lanes<8>(from, to);
}

}  // namespace desmo
