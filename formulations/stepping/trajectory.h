#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "formulations/base/observer.h"

namespace desmo {

/// Keeps the instants of a motion, in whatever order they come.
class Trajectory final : public Observer {
 public:
  Trajectory(int instants, int coordinates);

  void observe(const Instant& instant) override;
  bool takes_any_order() const override { return true; }

  /// In order of time.
  void hand_on(Observer& observer) const;

 private:
  struct Values {
    std::vector<double> of_all;
    bool known = false;
  };
  void keep(Values& values, const Instant& instant, std::span<const double> given);
  std::span<const double> kept(const Values& values, std::size_t instant) const;

  std::size_t coordinates_;
  std::vector<double> times_;
  std::vector<long> updates_;
  std::vector<double> residuals_;
  Values q_, qd_, qdd_;
};

}  // namespace desmo
