#include "formulations/batch/layout.h"

#include <algorithm>

#ifdef __AVX__
#include <immintrin.h>
#endif

#include "formulations/equations/lane_kernel.h"

namespace desmo {

namespace {

using Places = std::array<int, quad>;

/// Returns the places of a number in lanes from first_lane on. Lanes from `used` on repeat the
/// place of lane used − 1.
template <std::size_t lanes>
std::array<int, lanes> places_of(int number, const LanePlaces& places, std::size_t first_lane,
                                 std::size_t used) {
  std::array<int, lanes> result;
  for (std::size_t l = 0; l < lanes; ++l)
    result[l] = places[std::min(first_lane + l, used - 1)][number];
  return result;
}

/// Returns whether, in each lane, the place is `size` after `begin`.
template <std::size_t lanes>
bool follow(const std::array<int, lanes>& places, const std::array<int, lanes>& begin, int size) {
  for (std::size_t l = 0; l < lanes; ++l)
    if (places[l] != begin[l] + size) return false;
  return true;
}

#ifdef __AVX__
/// Writes two numbers of four lanes to elements k and k + 1 of each lane's array.
void put_two(__m256d x, __m256d y, const std::array<double*, quad>& to, std::size_t k) {
  const __m256d even = _mm256_unpacklo_pd(x, y), odd = _mm256_unpackhi_pd(x, y);
  _mm_storeu_pd(to[0] + k, _mm256_castpd256_pd128(even));
  _mm_storeu_pd(to[1] + k, _mm256_castpd256_pd128(odd));
  _mm_storeu_pd(to[2] + k, _mm256_extractf128_pd(even, 1));
  _mm_storeu_pd(to[3] + k, _mm256_extractf128_pd(odd, 1));
}

/// Writes four numbers of four lanes to elements k … k + 3 of each lane's array.
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

/// Writes numbers of four lanes, which begin at these offsets, one after the other to each lane's
/// array.
[[gnu::always_inline]] inline void scatter_quad(const double* __restrict from,
                                                std::span<const int> offsets,
                                                std::array<double*, quad> to) {
  const auto row = [&](std::size_t n) { return from + offsets[n]; };
  const std::size_t size = offsets.size();
  std::size_t k = 0;
#ifdef __AVX__
  for (; k + 4 <= size; k += 4) unpack_four({row(k), row(k + 1), row(k + 2), row(k + 3)}, to, k);
  if (k + 2 <= size) {
    put_two(_mm256_load_pd(row(k)), _mm256_load_pd(row(k + 1)), to, k);
    k += 2;
  }
#endif
  for (; k < size; ++k)
    for (int l = 0; l < quad; ++l) to[l][k] = row(k)[l];
}

/// Writes a number of each of four lanes, from its places in an array, side by side.
void gather_quad(const double* from, const Places& place, double* to) {
#ifdef __AVX__
  _mm256_store_pd(to,
                  _mm256_set_pd(from[place[3]], from[place[2]], from[place[1]], from[place[0]]));
#else
  for (int l = 0; l < quad; ++l) to[l] = from[place[l]];
#endif
}

}  // namespace

void unpack(const double* from, std::span<const int> offsets, std::span<double* const> to) {
  if (to.size() == wide && has_lanes(wide)) return unpack_wide(from, offsets, to);
  for (std::size_t l = 0; l < to.size(); l += quad)
    scatter_quad(from + l, offsets, {to[l], to[l + 1], to[l + 2], to[l + 3]});
}

Gather::Gather(std::span<const int> which, const LanePlaces& places)
    : quads_(places.size() / quad) {
  for (std::size_t number = 0; number < quads_.size(); ++number) {
    std::vector<Range>& ranges = quads_[number];
    for (const int n : which) {
      const Places place = places_of<quad>(n, places, number * quad, places.size());
      if (!ranges.empty() && ranges.back().first + ranges.back().size == n &&
          follow(place, ranges.back().place, ranges.back().size))
        ++ranges.back().size;
      else
        ranges.push_back({n, 1, place});
    }
  }
}

template <std::size_t lanes, std::size_t arrays>
void Gather::gather_lanes(const std::array<const double*, arrays>& from,
                          std::array<double*, arrays> to) const {
  for (const std::vector<Range>& ranges : quads_) {
    for (const Range& r : ranges) {
      const auto [first, size, place] = r;  // a copy: stores through `to` might alias the range
      for (int k = 0; k < size; ++k)
        for (std::size_t a = 0; a < arrays; ++a)
          gather_quad(from[a] + k, place, to[a] + (first + k) * lanes);
    }
    for (double*& array : to) array += quad;
  }
}

template <std::size_t arrays>
void Gather::gather(const std::array<const double*, arrays>& from,
                    const std::array<double*, arrays>& to) const {
  quads_.size() == 1 ? gather_lanes<4>(from, to) : gather_lanes<8>(from, to);
}

template void Gather::gather(const std::array<const double*, 1>&,
                             const std::array<double*, 1>&) const;
template void Gather::gather(const std::array<const double*, 3>&,
                             const std::array<double*, 3>&) const;

template <std::size_t lanes>
void Scatter::add(std::vector<int> numbers, const LanePlaces& places, std::size_t first_lane,
                  std::vector<Range<lanes>>& ranges) {
  std::ranges::sort(numbers, {}, [&](int n) { return places[first_lane][n]; });
  const std::size_t before = ranges.size();
  for (const int n : numbers) {
    const auto place = places_of<lanes>(n, places, first_lane, used_);
    if (ranges.size() > before && follow(place, ranges.back().places, ranges.back().size))
      ++ranges.back().size;
    else
      ranges.push_back({1, offsets_.size(), place});
    offsets_.push_back(static_cast<int>(n * places.size() + first_lane));
  }
}

Scatter::Scatter(std::span<const int> which, const LanePlaces& places, std::size_t used)
    : used_(used) {
  const bool is_wide = places.size() == wide && has_lanes(wide);
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

void Scatter::scatter(std::span<const LaneCopy> copies) const {
  for (const Range<wide>& range : wides_)
    unpack_wide(copies, {&offsets_[range.first], static_cast<std::size_t>(range.size)},
                {range.places.data(), used_});
  for (const auto& [from, to] : copies) {
    for (const Range<quad>& range : quads_) scatter_range(range, from, to);
    for (const Range<1>& range : singles_) scatter_range(range, from, to);
  }
}

void Scatter::scatter_range(const Range<quad>& range, const double* from, double* to) const {
  const auto [a, b, c, d] = range.places;
  scatter_quad(from, {&offsets_[range.first], static_cast<std::size_t>(range.size)},
               {to + a, to + b, to + c, to + d});
}

void Scatter::scatter_range(const Range<1>& range, const double* __restrict from,
                            double* __restrict to) const {
  const int* const offset = offsets_.data() + range.first;
  double* const values = to + range.places[0];
  const int size = range.size;
  int k = 0;
#ifdef __AVX__
  for (; k + 4 <= size; k += 4)
    _mm256_storeu_pd(values + k, _mm256_set_pd(from[offset[k + 3]], from[offset[k + 2]],
                                               from[offset[k + 1]], from[offset[k]]));
#endif
  for (; k < size; ++k) values[k] = from[offset[k]];
}

}  // namespace desmo
