// How the time of a step grows with the size, and where caches end it.
#include "report/digits.h"
#include "report/size/caches.h"
#include "report/size/curves.h"
#include "report/tables/size.h"
#include "report/tables/slope.h"

namespace desmo::report {
namespace {

/// With how many the slope is linear, and with which it is not.
std::string linearity(const std::vector<Curve>& curves) {
  std::size_t fitted = 0, linear = 0;
  std::string others;
  for (const Curve& curve : curves) {
    const SizedTimes times = judged_times(curve);
    const auto slope = fit_slope(times.sizes, times.seconds);
    if (!slope) continue;
    ++fitted;
    if (is_linear(slope->value))
      ++linear;
    else
      others += (others.empty() ? "" : ", ") + curve.case_name + " with " + curve.id + " (" +
                write_fixed(slope->value, 3) + ")";
  }
  if (fitted == 0) return "There are too few sizes to say how time grows.";
  return "Up to " + std::to_string(judged_coordinates) + " coordinates time grows linearly in " +
         std::to_string(linear) + " of " + std::to_string(fitted) +
         " pairs of case and formulation" +
         (others.empty() ? "." : "; the slope is another for " + others + ".");
}

/// Where growth has ended, formulation by formulation.
std::string ends(const Record& record, const std::vector<Curve>& curves) {
  const std::vector<Cache> caches = data_caches(record.machine);
  std::string text;
  for (const Curve& curve : curves)
    if (const CurvePoint* const end = end_of_growth(curve)) {
      const std::string holder =
          end->entry->bytes ? held_by(caches, *end->entry->bytes) : std::string();
      text += (text.empty() ? "" : "; ") + curve.case_name + " with " + curve.id + " from " +
              std::to_string(end->coordinates) + " coordinates on" +
              (holder.empty() ? "" : " (memory " + holder + ")");
    }
  return text.empty() ? "At no size does a coordinate cost more than " + write_shortest(dearer) +
                            " times its least."
                      : "A coordinate costs more than " + write_shortest(dearer) +
                            " times its least: " + text + ".";
}

}  // namespace

Section growth(const Record& record) {
  const std::vector<Curve> curves = curves_of(record.growth);
  return {"Growth, and where caches end it",
          {linearity(curves), ends(record, curves)},
          {growth_data(record), growth_exponents(curves), growth_caches(record, curves)}};
}

}  // namespace desmo::report
