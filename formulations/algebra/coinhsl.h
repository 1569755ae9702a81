#pragma once

#include <string>

#include "formulations/algebra/backend.h"

namespace desmo {

/// Double-precision entries of HSL's MA27, as its specification describes them. Arguments are
/// passed by reference; matrices as entries of one triangle in any order, indices counted from 1.
struct Ma27Routines {
  /// MA27ID: sets the defaults of ICNTL (30) and CNTL (5).
  void (*set_defaults)(int* icntl, double* cntl);
  /// MA27AD: finds an order of pivots (IKEEP (3 N), NSTEPS), of its own choice where IFLAG is 0.
  /// Estimates the memory of the factors (INFO (20)) and the operations (OPS). IW1: (2 N).
  void (*analyse)(const int* n, const int* nz, const int* irn, const int* icn, int* iw,
                  const int* liw, int* ikeep, int* iw1, int* nsteps, int* iflag, const int* icntl,
                  const double* cntl, int* info, double* ops);
  /// MA27BD: overwrites the values in A with the factors, which are in A and IW. IW1: (N).
  void (*factorise)(const int* n, const int* nz, const int* irn, const int* icn, double* a,
                    const int* la, int* iw, const int* liw, const int* ikeep, const int* nsteps,
                    int* maxfrt, int* iw1, const int* icntl, const double* cntl, int* info);
  /// MA27CD: overwrites RHS with the solution. W: (MAXFRT), IW1: (NSTEPS).
  void (*solve)(const int* n, const double* a, const int* la, const int* iw, const int* liw,
                double* w, const int* maxfrt, double* rhs, int* iw1, const int* nsteps,
                const int* icntl, int* info);
};

/// Library of HSL routines that the user provides.
struct CoinHsl {
  Ma27Routines ma27{};  ///< all routines; null where the library is absent
  std::string version;  ///< the library's file name and its own version
  Absence absence;
};

/// Environment variable with the library's file, for where the loader does not find it.
inline constexpr const char* coinhsl_variable = "DESMO_LIBCOINHSL";

/// Loads a library: that file or, when it is null or empty, one of the library's usual names. It
/// stays loaded until the program ends.
CoinHsl load_coinhsl(const char* file);

/// Returns load_coinhsl() of what the environment names, loaded once.
const CoinHsl& coinhsl();

}  // namespace desmo
