#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "formulations/modelling/model.h"

namespace desmo {

/// The suite's cases as modelled from their descriptions.
inline Mechanism four_bar_mechanism(int dyads) { return make_mechanism(four_bar(dyads)); }
inline Mechanism truck_mechanism(int axles) { return make_mechanism(truck_suspension(axles)); }

/// Both cases with three units, and every mechanism of the library with the motion of its scene.
inline std::vector<std::pair<Mechanism, TimeGrid>> every_motion() {
  std::vector<std::pair<Mechanism, TimeGrid>> all;
  for (const Case& c : cases()) all.emplace_back(make_mechanism(c.describe(3)), time_grid(3, 0.01));
  for (const LibraryMechanism& l : library()) {
    const Scene scene = parse_scene(l.scene, std::string(l.name), {});
    all.emplace_back(make_mechanism(scene), scene.grid);
  }
  return all;
}

}  // namespace desmo
