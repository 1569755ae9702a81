#pragma once

#include <string>

namespace desmo {

/// What OpenBLAS runs on.
struct BlasEnvironment {
  std::string core;  ///< the instruction set its kernels were chosen for
  int threads;
};
BlasEnvironment blas_environment();

/// For the whole process.
void set_blas_threads(int threads);

}  // namespace desmo
