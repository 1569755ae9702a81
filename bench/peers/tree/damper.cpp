#include "bench/peers/tree/damper.h"

#include "bench/peers/tree/nominal.h"

namespace desmo::tree {

Damper::Damper(const Mechanism& d, const std::string& prefix, const std::string& rod,
               const std::string& tube)
    : a_(nominal(d, prefix + "A" + rod) - nominal(d, prefix + "S")),
      t_(nominal(d, prefix + "T" + tube)) {}

std::vector<std::string> Damper::delivered(const std::string& prefix, const std::string& rod,
                                           const std::string& tube) {
  return {prefix + "A" + rod, prefix + "d" + rod,  prefix + "u" + rod,
          prefix + "n" + rod, prefix + "n" + tube, prefix + "s" + rod};
}

void Damper::solve(const Pose& axle, AnswerWriter& out) const {
  const Moving<Vec> a = axle.at(a_);
  const auto [s, d] = polar(-1 * (a - t_));  // T − A = s d
  const Moving<Vec> u = unit(cross(d, axle.x)), n = cross(d, u);
  out.put(a);
  out.put(d);
  out.put(u);
  out.put(n);
  out.put(-1 * n);
  out.put(s);
}

}  // namespace desmo::tree
