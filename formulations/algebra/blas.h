#pragma once

#include <string>

namespace desmo {

/// Environment of OpenBLAS.
struct BlasEnvironment {
  std::string core;  ///< instruction set that its kernels were chosen for
  int threads;       ///< number that it uses now, see set_blas_threads()
};
/// Returns the environment of this process.
BlasEnvironment blas_environment();

/// Sets the number of OpenBLAS threads for the whole process (see the rule of threads in
/// formulation.h).
void set_blas_threads(int threads);

}  // namespace desmo
