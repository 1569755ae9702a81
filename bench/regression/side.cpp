#include "bench/regression/side.h"

#include <cstdlib>

#include "formulations/algebra/coinhsl.h"

namespace desmo::regression {

Launch Side::probe(std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), folder + "/desmo_probe");
  return fixed_launch(std::move(arguments));
}

Launch fixed_launch(std::vector<std::string> arguments) {
  Launch launch{
      std::move(arguments),
      {"LC_ALL=C", "LD_BIND_NOW=1", "OPENBLAS_NUM_THREADS=1", "PATH=/usr/local/bin:/usr/bin:/bin"}};
  for (const char* name : {"LD_LIBRARY_PATH", coinhsl_variable})
    if (const char* libraries = std::getenv(name))
      launch.environment.push_back(std::string(name) + "=" + libraries);
  return launch;
}

}  // namespace desmo::regression
