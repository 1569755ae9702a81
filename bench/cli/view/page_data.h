// Data of the page of a moving mechanism.
#pragma once

#include <string>

#include "bench/cli/view/motion_recorder.h"
#include "cases/mechanism/scene.h"

namespace desmo::cli {

/// A motion that was solved, to be shown.
struct ShownMotion {
  const Scene& scene;
  const DisplayUnits& units;  ///< of the numbers that people read
  const Model& model;
  const Measures& measures;
  const MotionRecorder& recording;
  const CheckedSummary& summary;
  std::string formulation;
};

/// Bytes that a number takes in a page: four, in base64.
inline constexpr double text_per_number = 16. / 3;

/// Returns the data as page.html takes them: JSON, with the columns of numbers one after the other
/// as base64 of floats of 32 bits. It has every `every`th of the recorded instants, and the last
/// ones before gaps and the end. All numbers are in the scene's units and have seven digits; so
/// have their differences. The scene's request is plotted, or else relative coordinates and points,
/// as many as fit.
std::string page_data(const ShownMotion& motion, int every);

}  // namespace desmo::cli
