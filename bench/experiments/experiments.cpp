#include "bench/experiments/experiments.h"

namespace desmo::bench {

std::span<const Experiment> all_experiments() {
  static constexpr Experiment all[] = {
      {"paper", "CPU time of every case, size and formulation: the paper's Tables 1 and 2",
       run_paper},
      {"accuracy", "Time against error of formulations and their settings", run_accuracy},
      {"size", "How time grows with the size of a mechanism", run_size},
      {"instructions", "Instructions a step, counted by callgrind", run_instructions},
      {"extremes", "Every formulation where most go wrong", run_extremes},
  };
  return all;
}

}  // namespace desmo::bench
