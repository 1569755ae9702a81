#include "formulations/batch/lane_transport.h"

#include <algorithm>

#ifdef __AVX__
#include <immintrin.h>
#endif

#include "formulations/batch/wide_lanes.h"
#include "formulations/equations/lane_kernel.h"

namespace desmo {

namespace {

using Places = std::array<int, quad>;

/// used: the others stand with the last of these.
template <std::size_t lanes>
std::array<int, lanes> places_of(int number, const LanePlaces& places, std::size_t first_lane,
                                 std::size_t used) {
  std::array<int, lanes> result;
  for (std::size_t l = 0; l < lanes; ++l)
    result[l] = places[std::min(first_lane + l, used - 1)][number];
  return result;
}

/// Whether these follow so many places that begin at others.
template <std::size_t lanes>
bool follow(const std::array<int, lanes>& places, const std::array<int, lanes>& begin, int size) {
  for (std::size_t l = 0; l < lanes; ++l)
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

void unpack(const double* from, std::span<const int> offsets, std::span<double* const> to) {
  if (to.size() == wide && has_lanes(wide)) return unpack_wide(from, offsets, to);
  std::size_t unpacked = 0;
#ifdef __AVX__
  unpacked = offsets.size() / 4 * 4;
  for (std::size_t l = 0; l < to.size(); l += quad) {
    const std::array<double*, quad> of_quad{to[l], to[l + 1], to[l + 2], to[l + 3]};
    const auto row = [&](std::size_t n) { return from + offsets[n] + l; };
    for (std::size_t n = 0; n < unpacked; n += 4)
      unpack_four({row(n), row(n + 1), row(n + 2), row(n + 3)}, of_quad, n);
  }
#endif
  for (std::size_t n = unpacked; n < offsets.size(); ++n)
    for (std::size_t l = 0; l < to.size(); ++l) to[l][n] = from[offsets[n] + l];
}

LaneSources::LaneSources(std::span<const int> which, const LanePlaces& places)
    : quads_(places.size() / quad) {
  for (std::size_t number = 0; number < quads_.size(); ++number) {
    std::vector<Run>& runs = quads_[number];
    for (const int n : which) {
      const Places place = places_of<quad>(n, places, number * quad, places.size());
      if (!runs.empty() && runs.back().first + runs.back().size == n &&
          follow(place, runs.back().place, runs.back().size))
        ++runs.back().size;
      else
        runs.push_back({n, 1, place});
    }
  }
}

namespace {

void gather_quad(const double* from, const Places& place, double* to) {
#ifdef __AVX__
  _mm256_store_pd(to,
                  _mm256_set_pd(from[place[3]], from[place[2]], from[place[1]], from[place[0]]));
#else
  for (int l = 0; l < quad; ++l) to[l] = from[place[l]];
#endif
}

}  // namespace

template <std::size_t lanes, std::size_t arrays>
void LaneSources::gather_lanes(const std::array<const double*, arrays>& from,
                               std::array<double*, arrays> to) const {
  for (const std::vector<Run>& runs : quads_) {
    for (const Run& r : runs) {
      const auto [first, size, place] = r;  // stores might change what they are read from
      for (int k = 0; k < size; ++k)
        for (std::size_t a = 0; a < arrays; ++a)
          gather_quad(from[a] + k, place, to[a] + (first + k) * lanes);
    }
    for (double*& array : to) array += quad;
  }
}

template <std::size_t arrays>
void LaneSources::gather(const std::array<const double*, arrays>& from,
                         const std::array<double*, arrays>& to) const {
  quads_.size() == 1 ? gather_lanes<4>(from, to) : gather_lanes<8>(from, to);
}

template void LaneSources::gather(const std::array<const double*, 1>&,
                                  const std::array<double*, 1>&) const;
template void LaneSources::gather(const std::array<const double*, 3>&,
                                  const std::array<double*, 3>&) const;

template <std::size_t lanes>
void LaneTargets::add(std::vector<int> numbers, const LanePlaces& places, std::size_t first_lane,
                      std::vector<Run<lanes>>& runs) {
  std::ranges::sort(numbers, {}, [&](int n) { return places[first_lane][n]; });
  const std::size_t before = runs.size();
  for (const int n : numbers) {
    const auto place = places_of<lanes>(n, places, first_lane, used_);
    if (runs.size() > before && follow(place, runs.back().places, runs.back().size))
      ++runs.back().size;
    else
      runs.push_back({1, offsets_.size(), place});
    offsets_.push_back(static_cast<int>(n * lanes_ + first_lane));
  }
}

LaneTargets::LaneTargets(std::span<const int> which, const LanePlaces& places, std::size_t used)
    : lanes_(places.size()), used_(used) {
  const bool is_wide = lanes_ == wide && has_lanes(wide);
  const std::size_t together = is_wide ? used : quad;
  for (std::size_t first = 0; first < used; first += together) {
    const std::size_t end = std::min(first + together, used);
    const auto has_place = [&](std::size_t lane, int n) { return places[lane][n] >= 0; };
    std::vector<int> of_all;
    std::vector<std::vector<int>> alone(together);
    for (const int n : which) {
      bool all = end == first + together;
      for (std::size_t l = first; l < end; ++l) all = all && has_place(l, n);
      if (all) of_all.push_back(n);
      for (std::size_t l = first; l < end; ++l)
        if (!all && has_place(l, n)) alone[l - first].push_back(n);
    }
    is_wide ? add(std::move(of_all), places, first, wides_)
            : add(std::move(of_all), places, first, quads_);
    for (std::size_t l = first; l < end; ++l) add(std::move(alone[l - first]), places, l, singles_);
  }
}

void LaneTargets::scatter(std::span<const LaneCopy> copies) const {
  for (const Run<wide>& run : wides_)
    unpack_wide(copies, {&offsets_[run.first], static_cast<std::size_t>(run.size)},
                {run.places.data(), used_});
  for (const auto& [from, to] : copies) {
    for (const Run<quad>& run : quads_) scatter_run(run, from, to);
    for (const Run<1>& run : singles_) scatter_run(run, from, to);
  }
}

void LaneTargets::scatter_run(const Run<quad>& run, const double* __restrict from,
                              double* __restrict to) const {
  const auto [a, b, c, d] = run.places;
  const int* const offset = offsets_.data() + run.first;
  const int size = run.size;
  int k = 0;
#ifdef __AVX__
  const auto row = [&](int number) { return from + offset[number]; };
  for (; k + 4 <= size; k += 4)
    unpack_four({row(k), row(k + 1), row(k + 2), row(k + 3)}, {to + a, to + b, to + c, to + d}, k);
  if (k + 2 <= size) {
    put_two(_mm256_load_pd(row(k)), _mm256_load_pd(row(k + 1)), k, run.places, to);
    k += 2;
  }
  if (k < size) put_one(_mm256_load_pd(row(k)), k, run.places, to);
#else
  for (; k < size; ++k) {
    const double* const x = from + offset[k];
    to[a + k] = x[0], to[b + k] = x[1], to[c + k] = x[2], to[d + k] = x[3];
  }
#endif
}

void LaneTargets::scatter_run(const Run<1>& run, const double* __restrict from,
                              double* __restrict to) const {
  const int* const offset = offsets_.data() + run.first;
  double* const values = to + run.places[0];
  const int size = run.size;
  int k = 0;
#ifdef __AVX__
  for (; k + 4 <= size; k += 4)
    _mm256_storeu_pd(values + k, _mm256_set_pd(from[offset[k + 3]], from[offset[k + 2]],
                                               from[offset[k + 1]], from[offset[k]]));
#endif
  for (; k < size; ++k) values[k] = from[offset[k]];
}

}  // namespace desmo
