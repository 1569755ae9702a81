// How the time of a step grows with the size, and where caches end it.
#include "report/statistics/curves.h"
#include "report/tables/size.h"
#include "report/tables/slope.h"

namespace desmo::report {
namespace {

/// How many of the slopes are linear.
std::string linearity(const std::vector<Curve>& curves) {
  std::size_t fitted = 0, linear = 0;
  for (const Curve& curve : curves) {
    const SizedTimes times = fitted_times(curve);
    const auto slope = fit_slope(times.sizes, times.seconds);
    fitted += slope.has_value();
    linear += slope && is_linear(slope->value);
  }
  return "Up to " + std::to_string(max_linear_coordinates) +
         " coordinates time grows linearly in " + std::to_string(linear) + " of " +
         std::to_string(fitted) + " pairs of case and formulation.";
}

}  // namespace

Section growth(const Record& record) {
  const std::vector<Curve> curves = curves_of(record.growth);
  return {"Growth, and where caches end it",
          {linearity(curves)},
          {growth_data(record), growth_exponents(curves), growth_caches(record, curves)}};
}

}  // namespace desmo::report
