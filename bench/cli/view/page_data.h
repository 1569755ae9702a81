// Data of the page of a moving mechanism.
#pragma once

#include <string>

#include "bench/cli/view/motion_recorder.h"
#include "cases/mechanism/scene.h"

namespace desmo::cli {

/// A motion to be shown, as far as it was solved.
struct ShownMotion {
  const Scene& scene;
  const DisplayUnits& units;  ///< units of the numbers that people read
  const Model& model;
  const Measures& measures;
  const MotionRecorder& recording;
  const CheckedSummary& summary;
  std::string formulation;
};

/// Characters that a number takes in a page: base64 writes three bytes as four characters, and a
/// number has four bytes.
inline constexpr double text_per_number = 16. / 3;

/// Returns the data as page.html takes them: JSON, with the columns of numbers one after the other
/// as base64 of floats of 32 bits, one for each recorded instant. All numbers are in motion.units.
/// A column stores each number's distance from the column's value nearest to 0, with seven digits.
/// Columns of the scene's request are plotted; where it asks for everything, those of relative
/// coordinates and points. In either case as many are plotted as fit.
std::string page_data(const ShownMotion& motion);

}  // namespace desmo::cli
