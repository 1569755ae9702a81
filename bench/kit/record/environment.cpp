#include "bench/kit/record/environment.h"

#include <benchmark/benchmark.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>

#include "commit.h"

namespace desmo::bench {

namespace {

/// What the system says of its first processor, by the names it uses.
std::map<std::string, std::string> processor() {
  std::map<std::string, std::string> found;
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line) && !line.empty();)
    if (const auto colon = line.find(": "); colon != std::string::npos)
      found[line.substr(0, line.find_first_of("\t:"))] = line.substr(colon + 2);
  return found;
}

/// A virtual machine may call different processors by one name: their numbers tell them apart.
std::string processor_name() {
  auto p = processor();
  const std::string name = p.contains("model name") ? p["model name"] : "unknown";
  if (!p.contains("cpu family")) return name;
  return name + " (family " + p["cpu family"] + ", model " + p["model"] + ", stepping " +
         p["stepping"] + ")";
}

std::string first_line(const char* path) {
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) && !line.empty() ? line : "unknown";
}

/// What the driver of Intel's frequencies, or that of the others, says.
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
  // Some virtual machines list none. The C library asks the processor; of the third level, though,
  // it tells what all cores of a processor have together.
  add(1, "Data", sysconf(_SC_LEVEL1_DCACHE_SIZE), {});
  add(1, "Instruction", sysconf(_SC_LEVEL1_ICACHE_SIZE), {});
  add(2, "Unified", sysconf(_SC_LEVEL2_CACHE_SIZE), {});
  return found;
}

}  // namespace

Machine this_machine() {
  const benchmark::CPUInfo& info = benchmark::CPUInfo::Get();
  Machine m{processor_name(),
            info.num_cpus,
            caches(info),
            "unknown",
            first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"),
            turbo()};
  utsname name{};
  if (uname(&name) == 0) m.kernel = std::string(name.sysname) + " " + name.release;
  return m;
}

std::vector<double> load_averages() {
  double load[3];
  if (getloadavg(load, 3) != 3) return {};
  return {load, load + 3};
}

Build this_build() {
  return {DESMO_BUILD_TYPE, DESMO_COMPILER, DESMO_FLAGS, DESMO_COMMIT, DESMO_DIRTY};
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace desmo::bench
