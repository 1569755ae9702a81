#pragma once

#include <span>
#include <type_traits>

#include "formulations/equations/kernel_library.h"

namespace desmo {

// Kernels that are generated when desmo is built. A function returns those of one set of mechanisms
// and, for batches, of one number of lanes. A type of group that occurs in the cases and in the
// library has its kernels in the set of the cases. Kernels for 8 lanes exist only in builds with
// DESMO_WIDE_LANES. The functions return references and do nothing else: they may be compiled for
// instructions that the caller's processor lacks.
using FourLanes = std::integral_constant<int, 4>;
using EightLanes = std::integral_constant<int, 8>;

/// Return the kernels of the paper's two cases and of the requests in cases/requests.
const KernelLibrary& cases_kernels();
const KernelLibrary& cases_explicit_kernels();
const KernelLibrary& cases_lane_kernels(FourLanes);
const KernelLibrary& cases_lane_kernels(EightLanes);

/// Return the kernels of the mechanisms of cases/library.
const KernelLibrary& library_kernels();
const KernelLibrary& library_explicit_kernels();
const KernelLibrary& library_lane_kernels(FourLanes);
const KernelLibrary& library_lane_kernels(EightLanes);

/// Return the kernels of the paper's two cases in reference-point and in relative coordinates, for
/// programs that link desmo_coordinates_kernels. They are in no other table.
const KernelLibrary& coordinates_kernels();
const KernelLibrary& coordinates_explicit_kernels();

/// Returns the kernels that the program was linked with: of both natural sets
/// (DESMO_LIBRARY_KERNELS) or of the cases alone.
std::span<const KernelLibrary> built_in_kernels();

}  // namespace desmo
