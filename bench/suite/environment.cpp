#include "bench/suite/environment.h"

#include <benchmark/benchmark.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>

#include "commit.h"

namespace desmo::suite {

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

}  // namespace

Machine this_machine() {
  const benchmark::CPUInfo& info = benchmark::CPUInfo::Get();
  Machine m{processor_name(),
            info.num_cpus,
            {},
            "unknown",
            first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"),
            turbo()};
  for (const auto& c : info.caches)
    m.caches.push_back("L" + std::to_string(c.level) + " " + c.type + " " +
                       std::to_string(c.size / 1024) + " KiB, shared by " +
                       std::to_string(c.num_sharing));
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

}  // namespace desmo::suite
