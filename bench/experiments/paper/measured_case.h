#pragma once

#include <memory>
#include <string>
#include <utility>

#include "bench/experiments/paper/options.h"
#include "bench/kit/problem.h"
#include "cases/generators/cases.h"
#include "cases/mechanism/scene.h"

namespace desmo::paper {

/// The motion of a whole mechanism: of a case at one size, or of a user's scene. Shared by its
/// candidates.
struct MeasuredCase : bench::Problem {
  explicit MeasuredCase(Scene described) : scene(std::move(described)) {}

  const Scene scene;         ///< the whole mechanism, which peers are made of
  bool is_profiled = false;  ///< whether a record shows its times by phase
};

/// Makes a case at one size.
std::shared_ptr<MeasuredCase> measured_case(const Case& definition, int coordinates,
                                            const Options& options);

/// Reads a user's scene. Its formulation, tolerance and request are ignored. Its <case> is the
/// file's name without its endings, with "_" for all characters but letters, digits and "-".
/// Differences from the reference are relative (Problem::is_relative). Code that a formulation
/// needs and the program lacks is generated when it is first asked for; a formulation for which
/// there is none is not to be run.
///
/// Throws UnreadableFile and InputError, naming the file, for one that cannot be read or says
/// something wrong. Throws std::invalid_argument where its name is that of a case of the suite.
std::shared_ptr<MeasuredCase> measured_scene(const std::string& file, const Options& options);

}  // namespace desmo::paper
