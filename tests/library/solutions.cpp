#include "tests/library/solutions.h"

#include <utility>

namespace desmo::exact {

void Solution::set(Quantity& q, std::size_t i, Jet x) {
  q.position[i] = static_cast<double>(x.v);
  q.velocity[i] = static_cast<double>(x.d);
  q.acceleration[i] = static_cast<double>(x.dd);
}

void Solution::add(std::string name, Jet scalar) {
  Quantity q{1, {}, {}, {}};
  set(q, 0, scalar);
  quantities.emplace(std::move(name), q);
}

std::span<const LibrarySolution> library_solutions() {
  static constexpr LibrarySolution all[] = {
      {"slider_crank", slider_crank},
      {"inverted_slider_crank", inverted_slider_crank},
      {"whitworth", whitworth},
      {"watt_six_bar", watt_six_bar},
      {"stephenson_six_bar", stephenson_six_bar},
      {"jansen_leg", jansen_leg},
      {"andrews", andrews},
      {"rssr", rssr},
      {"stewart", stewart},
      {"delta", delta},
      {"double_wishbone", double_wishbone},
      {"macpherson", macpherson},
      {"truck_axle", truck_axle},
  };
  return all;
}

}  // namespace desmo::exact
