#include "formulations/load/own_kernels.h"

#include <exception>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "formulations/digest.h"
#include "formulations/generate/library_source.h"
#include "formulations/load/cache.h"
#include "formulations/load/compiler.h"
#include "formulations/load/motion_samples.h"
#include "formulations/load/shared_library.h"
#include "formulations/load/unavailable.h"
#include "formulations/part_type.h"

namespace desmo::load {

namespace {

using generate::LibraryContents, generate::SampledType;
using Clock = std::chrono::steady_clock;

/// The work of a generator and a compiler grows faster than the size of a part.
constexpr std::size_t most_unknowns = 100;
/// More than these tell no more of a type.
constexpr std::size_t enough_samples = 48;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<PartDefinition> parts_without_code(const Mechanism& m, const Variant& v,
                                               LibraryContents contents, const KernelTable& table) {
  std::vector<PartDefinition> result;
  if (v.evaluation == Evaluation::automatic) return result;
  for (const PartDefinition& part : make_partition(m, v.partition))
    for (PartDefinition& group : split_by_group(m, part)) {
      const std::string fingerprint = describe_type(m, group).fingerprint;
      if (!table.find_kernel(fingerprint) ||
          (contents.explicit_order && !table.find_explicit_kernel(fingerprint)) ||
          (contents.lanes && !table.find_lane_kernel(fingerprint)))
        result.push_back(std::move(group));
    }
  return result;
}

/// The types of the parts, named by numbers alone.
std::vector<SampledType> sample_types(const std::vector<PartDefinition>& parts, const Mechanism& m,
                                      const TimeGrid& grid, OwnKernels& told) {
  const std::vector<std::vector<double>> states = sample_motion(m, grid);
  if (states.empty()) throw Unavailable("the mechanism cannot be assembled");
  std::vector<SampledType> types;
  for (const PartDefinition& part : parts) {
    SampledType& type = generate::add_part(m, part, states, types);
    if (type.name.empty()) {
      type.name = "type_" + std::to_string(types.size() - 1);
      type.type = generate::without_names(std::move(type.type));
      told.types.push_back(
          {m.groups[part.groups.front()].name, static_cast<int>(part.unknowns.size())});
    }
    if (type.samples.size() > enough_samples) type.samples.resize(enough_samples);
    ++told.types[&type - types.data()].parts;
  }
  return types;
}

std::string_view bytes(const std::vector<double>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

/// Of all that decides what a library's source is.
std::string digest_of(const std::vector<SampledType>& types, LibraryContents contents) {
  Digest digest;
  digest.add(generate::generator_digest());
  digest.add(contents.lanes ? "lanes" : contents.explicit_order ? "explicit" : "inlined");
  for (const auto& [name, type, samples] : types) {
    digest.add("\n" + type.fingerprint + "\n" + std::to_string(samples.size()) + "\n");
    for (const generate::SamplePoint& s : samples) digest.add(bytes(s.q)).add(bytes(s.constants));
  }
  return digest.hex();
}

/// The library made of the types' code, from the cache or by the compiler.
std::shared_ptr<const KernelLibrary> make_library(const std::vector<SampledType>& types,
                                                  LibraryContents contents,
                                                  std::chrono::milliseconds compile_time,
                                                  OwnKernels& told) {
  const Compiler compiler = Compiler::find();
  told.compiler = compiler.file() + " (" + compiler.version() + ")";
  const Cache cache = Cache::open();
  told.folder = cache.folder().string();

  const std::string source_name = digest_of(types, contents) + ".cpp";
  std::optional<std::string> source = cache.read(source_name);
  if (!source) {
    source = generate::library_source(types, contents);
    cache.write(source_name, *source);
  }
  if (source->empty()) throw Unavailable("the generator has no code for parts like these");

  const std::string library_name = Digest().add(compiler.identity()).add(*source).hex() + ".so";
  if (!cache.read(library_name)) {
    const Clock::time_point start = Clock::now();
    cache.write(library_name, cache.content_made_by([&](const std::string& name) {
      compiler.compile(source_name, name, cache.descriptor(), compile_time);
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

OwnKernels add_own_kernels(KernelTable& table, const Variant& v, const Settings& settings,
                           const Mechanism& m, const TimeGrid& grid,
                           std::chrono::milliseconds compile_time) {
  OwnKernels told;
  const Clock::time_point start = Clock::now();
  const LibraryContents contents{v.explicit_order, settings.lanes > 1};
  std::vector<PartDefinition> parts = parts_without_code(m, v, contents, table);
  told.parts_too_large = static_cast<int>(std::erase_if(
      parts, [](const PartDefinition& part) { return part.unknowns.size() > most_unknowns; }));
  if (parts.empty()) return told;
  try {
    const std::vector<SampledType> types = sample_types(parts, m, grid, told);
    table.add(make_library(types, contents, compile_time, told));
  } catch (const std::exception& error) {
    told.problem = error.what();
  }
  told.seconds = seconds_since(start);
  return told;
}

}  // namespace desmo::load
