#include "formulations/modelling/measures/rest.h"

#include <cmath>

#include "cases/numbers/compensated.h"

namespace desmo {

bool vanishes(const Motion& motion, double time, Level level) {
  using Number = Compensated<double>;
  const Number about{time, 0, 0x1p-52 * std::abs(time)};
  const MotionSample<Number> z = sample(motion, about);
  const Interval rate = (level == Level::velocity ? z.velocity : z.acceleration).enclosure();
  return !(std::abs(rate.mid) > rate.radius);
}

}  // namespace desmo
