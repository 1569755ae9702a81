// Data of the page of a moving mechanism.
#pragma once

#include <string>

#include "bench/cli/view/motion_recorder.h"
#include "cases/mechanism/scene.h"

namespace desmo::cli {

/// A motion that was solved, to be shown.
struct ShownMotion {
  const Scene& scene;
  const Model& model;
  const MotionRecorder& recording;
  const MonitoredSummary& summary;
  std::string formulation;
};

/// Data as page.html takes them.
struct PageData {
  std::string json;     ///< everything but the columns of numbers, which it names by their places
  std::string numbers;  ///< PackedColumns::text()
};

/// Writes every `every`th of the recorded instants, and the last ones before gaps and the end.
/// Positions are as exact as 1e-5 of the mechanism's size, rates as 1/4000 of the largest; what is
/// plotted is in single precision. The scene's request is plotted, or else relative coordinates and
/// points, as many as fit.
PageData page_data(const ShownMotion& motion, int every);

}  // namespace desmo::cli
