#include "bench/kit/record/environment.h"

#include <benchmark/benchmark.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "bench/kit/record/record.h"
#include "commit.h"
#include "formulations/algebra/blas.h"
#include "formulations/runtime/digest.h"
#include "formulations/variants.h"

namespace desmo::bench {

using Json = nlohmann::ordered_json;

namespace {

/// Returns the properties of the first processor, by their names in /proc/cpuinfo.
std::map<std::string, std::string> processor() {
  std::map<std::string, std::string> found;
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line) && !line.empty();)
    if (const auto colon = line.find(": "); colon != std::string::npos)
      found[line.substr(0, line.find_first_of("\t:"))] = line.substr(colon + 2);
  return found;
}

std::string first_line(const char* path) {
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) && !line.empty() ? line : "unknown";
}

/// Returns whether turbo is "on" or "off", as the driver intel_pstate says it or a driver for other
/// processors; "unknown" where none says it.
std::string turbo() {
  const std::string off = first_line("/sys/devices/system/cpu/intel_pstate/no_turbo");
  const std::string on = first_line("/sys/devices/system/cpu/cpufreq/boost");
  if (off == "0" || on == "1") return "on";
  if (off == "1" || on == "0") return "off";
  return "unknown";
}

std::vector<std::string> caches(const benchmark::CPUInfo& info) {
  std::vector<std::string> found;
  const auto add = [&](int level, const std::string& type, long size, const std::string& sharing) {
    if (size > 0)
      found.push_back("L" + std::to_string(level) + " " + type + " " + std::to_string(size / 1024) +
                      " KiB" + sharing);
  };
  for (const auto& c : info.caches)
    add(c.level, c.type, c.size, ", shared by " + std::to_string(c.num_sharing));
  if (!found.empty()) return found;
  // Some virtual machines list none. The C library asks the processor instead. Its size of the
  // third level is left out: all cores of a processor share that cache.
  add(1, "Data", sysconf(_SC_LEVEL1_DCACHE_SIZE), {});
  add(1, "Instruction", sysconf(_SC_LEVEL1_ICACHE_SIZE), {});
  add(2, "Unified", sysconf(_SC_LEVEL2_CACHE_SIZE), {});
  return found;
}

/// Adds the name of a shared object that was loaded from a file. Leaves out the program itself,
/// which has no name here, and what the kernel supplies. A callback of dl_iterate_phdr().
int collect(dl_phdr_info* object, std::size_t, void* names) {
  const std::string_view path = object->dlpi_name;
  if (path.find('/') != path.npos)
    static_cast<std::vector<std::string>*>(names)->emplace_back(path.substr(path.rfind('/') + 1));
  return 0;
}

Json machine_json(const Run& run) {
  const benchmark::CPUInfo& info = benchmark::CPUInfo::Get();
  return {{"cpu", processor_name()},
          {"cores", info.num_cpus},
          {"caches", caches(info)},
          {"kernel",
           first_line("/proc/sys/kernel/ostype") + " " + first_line("/proc/sys/kernel/osrelease")},
          {"governor", first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")},
          {"turbo", turbo()},
          {"load_before", run.load_before},
          {"load_after", run.load_after}};
}

Json build_json() {
  const std::vector<std::string> libraries = shared_libraries();
  return {{"type", DESMO_BUILD_TYPE},
          {"compiler", DESMO_COMPILER},
          {"flags", DESMO_FLAGS},
          {"link",
           {{"type", libraries.empty() ? "static" : "dynamic"},
            {"flags", DESMO_LINK_FLAGS},
            {"libraries", libraries}}},
          {"binary", binary_digest()}};
}

Json settings_json(const TimeGrid& grid) {
  const Settings settings;
  return {{"tolerance", settings.tolerance},
          {"max_iterations", settings.max_iterations},
          {"guess", "previous position"},
          {"step_seconds", grid.step},
          {"duration_seconds", (grid.instants - 1) * grid.step},
          {"instants", grid.instants},
          {"allowed", per_level_json(allowed_difference)}};
}

}  // namespace

Json environment_json(const Run& run, const TimeGrid& grid) {
  const BlasEnvironment blas = blas_environment();
  Json libraries = Json::object();
  for (const auto& [name, version] : library_versions()) libraries[name] = version;
  return {{"date", run.date},
          {"commit", DESMO_COMMIT},
          {"dirty", DESMO_DIRTY},
          {"command", run.command},
          {"machine", machine_json(run)},
          {"build", build_json()},
          {"libraries", libraries},
          {"blas", {{"core", blas.core}, {"threads", blas.threads}}},
          {"settings", settings_json(grid)}};
}

// Virtual machines may give different processors one name; family, model and stepping tell them
// apart.
std::string processor_name() {
  auto p = processor();
  const std::string name = p.contains("model name") ? p["model name"] : "unknown";
  if (!p.contains("cpu family")) return name;
  return name + " (family " + p["cpu family"] + ", model " + p["model"] + ", stepping " +
         p["stepping"] + ")";
}

std::vector<double> load_averages() {
  double load[3];
  if (getloadavg(load, 3) != 3) return {};
  return {load, load + 3};
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string command_line(int argc, char** argv) {
  std::string command = std::filesystem::path(argv[0]).filename().string();
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  return command;
}

std::string binary_digest() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  if (!file) return "unknown";
  Digest digest;
  std::array<char, 1 << 16> buffer;
  while (file.read(buffer.data(), buffer.size()), file.gcount() > 0)
    digest.add({buffer.data(), static_cast<std::size_t>(file.gcount())});
  return file.bad() ? "unknown" : digest.hex();
}

std::vector<std::string> shared_libraries() {
  std::vector<std::string> libraries;
  dl_iterate_phdr(collect, &libraries);
  std::ranges::sort(libraries);
  return libraries;
}

}  // namespace desmo::bench
