#pragma once

#include <filesystem>
#include <memory>

#include "formulations/equations/kernel_library.h"

namespace desmo::load {

/// Loads a compiled library of kernels. It stays in memory as long as the pointer or a copy of it
/// exists. Throws Unavailable with the system's reason.
std::shared_ptr<const KernelLibrary> load_library(const std::filesystem::path& file);

}  // namespace desmo::load
