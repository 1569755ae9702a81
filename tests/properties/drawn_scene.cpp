#include "tests/properties/drawn_scene.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cases/io/files.h"
#include "formulations/modelling/measures/measures.h"
#include "formulations/modelling/modelling.h"
#include "tests/properties/scene_kinds.h"

namespace desmo::properties {

namespace {

using Json = nlohmann::ordered_json;

constexpr int max_draws = 60;

constexpr SceneKind kinds[] = {
    {"random", draw_random},       {"aimed", draw_aimed},
    {"requested", draw_requested}, {"far start", draw_far_start},
    {"coupled", draw_coupled},     {"rough", draw_rough},
    {"decimal", draw_decimal},     {"contradicting", draw_contradicting},
    {"typed", draw_typed},
};

std::string scene_text(const Draft& draft) {
  Json motions;
  std::size_t k = 0;
  for (const Mechanism::Coordinate& c : draft.mechanism.coordinates)
    if (c.driven) motions[c.name] = Json::parse(draft.motions[k++]);
  Json j = {{"format", "desmo-scene"},
            {"version", 2},
            {"name", draft.family + ", " + draft.aim},
            {"mechanism", Json::parse(write_mechanism(draft.mechanism))},
            {"units",
             {{"length", draft.mechanism.length_unit}, {"angle", draft.degrees ? "deg" : "rad"}}},
            {"motion", std::move(motions)},
            {"time",
             {{"start", draft.grid.start},
              {"end", draft.grid.time(draft.grid.instants - 1)},
              {"step", draft.grid.step}}}};
  if (!draft.request.empty()) j["request"] = Json::parse(draft.request);
  return j.dump(1) + '\n';
}

}  // namespace

std::span<const SceneKind> scene_kinds() { return kinds; }

void read_drawn_scene(DrawnScene& s) {
  s.scene = parse_scene(s.text, "drawn scene", ".");
  s.whole = make_model(s.scene);
  s.plan = make_plan(s.whole, outputs_of(s.scene, s.whole));
  if (s.plan.model.coordinates() == 0) throw std::runtime_error("only what is fixed is requested");
  s.truth = true_answers(s.plan.model, s.scene.grid);
}

DrawnScene draw_scene(std::uint64_t seed, int number) {
  const SceneKind& kind = kinds[static_cast<std::size_t>(number) % std::size(kinds)];
  Random r(seed * 1'000'003 + number);
  std::string last;
  for (int i = 0; i < max_draws; ++i) {
    Random one(r.bits());
    try {
      const Draft draft = kind.draw(one);
      DrawnScene s{.number = number,
                   .kind = std::string(kind.name),
                   .family = draft.family,
                   .aim = draft.aim,
                   .text = scene_text(draft),
                   .mode = draft.mode};
      read_drawn_scene(s);
      return s;
    } catch (const std::exception& error) {  // dimensions that do not close, a start out of reach
      last = error.what();
    }
  }
  throw std::runtime_error("scene " + std::to_string(number) +
                           ": no draw serves; the last: " + last);
}

}  // namespace desmo::properties
