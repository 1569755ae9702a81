#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "cases/mechanism/level.h"
#include "cases/mechanism/motion.h"
#include "formulations/modelling/measures/measures.h"

namespace desmo {

/// The ratio of two coordinates' rates (Measures).
class RateRatio {
 public:
  /// of: positions in q of the coordinate whose rate is divided, and of the one that divides it
  RateRatio(const Model& model, const std::array<int, 2>& of, Measures::DrivenBy driven_by);

  /// Returns the ratio at an instant; NaN: it is not known.
  double operator()(const Instant& instant) const;

 private:
  double fastest_driver(std::span<const double> rates, double time, Level level) const;
  bool is_nothing(std::span<const double> rates, int coordinate, double scale) const;

  struct DriverRate {
    int coordinate;
    std::shared_ptr<const Motion> motion;  // null: rates come from rows of numbers
  };

  std::array<int, 2> of_;
  std::vector<double> magnitude_;  // nominal magnitude of each coordinate
  std::vector<DriverRate> drivers_;
};

}  // namespace desmo
