#include "formulations/lane_transport.h"

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace desmo {

namespace {

constexpr unsigned every_lane = (1u << lane_count) - 1;

void put(const Lanes& from, int component, const std::array<int, lane_count>& place, unsigned lanes,
         double* to) {
  alignas(Lanes) double values[lane_count];
  from.copy_to(values, std::experimental::vector_aligned);
  for (int l = 0; l < lane_count; ++l)
    if (lanes >> l & 1) to[place[l] + component] = values[l];
}

#ifdef __AVX__
static_assert(lane_count == 4);

/// One component of all lanes.
void put_one(__m256d x, int component, const std::array<int, lane_count>& place, double* to) {
  const __m128d low = _mm256_castpd256_pd128(x), high = _mm256_extractf128_pd(x, 1);
  _mm_storel_pd(to + place[0] + component, low);
  _mm_storeh_pd(to + place[1] + component, low);
  _mm_storel_pd(to + place[2] + component, high);
  _mm_storeh_pd(to + place[3] + component, high);
}

/// The first two components of all lanes, side by side.
void put_two(__m256d x, __m256d y, const std::array<int, lane_count>& place, double* to) {
  const __m256d even = _mm256_unpacklo_pd(x, y), odd = _mm256_unpackhi_pd(x, y);
  _mm_storeu_pd(to + place[0], _mm256_castpd256_pd128(even));
  _mm_storeu_pd(to + place[1], _mm256_castpd256_pd128(odd));
  _mm_storeu_pd(to + place[2], _mm256_extractf128_pd(even, 1));
  _mm_storeu_pd(to + place[3], _mm256_extractf128_pd(odd, 1));
}

/// Four values of all lanes, to element k and the three behind it.
void unpack_four(const Lanes* from, const std::array<double*, lane_count>& to, std::size_t k) {
  const __m256d a(from[0]), b(from[1]), c(from[2]), d(from[3]);
  const __m256d even_ab = _mm256_unpacklo_pd(a, b), odd_ab = _mm256_unpackhi_pd(a, b);
  const __m256d even_cd = _mm256_unpacklo_pd(c, d), odd_cd = _mm256_unpackhi_pd(c, d);
  _mm256_storeu_pd(to[0] + k, _mm256_permute2f128_pd(even_ab, even_cd, 0x20));
  _mm256_storeu_pd(to[1] + k, _mm256_permute2f128_pd(odd_ab, odd_cd, 0x20));
  _mm256_storeu_pd(to[2] + k, _mm256_permute2f128_pd(even_ab, even_cd, 0x31));
  _mm256_storeu_pd(to[3] + k, _mm256_permute2f128_pd(odd_ab, odd_cd, 0x31));
}
#endif

}  // namespace

void unpack(std::span<const Lanes> from, const std::array<double*, lane_count>& to) {
  std::size_t k = 0;
#ifdef __AVX__
  for (; k + lane_count <= from.size(); k += lane_count) unpack_four(&from[k], to, k);
#endif
  for (; k < from.size(); ++k)
    for (int l = 0; l < lane_count; ++l) to[l][k] = from[k][l];
}

void unpack(std::span<const Lanes> from, std::span<const int> which,
            const std::array<double*, lane_count>& to) {
  for (const int k : which)
    for (int l = 0; l < lane_count; ++l) to[l][k] = from[k][l];
}

LanePlaces::LanePlaces(std::span<const int> inputs, const std::array<const int*, lane_count>& in) {
  for (const int i : inputs) {
    const auto continues = [&](const Run& run) {
      if (run.first + run.size != i || run.size == 3) return false;
      for (int l = 0; l < lane_count; ++l)
        if (in[l][i] != run.place[l] + run.size) return false;
      return true;
    };
    if (!runs_.empty() && continues(runs_.back())) {
      ++runs_.back().size;
      continue;
    }
    runs_.push_back({i, 1, {}});
    for (int l = 0; l < lane_count; ++l) runs_.back().place[l] = in[l][i];
  }
}

void LanePlaces::gather(const double* state, Lanes* to) const {
  for (const Run& r : runs_)
    for (int k = 0; k < r.size; ++k)
      to[r.first + k] = Lanes([&](auto lane) { return state[r.place[lane] + k]; });
}

void LanePlaces::scatter(const Lanes* from, unsigned lanes, double* state) const {
#ifdef __AVX__
  if (lanes == every_lane) {
    for (const Run& r : runs_) {
      const Lanes* const x = from + r.first;
      if (r.size >= 2)
        put_two(static_cast<__m256d>(x[0]), static_cast<__m256d>(x[1]), r.place, state);
      if (r.size != 2) put_one(static_cast<__m256d>(x[r.size - 1]), r.size - 1, r.place, state);
    }
    return;
  }
#endif
  for (const Run& r : runs_)
    for (int k = 0; k < r.size; ++k) put(from[r.first + k], k, r.place, lanes, state);
}

}  // namespace desmo
