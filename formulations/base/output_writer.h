#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/lane_values.h"
#include "formulations/base/observer.h"

namespace desmo {

/// Returns the requested coordinates of a model with `coordinates` of them. Throws
/// std::invalid_argument where one is named twice or does not exist.
std::vector<int> requested_coordinates(const Request& request, int coordinates);

/// Writes requested coordinates of instants into memory that an observer lends, range by range.
class OutputWriter {
 public:
  OutputWriter() = default;
  /// coordinates: of the model. Throws as requested_coordinates() does.
  OutputWriter(const Request& request, int coordinates);

  /// places: of each coordinate in an output, or −1: another writes it. outputs: of `size` places.
  OutputWriter(std::span<const int> places, std::size_t size);

  /// Copies from an instant of all coordinates to its output, which its spans then show.
  void write(Instant& instant) const;
  /// Hands an instant of all coordinates to an observer, in its memory where it lends any.
  Flow hand_over(const Instant& instant, Observer& observer) const;

 private:
  struct Range {
    int first, place, size;
  };

  std::vector<Range> ranges_;
  std::size_t size_ = 0;
};

/// Memory to lend: outputs of one level, as many as are lent at once. Each begins on cache lines
/// of its own, for threads fill several.
class OutputPool {
 public:
  /// size: of coordinates in an output.
  OutputPool(std::size_t size, Level level) : size_(size), level_(level) {}
  OutputPool(OutputPool&&) = default;  // outputs stay where they are

  std::size_t size() const { return size_; }

  /// Returns the output that was given back last, or a new one, filled with NaN.
  OutputView take() {
    if (free_.empty()) add();
    const OutputView taken = free_.back();
    free_.pop_back();
    return taken;
  }
  /// Takes an output back. It holds its values until it is taken again.
  void give_back(const OutputView& output) { free_.push_back(output); }

 private:
  void add();

  std::size_t size_;
  Level level_;
  std::vector<LaneValues> memory_;  // by output
  std::vector<OutputView> free_;
};

}  // namespace desmo
