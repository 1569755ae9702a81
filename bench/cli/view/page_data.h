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

/// Bytes that a number takes in a page: four, in base64.
inline constexpr double text_per_number = 16. / 3;

/// Returns the data as page.html takes them: JSON, with the columns of numbers one after the other
/// as base64 of floats of 32 bits. It has the first of every `every` recorded instants, and the
/// last ones before gaps and the end. All numbers are in motion.units; columns are rounded to seven
/// digits, relative to their value nearest to 0. The scene's request is plotted or, where it asks
/// for everything, relative coordinates and points; in either case as many as fit.
std::string page_data(const ShownMotion& motion, int every);

}  // namespace desmo::cli
