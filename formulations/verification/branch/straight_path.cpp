#include "formulations/verification/branch/straight_path.h"

#include <algorithm>

namespace desmo {

bool StraightPath::lead(std::span<const double> from, std::span<const double> to,
                        std::vector<double>& q, TestBudget& budget) {
  if (std::ranges::equal(from, to)) return true;
  for (std::size_t k = 0; k < from.size(); ++k)
    straight_.drivers[k].motion = Polynomial{{from[k], to[k] - from[k]}};
  budget.take();
  if (!path_.start_at({0, {q, {}, {}}, {}})) return false;
  if (path_.go_to(1, budget).end != PathEnd::same) return false;
  std::ranges::copy(path_.present().values.position, q.begin());
  return true;
}

const CertifiedInstant* StraightPath::find(const DriverLine& line, double s,
                                           std::span<const double> q) {
  line.lead(straight_);
  return path_.start_at({s, {q, {}, {}}, {}}) ? &path_.present() : nullptr;
}

}  // namespace desmo
