#include "tests/library/solutions.h"

namespace desmo::exact {

const std::map<std::string_view, SolutionAt*>& library_solutions() {
  static const std::map<std::string_view, SolutionAt*> all{
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
