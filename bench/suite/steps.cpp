// desmo_steps CASE COORDINATES ID STEPS: assembles and takes so many steps of 10 ms, nothing
// else. Two runs with different numbers of steps tell what a step costs in instructions.

#include <charconv>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string_view>

#include "bench/suite/delivery.h"
#include "cases/cases.h"
#include "formulations/modelling/model.h"
#include "formulations/variants.h"

namespace {

int whole(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0 ||
      value > 1'000'000'000)
    throw std::invalid_argument("'" + std::string(text) + "' is not a whole number up to 1e9");
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace desmo;
  if (argc != 5) {
    std::cerr << "usage: desmo_steps CASE COORDINATES ID STEPS\n";
    return 64;
  }
  try {
    const Mechanism mechanism = make_mechanism(describe(find_case(argv[1]), whole(argv[2])));
    const auto formulation = make_formulation(find_variant(argv[3]), mechanism);
    suite::Delivery sink(mechanism.coordinates());
    const Summary s = formulation->run(TimeGrid{0, 0.01, whole(argv[4]) + 1}, {}, sink);
    if (s.ok()) return 0;
    std::cerr << "desmo_steps: " << describe(s, mechanism) << '\n';
    return 1;
  } catch (const std::exception& e) {
    std::cerr << "desmo_steps: " << e.what() << '\n';
    return 64;
  }
}
