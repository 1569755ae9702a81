#include "formulations/base/output_writer.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace desmo {

namespace {

void refuse(int coordinate, const char* why) {
  throw std::invalid_argument("a request names coordinate " + std::to_string(coordinate) + why);
}

/// Returns the index of each coordinate in an output; −1: it is not requested.
std::vector<int> places_of(std::span<const int> requested, int coordinates) {
  std::vector<int> places(coordinates, -1);
  for (std::size_t n = 0; n < requested.size(); ++n) places[requested[n]] = static_cast<int>(n);
  return places;
}

/// Copies numbers from the first to the last. std::copy_n calls std::memmove, which may read the
/// last ones first. These were written a moment ago, and it would wait until they are stored.
void copy_range(const double* from, std::size_t size, double* to) {
  constexpr std::size_t together = 16;
  if (size < together) {
    for (; size > 0; --size) *to++ = *from++;
    return;
  }
  const double* const last = from + (size - together);
  double* const last_to = to + (size - together);
  for (; from < last; from += together, to += together) copy_in_registers<together>(from, to);
  copy_in_registers<together>(last, last_to);  // the last 16, some of them for the second time
}

}  // namespace

std::vector<int> requested_coordinates(const Request& request, int coordinates) {
  std::vector<int> requested(request.coordinates.begin(), request.coordinates.end());
  if (requested.empty()) {
    requested.resize(coordinates);
    std::iota(requested.begin(), requested.end(), 0);
  }
  std::vector<bool> named(coordinates);
  for (const int i : requested) {
    if (i < 0 || i >= coordinates) refuse(i, ", which the model does not have");
    if (named[i]) refuse(i, " twice");
    named[i] = true;
  }
  return requested;
}

OutputWriter::OutputWriter(const Request& request, int coordinates) {
  const std::vector<int> requested = requested_coordinates(request, coordinates);
  *this = OutputWriter(places_of(requested, coordinates), requested.size());
}

OutputWriter::OutputWriter(std::span<const int> places, std::size_t size) : size_(size) {
  for (int i = 0; i < static_cast<int>(places.size()); ++i) {
    if (places[i] < 0) continue;
    const bool follows = !ranges_.empty() && ranges_.back().first + ranges_.back().size == i &&
                         ranges_.back().place + ranges_.back().size == places[i];
    if (follows)
      ++ranges_.back().size;
    else
      ranges_.push_back({i, places[i], 1});
  }
}

void OutputWriter::write(Instant& instant) const {
  const auto write_level = [&](std::span<const double>& values, double* to) {
    if (values.empty()) return;
    if (to)
      for (const auto& [first, place, size] : ranges_) copy_range(&values[first], size, to + place);
    values = {to, to ? size_ : 0};
  };
  write_level(instant.q, instant.output.q);
  write_level(instant.qd, instant.output.qd);
  write_level(instant.qdd, instant.output.qdd);
}

Flow OutputWriter::hand_over(const Instant& instant, Observer& observer) const {
  if (observer.lent_at_once() == 0) return observer.observe(instant);
  Instant lent = instant;
  observer.lend({&instant.index, 1}, {&lent.output, 1});
  write(lent);
  return observer.observe(lent);
}

void OutputPool::add() {
  constexpr std::size_t line = lane_alignment / sizeof(double);
  const std::size_t apart = (size_ + line - 1) / line * line;
  double* const q =
      memory_.emplace_back(3 * apart, std::numeric_limits<double>::quiet_NaN()).data();
  free_.reserve(memory_.size());
  free_.push_back({q, level_ >= Level::velocity ? q + apart : nullptr,
                   level_ >= Level::acceleration ? q + 2 * apart : nullptr});
}

}  // namespace desmo
