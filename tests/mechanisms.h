#pragma once

#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "formulations/modelling/modelling.h"

namespace desmo {

/// Return models of the suite's cases.
inline Model four_bar_model(int dyads) { return make_model(four_bar(dyads)); }
inline Model truck_model(int axles) { return make_model(truck_suspension(axles)); }

/// Returns the scenes of all mechanisms of the library.
inline std::vector<Scene> library_scenes() {
  std::vector<Scene> all;
  for (const LibraryMechanism& l : library()) all.push_back(library_scene(l.name));
  return all;
}

/// Returns all models with the time grids of their motions: both cases with three units, and every
/// mechanism of the library with its scene.
inline std::vector<std::pair<Model, TimeGrid>> every_motion() {
  std::vector<std::pair<Model, TimeGrid>> all;
  for (const Case& c : cases()) all.emplace_back(make_model(c.with_units(3)), time_grid(3, 0.01));
  for (const Scene& scene : library_scenes()) all.emplace_back(make_model(scene), scene.grid);
  return all;
}

}  // namespace desmo
