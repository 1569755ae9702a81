#pragma once

#include <string>

#include "formulations/algebra/absence.h"

namespace desmo {

/// The double-precision entries of HSL's MA27, as its specification describes them: by reference,
/// matrices as entries of one triangle in any order, rows and columns counted from 1.
struct Ma27Routines {
  /// MA27ID: defaults of ICNTL (30) and CNTL (5).
  void (*set_defaults)(int* icntl, double* cntl);
  /// MA27AD: an order of pivots (IKEEP, 3N, and NSTEPS; IFLAG 0: of its own choice), how much
  /// memory the factors take (INFO, 20) and how many operations (OPS); IW1: 2N.
  void (*analyse)(const int* n, const int* nz, const int* irn, const int* icn, int* iw,
                  const int* liw, int* ikeep, int* iw1, int* nsteps, int* iflag, const int* icntl,
                  const double* cntl, int* info, double* ops);
  /// MA27BD: overwrites the values in A by the factors, which are in A and IW; IW1: N.
  void (*factorise)(const int* n, const int* nz, const int* irn, const int* icn, double* a,
                    const int* la, int* iw, const int* liw, const int* ikeep, const int* nsteps,
                    int* maxfrt, int* iw1, const int* icntl, const double* cntl, int* info);
  /// MA27CD: overwrites RHS by the solution; W: MAXFRT, IW1: NSTEPS.
  void (*solve)(const int* n, const double* a, const int* la, const int* iw, const int* liw,
                double* w, const int* maxfrt, double* rhs, int* iw1, const int* nsteps,
                const int* icntl, int* info);
};

/// The user's own library of HSL routines.
struct CoinHsl {
  Ma27Routines ma27{};  ///< all of them, or (with a reason of absence) none to be called
  std::string version;  ///< the library's file, and what it calls its version
  Absence absence;
};

/// Names the file of the library, where the loader does not find it.
inline constexpr const char* coinhsl_variable = "DESMO_LIBCOINHSL";

/// Loads that file, or what the loader finds by the library's usual names where it is null or
/// empty. What is loaded stays for as long as the program runs.
CoinHsl load_coinhsl(const char* file);

/// As the environment of the program says, loaded once.
const CoinHsl& coinhsl();

}  // namespace desmo
