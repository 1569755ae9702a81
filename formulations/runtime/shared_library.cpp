#include "formulations/runtime/shared_library.h"

#include <dlfcn.h>

#include "cases/mechanism/names.h"
#include "formulations/runtime/unavailable.h"

namespace desmo::load {

std::shared_ptr<const KernelLibrary> load_library(const std::filesystem::path& file) {
  const auto refuse = [] {
    const char* const reason = ::dlerror();
    throw Unavailable("compiled kernels cannot be loaded: " +
                      printable(reason ? reason : "no reason given", 300));
  };
  const std::shared_ptr<void> handle(::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL), [](void* h) {
    if (h) ::dlclose(h);
  });
  if (!handle) refuse();
  const void* const symbol = ::dlsym(handle.get(), "desmo_kernels");
  if (!symbol) refuse();
  return {handle, static_cast<const KernelLibrary*>(symbol)};
}

}  // namespace desmo::load
