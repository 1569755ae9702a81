#include "formulations/runtime/own_kernels.h"

#include <dlfcn.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

#include "cases/mechanism/names.h"
#include "formulations/codegen/emit/library_source.h"
#include "formulations/equations/lane_kernel.h"
#include "formulations/runtime/cache.h"
#include "formulations/runtime/compiler.h"
#include "formulations/runtime/digest.h"
#include "formulations/runtime/unavailable.h"
#include "formulations/runtime/wanted_types.h"

namespace desmo::load {

namespace {

using generate::LibraryContents, generate::SampledType;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Loads a compiled library. It stays in memory as long as the pointer or a copy of it exists.
/// Throws Unavailable with the system's reason.
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

/// Returns the library of the types' code, from the cache or from the compiler. told: receives the
/// compiler, the folder and the compilation time.
std::shared_ptr<const KernelLibrary> make_library(const std::vector<SampledType>& types,
                                                  LibraryContents contents,
                                                  std::chrono::milliseconds compile_time,
                                                  GenerationOutcome& told) {
  const Compiler compiler = Compiler::find(contents.lanes);
  told.compiler = compiler.file() + " (" + compiler.version() + ")";
  const Cache cache = Cache::open();
  told.folder = cache.folder().string();

  const std::string source = generate::library_source(types, contents);
  if (source.empty()) throw Unavailable("the generator has no code for parts like these");
  const std::string name = Digest().add(compiler.identity()).add(source).hex();
  const std::string library_name = name + ".so";
  if (!cache.read(library_name)) {
    const Clock::time_point start = Clock::now();
    const std::string source_name = name + ".cpp";
    cache.write(source_name, source);
    cache.write(library_name, cache.content_made_by([&](const std::string& made) {
      compiler.compile(source_name, made, cache.descriptor(), compile_time);
    }));
    told.seconds_compiling = seconds_since(start);
    told.compiled = true;
  }
  try {
    return load_library(cache.folder() / library_name);
  } catch (const Unavailable&) {
    cache.remove(library_name);
    throw;
  }
}

}  // namespace

GenerationOutcome add_generated_code(KernelTable& table, const Variant& v, const Settings& settings,
                                     const Model& m, const TimeGrid& grid,
                                     std::chrono::milliseconds compile_time) {
  GenerationOutcome told;
  const Clock::time_point start = Clock::now();
  const int lanes = std::max(settings.lanes, settings.segments);
  const LibraryContents contents{v.is_explicit(), has_lanes(lanes) ? lanes : 1};
  try {
    const std::vector<SampledType> types = wanted_types(v, contents, m, grid, table, told);
    if (!types.empty()) table.add(make_library(types, contents, compile_time, told));
  } catch (const std::exception& error) {
    told.problem = error.what();
  }
  told.seconds = seconds_since(start);
  return told;
}

}  // namespace desmo::load

namespace desmo {

GeneratedCode generate_code(const Variant& variant, const Settings& settings, const Model& model,
                            const TimeGrid& grid, std::chrono::milliseconds compile_time) {
  const auto table = std::make_shared<KernelTable>();
  return {load::add_generated_code(*table, variant, settings, model, grid, compile_time), table};
}

}  // namespace desmo
