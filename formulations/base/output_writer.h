#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/lane_values.h"
#include "formulations/base/observer.h"

namespace desmo {

/// Returns the coordinates that a request names, or all where it names none. Throws
/// std::invalid_argument if a coordinate is named twice or does not exist. coordinates: number of
/// the model's coordinates.
std::vector<int> requested_coordinates(const Request& request, int coordinates);

/// Writes requested coordinates of instants into memory that an observer lends, range by range.
class OutputWriter {
 public:
  OutputWriter() = default;
  /// coordinates: number of the model's coordinates. Throws as requested_coordinates() does.
  OutputWriter(const Request& request, int coordinates);

  /// - places: index of each coordinate in an output; −1: not written here
  /// - size: number of coordinates in an output
  OutputWriter(std::span<const int> places, std::size_t size);

  /// Copies the requested coordinates of an instant to instant.output. On entry the instant's spans
  /// view all coordinates. On return they view the output, and are empty where its pointer is null.
  void write(Instant& instant) const;
  /// Hands an instant to an observer: the requested coordinates in memory that the observer lends.
  /// Hands over all coordinates in the instant's own memory if the observer lends none.
  Flow hand_over(const Instant& instant, Observer& observer) const;

 private:
  struct Range {
    int first, place, size;
  };

  std::vector<Range> ranges_;
  std::size_t size_ = 0;
};

/// A pool of outputs, all with q and, up to a level, q̇ and q̈. It makes as many outputs as are
/// taken at the same time, and keeps them. Each array has cache lines of its own, since several
/// threads fill the outputs.
class OutputPool {
 public:
  /// size: number of coordinates in an output.
  OutputPool(std::size_t size, Level level) : size_(size), level_(level) {}
  OutputPool(OutputPool&&) = default;  // the outputs' addresses stay valid

  std::size_t size() const { return size_; }

  /// Returns the output that was given back last or, where there is none, a new one filled with
  /// NaN.
  OutputView take() {
    if (free_.empty()) add();
    const OutputView taken = free_.back();
    free_.pop_back();
    return taken;
  }
  /// Takes an output back. The output keeps its values until take() returns it again.
  void give_back(const OutputView& output) { free_.push_back(output); }

 private:
  void add();

  std::size_t size_;
  Level level_;
  std::vector<LaneValues> memory_;  // the arrays of each output
  std::vector<OutputView> free_;
};

}  // namespace desmo
