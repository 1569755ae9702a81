// Finds how far the crank of a slider-crank turns, as its file has it and with a rod that is too
// short for a full turn: range SCENE.json
#include <desmo/files.h>
#include <desmo/formulation.h>
#include <desmo/model.h>
#include <desmo/range.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace {

/// Returns the range of the first driver, from where it is at the start of the motion.
desmo::DriverRange range_of(const desmo::Scene& scene, const desmo::Model& model) {
  const auto formulation =
      desmo::make_formulation(desmo::find_variant("global_automatic_klu"), model);
  if (!formulation->assemble(scene.grid.start, desmo::Level::position).ok())
    throw std::runtime_error("the motion has no start");
  return desmo::find_range(model, formulation->q(), 0);
}

int find_ranges(const char* scene_file) {
  desmo::Scene scene = desmo::read_scene(scene_file);
  const desmo::DriverRange whole = range_of(scene, desmo::make_model(scene));
  std::printf("the crank turns from %g to %g rad\n", whole.down.value, whole.up.value);
  if (whole.up.stop != desmo::RangeStop::full_turn || whole.up.turns != 1) return 1;

  for (auto& point : scene.mechanism.points)
    if (point.name == "C") point.position[0] = 0.08;  // a rod of 30 mm on a crank of 50 mm
  const desmo::Model model = desmo::make_model(scene);
  const desmo::DriverRange range = range_of(scene, model);
  std::printf("with a shorter rod from %g to %g rad, where it locks", range.down.value,
              range.up.value);
  for (const desmo::GroupId g : range.up.groups)
    for (const auto& body : model.groups[g].bodies) std::printf(" %s", body.c_str());
  std::printf("\n");
  const double lock = std::asin(0.03 / 0.05);  // the rod is square to the slide
  const bool is_right = range.up.stop == desmo::RangeStop::dead_point &&
                        range.down.stop == desmo::RangeStop::dead_point &&
                        std::abs(range.up.value - lock) < 1e-9 &&
                        std::abs(range.down.value + lock) < 1e-9 && range.change_points.empty();
  return is_right && range.up.groups.size() == 1 ? 0 : 1;
}

}  // namespace

int main(int arguments, char** argument) {
  if (arguments != 2) return 64;
  try {
    return find_ranges(argument[1]);
  } catch (const std::exception& error) {  // what a file says, or a start without a position
    std::fprintf(stderr, "%s\n", error.what());
    return 65;
  }
}
