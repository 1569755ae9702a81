#pragma once

#include <array>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/monitor/recent_instants.h"

namespace desmo {

/// Turning points of the drivers between two instants. Drivers that turn back there go further than
/// both instants show. So a motion may leave the reach of a mechanism and come back unnoticed.
/// Several drivers may do so without turning, on a path that is curved.
class DriverTurns {
 public:
  /// grid: of the motion. magnitudes: of each coordinate. The model must outlive this object.
  DriverTurns(const Model& model, const TimeGrid& grid, std::span<const double> magnitudes);

  /// Finds the times between two instants at which drivers turn beyond both by `min_excursion` or
  /// more, in magnitudes; for several drivers all turns, and the middle, if one leaves the straight
  /// way so far. Returns whether there are any. Allocates nothing.
  bool find(const RecentInstants::Node& from, const Instant& to, double min_excursion);

  /// Returns the times found last, ascending [s].
  std::span<const double> times() const {
    return {times_.data(), static_cast<std::size_t>(count_)};
  }
  void forget() { count_ = 0; }

 private:
  double deviation(const RecentInstants::Node& from, const Instant& to) const;
  void add_turns(const Motion& motion, double from, double to, double min_excursion);
  void add(double time);

  const Model& model_;
  struct Driven {
    int coordinate;
    double unit;  // 1 / magnitude
  };
  std::vector<Driven> driven_;
  bool is_coarse_ = false;  // rates at the ends of a step need not show that a driver turns twice
  std::array<double, 16> times_;
  int count_ = 0;
};

}  // namespace desmo
