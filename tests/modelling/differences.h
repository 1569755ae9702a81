#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "formulations/verification/reference/reference.h"
#include "tests/describing.h"

namespace desmo {

/// Derivatives of a coordinate by differences of positions that are known to 1e-19 of them.
class Differences {
 public:
  Differences(const Model& model, double time) : m_(model) {
    std::vector<double> times;
    for (int i = -4; i <= 4; ++i) times.push_back(time + i * step);
    instants_ = reference_solution(m_, times, Precision::quadruple);
  }

  double operator()(const std::string& name, int order) const {
    static constexpr long double weights[2][9] = {
        {1 / 280.L, -4 / 105.L, 1 / 5.L, -4 / 5.L, 0, 4 / 5.L, -1 / 5.L, 4 / 105.L, -1 / 280.L},
        {-1 / 560.L, 8 / 315.L, -1 / 5.L, 8 / 5.L, -205 / 72.L, 8 / 5.L, -1 / 5.L, 8 / 315.L,
         -1 / 560.L}};
    const auto i = static_cast<std::size_t>(m_.coordinate(name));
    long double sum = 0;
    for (int k = 0; k < 9; ++k)
      sum += weights[order - 1][k] *
             (static_cast<long double>(instants_[k].q[i]) + instants_[k].remainder.q[i]);
    return static_cast<double>(sum / (order == 1 ? step : step * step));
  }
  Vec vector(const std::string& name, int order) const {
    return {(*this)(name + ".x", order), (*this)(name + ".y", order), (*this)(name + ".z", order)};
  }

 private:
  static constexpr long double step = 0x1p-9L;  // [s]
  const Model& m_;
  std::vector<ReferenceInstant> instants_;
};

}  // namespace desmo
