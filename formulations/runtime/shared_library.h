#pragma once

#include <filesystem>
#include <memory>

#include "formulations/equations/kernel_library.h"

namespace desmo::load {

/// A library of kernels that was compiled before, in memory as long as the pointer or a copy of it
/// lives. Throws Unavailable with the reason of the system.
std::shared_ptr<const KernelLibrary> load_library(const std::filesystem::path& file);

}  // namespace desmo::load
