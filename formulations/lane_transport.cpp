#include "formulations/lane_transport.h"

#include <algorithm>
#include <utility>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace desmo {

namespace {

using Places = std::array<int, quad>;

constexpr unsigned all_of_quad = (1u << quad) - 1;

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

LanePlaces::LanePlaces(std::span<const int> inputs, std::span<const int* const> in)
    : quads_(in.size() / quad), lanes_(in.size()) {
  for (std::size_t number = 0; number < quads_.size(); ++number) {
    const std::span<const int* const> of_quad = in.subspan(number * quad, quad);
    std::vector<Run>& runs = quads_[number];
    for (const int i : inputs)
      append(i, {of_quad[0][i], of_quad[1][i], of_quad[2][i], of_quad[3][i]}, runs);
  }
}

void LanePlaces::append(int input, const Places& place, std::vector<Run>& runs) {
  const auto continues = [&](const Run& run) {
    if (run.first + run.size != input) return false;
    for (int l = 0; l < quad; ++l)
      if (place[l] != run.place[l] + run.size) return false;
    return true;
  };
  if (!runs.empty() && continues(runs.back()))
    ++runs.back().size;
  else
    runs.push_back({input, 1, place});
}

LanePlaces LanePlaces::only(const std::vector<bool>& wanted) const {
  LanePlaces result = *this;
  for (std::vector<Run>& runs : result.quads_)
    for (const Run& run : std::exchange(runs, {}))
      for (int k = 0; k < run.size; ++k) {
        Places place = run.place;
        for (int& p : place) p += k;
        if (std::ranges::any_of(place, [&](int p) { return wanted[p]; }))
          append(run.first + k, place, runs);
      }
  return result;
}

template <std::size_t lanes>
void LanePlaces::gather_lanes(const double* __restrict state, double* __restrict to) const {
  for (const std::vector<Run>& runs : quads_) {
    for (const Run& r : runs) {
      const auto [first, size, place] = r;  // stores might change what they are read from
      const auto [a, b, c, d] = place;
      double* values = to + first * lanes;
      for (int k = 0; k < size; ++k, values += lanes) {
#ifdef __AVX__
        _mm256_store_pd(values,
                        _mm256_set_pd(state[d + k], state[c + k], state[b + k], state[a + k]));
#else
        for (int l = 0; l < quad; ++l) values[l] = state[place[l] + k];
#endif
      }
    }
    to += quad;
  }
}

template <std::size_t lanes>
void LanePlaces::scatter_quad(const std::vector<Run>& runs, const double* __restrict from,
                              double* __restrict state) {
#ifdef __AVX__
  for (const Run& r : runs) {
    const auto [first, size, place] = r;  // stores might change what they are read from
    const auto [a, b, c, d] = place;
    const double* x = from + first * lanes;
    int k = 0;
    for (; k + 4 <= size; k += 4, x += 4 * lanes)
      unpack_four({x, x + lanes, x + 2 * lanes, x + 3 * lanes},
                  {state + a, state + b, state + c, state + d}, k);
    if (k + 2 <= size) {
      put_two(_mm256_load_pd(x), _mm256_load_pd(x + lanes), k, place, state);
      k += 2, x += 2 * lanes;
    }
    if (k < size) put_one(_mm256_load_pd(x), k, place, state);
  }
#else
  for (int l = 0; l < quad; ++l) scatter_lane<lanes>(runs, l, from, state);
#endif
}

template <std::size_t lanes>
void LanePlaces::scatter_lane(const std::vector<Run>& runs, int lane, const double* __restrict from,
                              double* __restrict state) {
  for (const Run& r : runs)
    for (int k = 0; k < r.size; ++k) state[r.place[lane] + k] = from[(r.first + k) * lanes + lane];
}

template <std::size_t lanes>
void LanePlaces::scatter_lanes(const double* from, unsigned which, double* state) const {
  for (const std::vector<Run>& runs : quads_) {
    if ((which & all_of_quad) == all_of_quad)
      scatter_quad<lanes>(runs, from, state);
    else
      for (int l = 0; l < quad; ++l)
        if (which >> l & 1) scatter_lane<lanes>(runs, l, from, state);
    from += quad;
    which >>= quad;
  }
}

void LanePlaces::gather(const double* state, double* to) const {
  lanes_ == 4 ? gather_lanes<4>(state, to) : gather_lanes<8>(state, to);
}

void LanePlaces::scatter(const double* from, unsigned which, double* state) const {
  lanes_ == 4 ? scatter_lanes<4>(from, which, state) : scatter_lanes<8>(from, which, state);
}

}  // namespace desmo
