#include "report/tables/slope.h"

#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr double min_linear = 0.9, max_linear = 1.15;

std::string linearity(const Slope& slope) {
  if (!is_linear(slope.value)) return "not linear";
  return is_linear(slope.low) && is_linear(slope.high) ? "linear" : "uncertain";
}

}  // namespace

std::string linear_note() {
  return "linear: from " + write_shortest(min_linear) + " to " + write_shortest(max_linear) +
         "; uncertain: the interval reaches beyond";
}

bool is_linear(double slope) { return min_linear <= slope && slope <= max_linear; }

Entry slope_entry(const SizedTimes& times) {
  const auto slope = fit_slope(times.sizes, times.seconds);
  const std::string count = std::to_string(times.sizes.size());
  const std::string gap = times.mark.empty() ? "" : ", a size " + times.mark;
  if (!slope && times.sizes.empty())
    return note_entry(times.mark.empty() ? missing_mark : times.mark);
  if (!slope) return note_entry("too few sizes: " + count + gap);
  const std::string value = write_fixed(slope->value, 3), low = write_fixed(slope->low, 3),
                    high = write_fixed(slope->high, 3);
  const std::string note = linearity(*slope) + gap;
  return {value + " [" + low + ", " + high + "] n=" + count + " " + note,
          {value, low, high, count},
          note};
}

}  // namespace desmo::report
