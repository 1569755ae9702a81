#pragma once

#include "bench/peers/tree/moving.h"

namespace desmo::tree {

/// Where the coordinates of the mechanism are written, one entity after the other.
class Delivery {
 public:
  Delivery(double* q, double* qd, double* qdd) : q_(q), qd_(qd), qdd_(qdd) {}

  template <int n>
  void put(const Moving<Eigen::Matrix<double, n, 1>>& v) {
    for (int i = 0; i < n; ++i) put(Moving<double>{v.q[i], v.qd[i], v.qdd[i]});
  }
  void put(const Moving<double>& x) {
    *q_++ = x.q;
    *qd_++ = x.qd;
    *qdd_++ = x.qdd;
  }

 private:
  double *q_, *qd_, *qdd_;
};

}  // namespace desmo::tree
