// A row for a live run, from a motion that is known.
#pragma once

#include <vector>

#include "formulations/base/live_row.h"
#include "formulations/model/model.h"

namespace desmo {

/// Values of the drivers of a model at a time.
struct DriverRow {
  double time;
  std::vector<double> z, zd, zdd;

  DriverRow(const Model& m, double t) : time(t) {
    for (const Driver& d : m.drivers) {
      const MotionSample<double> s = sample(d.motion, t);
      z.push_back(s.position), zd.push_back(s.velocity), zdd.push_back(s.acceleration);
    }
  }
  operator LiveRow() const { return {time, z, zd, zdd}; }
};

}  // namespace desmo
