#include "cases/mechanism/motion.h"

namespace desmo {

double TimeGrid::time(int i) const { return start + i * steps_per_interval * step; }

}  // namespace desmo
