#include <algorithm>
#include <array>
#include <string>

#include "tests/fuzz/mutations.h"

namespace desmo::fuzz {
namespace {

bool is_scene(const Tree& root) { return root.find("mechanism") != nullptr; }

Tree value(Random& random) {
  return random.one_in(6) ? scalar(std::string(extreme_number(random)))
                          : scalar(3 * random.around_zero());
}

Tree values(Random& random, std::size_t count) {
  Tree result = list({});
  for (; count > 0; --count) result.children.push_back(value(random));
  return result;
}

Tree ascending(Random& random, std::size_t count) {
  Tree result = list({});
  double t = random.one_in(2) ? 0 : -1;
  for (; count > 0; --count, t += random.one_in(12) ? 1e-9 : 1 + random.around_zero())
    result.children.push_back(scalar(t));
  return result;
}

Tree any_motion(Random& random) {
  Tree motion = object();
  switch (random.below(4)) {
    case 0:
      put(motion["type"], string_tree("constant"));
      put(motion["value"], value(random));
      break;
    case 1:
      put(motion["type"], string_tree("polynomial"));
      put(motion["coefficients"],
          values(random, random.one_in(10) ? 95 + random.below(10) : random.below(6)));
      break;
    case 2: {
      put(motion["type"], string_tree("harmonic"));
      if (random.one_in(2)) put(motion["mean"], value(random));
      Tree terms = list({});
      for (std::size_t i = random.below(4); i > 0; --i) {
        Tree term = object();
        put(term["amplitude"], value(random));
        put(term["frequency"], value(random));
        if (random.one_in(2)) put(term["phase"], value(random));
        terms.children.push_back(std::move(term));
      }
      put(motion["terms"], std::move(terms));
      break;
    }
    default: {
      static constexpr std::array<std::string_view, 4> ends = {"natural", "clamped", "periodic",
                                                               "free"};
      const std::size_t count = random.below(8);
      put(motion["type"], string_tree("table"));
      put(motion["times"], ascending(random, count));
      Tree z = values(random, count);
      if (count > 0 && random.one_in(3)) z.children.back() = z.children.front();
      put(motion["values"], std::move(z));
      if (random.one_in(2)) put(motion["ends"], string_tree(random.pick(ends)));
      break;
    }
  }
  return motion;
}

void change_motion(Tree& root, Random& random) {
  if (!is_scene(root)) return;
  Tree& motions = root["motion"];
  if (motions.kind == Tree::Kind::object && !motions.children.empty())
    put(random.pick(motions.children), any_motion(random));
}

// Every driver has a motion, whatever was done to the drivers.
void move_all(Tree& root, Random& random) {
  Tree* const mechanism = mechanism_in(root);
  if (!is_scene(root) || !mechanism || !mechanism->find("drivers")) return;
  Tree motions = object();
  for (const Tree& driver : mechanism->find("drivers")->children)
    if (driver.is_text()) put(motions[driver.name()], any_motion(random));
  put(root["motion"], std::move(motions));
}

void change_time(Tree& root, Random& random) {
  if (!is_scene(root)) return;
  Tree time = object();
  if (random.one_in(2)) put(time["start"], value(random));
  const double step = random.one_in(3) ? 1e-6 : 0.01;
  const auto start = time.find("start") ? time.find("start")->number() : 0;
  put(time["end"], random.one_in(4) ? value(random) : scalar(start + 100 * step));
  put(time["step"], random.one_in(4) ? value(random) : scalar(step));
  put(root["time"], std::move(time));
}

void change_request(Tree& root, Random& random) {
  if (!is_scene(root)) return;
  static constexpr std::array<std::string_view, 6> kinds = {"points",    "vectors", "angles",
                                                            "distances", "bodies",  "everything"};
  static constexpr std::array<std::string_view, 4> asked = {"position", "velocity", "acceleration",
                                                            "jerk"};
  const Tree* const mechanism = mechanism_in(root);
  Tree request = list({});
  for (std::size_t i = 1 + random.below(3); i > 0; --i) {
    Tree part = object();
    for (std::size_t j = 1 + random.below(2); j > 0; --j) {
      const std::string_view kind = random.pick(kinds);
      if (kind == "everything") {
        put(part[kind], scalar(random.one_in(8) ? "false" : "true"));
        continue;
      }
      std::vector<std::string> names;
      if (mechanism)
        names =
            names_under(*mechanism, kind == "angles" || kind == "distances" ? "coordinates" : kind);
      names.push_back("*");
      Tree patterns = list({});
      for (std::size_t k = random.one_in(20) ? 105 : 1 + random.below(3); k > 0; --k) {
        std::string name = random.pick(names);
        if (random.one_in(4)) name = name.substr(0, name.size() / 2) + "*";
        patterns.children.push_back(string_tree(name));
      }
      put(part[kind], std::move(patterns));
    }
    if (!random.one_in(3))
      put(part["level"], string_tree(asked[random.below(random.one_in(10) ? 4 : 3)]));
    request.children.push_back(std::move(part));
  }
  put(root["request"], std::move(request));
}

void ask_for_everything(Tree& root, Random&) {
  if (is_scene(root))
    std::erase_if(root.children, [](const Tree& member) { return member.key == "request"; });
}

void change_tolerance(Tree& root, Random& random) {
  if (is_scene(root)) put(root["tolerance"], scalar(std::string(extreme_number(random))));
}

void change_formulation(Tree& root, Random& random) {
  if (!is_scene(root)) return;
  static constexpr std::array<std::string_view, 8> ids = {"group_symbolic_inlined",
                                                          "block_automatic_klu",
                                                          "global_automatic_eigen",
                                                          "group",
                                                          "a_b_c",
                                                          "global_automatic_klu/lanes:8",
                                                          "*",
                                                          "-"};
  put(root["formulation"], string_tree(random.pick(ids)));
}

void change_mechanism(Tree& root, Random& random) {
  if (!is_scene(root)) return;
  static constexpr std::array<std::string_view, 10> others = {
      R"({"library": "rssr"})",
      R"({"library": "slider_crank"})",
      R"({"library": "none"})",
      R"({"generator": "four_bar", "dyads": 3})",
      R"({"generator": "four_bar"})",
      R"({"generator": "truck_suspension", "axles": 1})",
      R"("bars.json")",
      R"("missing.json")",
      R"("..")",
      R"("bars.json\u0000")"};
  put(root["mechanism"], scalar(std::string(random.pick(others))));
  if (!random.one_in(3))
    std::erase_if(root.children, [](const Tree& member) { return member.key == "motion"; });
}

constexpr TreeMutation all_scene_mutations[] = {
    change_motion,      move_all,         change_time,        change_request,  change_request,
    ask_for_everything, change_tolerance, change_formulation, change_mechanism};

}  // namespace

void give_motion_to_drivers(Tree& root) {
  const Tree* const mechanism = is_scene(root) ? mechanism_in(root) : nullptr;
  const Tree* const drivers = mechanism ? mechanism->find("drivers") : nullptr;
  if (!drivers || drivers->children.empty()) return;
  Tree motions = object();
  for (const Tree& driver : drivers->children) {
    if (!driver.is_text() || motions.find(driver.name())) continue;
    const Tree* const given = root.find("motion");
    const Tree* const own = given ? given->find(driver.name()) : nullptr;
    put(motions[driver.name()], own ? *own : scalar(R"({"type": "constant", "value": 0.7})"));
  }
  put(root["motion"], std::move(motions));
}

std::span<const TreeMutation> scene_mutations() { return all_scene_mutations; }

}  // namespace desmo::fuzz
