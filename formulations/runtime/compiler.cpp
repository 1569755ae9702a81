#include "formulations/runtime/compiler.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <iterator>
#include <sstream>
#include <system_error>
#include <vector>

#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"
#include "formulations/runtime/descriptor.h"
#include "formulations/runtime/program.h"
#include "formulations/runtime/unavailable.h"

namespace desmo::load {

namespace {

/// Options of the kernels that desmo is built with, and those of a shared library.
constexpr const char* all_flags = DESMO_KERNEL_FLAGS " -w -pipe -fPIC -shared -fvisibility=hidden";
/// Further options for eight lanes. Of several options that name a processor the last one counts.
constexpr const char* more_for_eight_lanes = " -march=x86-64-v4 -mno-red-zone";

constexpr std::chrono::seconds time_for_version{10};
constexpr std::size_t max_shown = 300;  // length of a compiler's error in a message [characters]

bool is_program(const std::string& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
         ::access(file.c_str(), X_OK) == 0;
}

/// Returns the absolute file of a program; empty when there is none. Ignores relative folders of
/// PATH. name: an absolute file, or a name without "/".
std::string locate(const std::string& name) {
  if (name.find('/') != std::string::npos)
    return name.front() == '/' && is_program(name) ? name : "";
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (folder.starts_with('/') && is_program(folder + "/" + name)) return folder + "/" + name;
  return "";
}

std::string locate_any() {
  if (const char* const wanted = std::getenv("CXX"); wanted && *wanted) {
    const std::string file = locate(wanted);
    if (file.empty())
      throw Unavailable("CXX=" + printable(wanted, 200) +
                        ": no such program; name a C++ compiler, or its file from / on, without "
                        "arguments");
    return file;
  }
  for (const char* name : {DESMO_BUILD_COMPILER, "c++"})
    if (std::string file = locate(name); !file.empty()) return file;
  throw Unavailable("no C++ compiler; install one (Debian: apt-get install g++), or set CXX");
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Returns the line of a compiler's output with its first error; without one, the first line.
std::string error_text(const std::string& output) {
  const std::size_t error = output.find("error:");
  const std::size_t line = error == std::string::npos ? 0 : output.rfind('\n', error) + 1;
  return printable(first_line(output.substr(line)), max_shown);
}

ProgramEnd run(const std::string& file, std::vector<std::string> arguments, int folder,
               std::chrono::milliseconds time) {
  arguments.insert(arguments.begin(), file);
  try {
    return run_program(arguments, folder, time);
  } catch (const std::system_error& error) {
    throw Unavailable(printable(file, 200) + ": cannot be started (" + error.code().message() +
                      "); set CXX to a C++ compiler");
  }
}

}  // namespace

Compiler Compiler::find(int lanes) {
  Compiler compiler;
  compiler.flags_ = all_flags;
  if (lanes == 8) compiler.flags_ += more_for_eight_lanes;
  compiler.file_ = locate_any();
  const Descriptor root(::open("/", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const ProgramEnd ending = run(compiler.file_, {"--version"}, root.number(), time_for_version);
  if (!ending.good || ending.output.empty())
    throw Unavailable(printable(compiler.file_, 200) +
                      ": does not say its version; set CXX to a C++ compiler");
  compiler.version_ = ending.output;
  return compiler;
}

std::string Compiler::version() const { return printable(first_line(version_), 100); }

std::string Compiler::identity() const { return file_ + "\n" + version_ + "\n" + flags_; }

void Compiler::compile(const std::string& source, const std::string& library, int folder,
                       std::chrono::milliseconds time) const {
  std::istringstream words(flags_);
  std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
  arguments.insert(arguments.end(), {"-o", library, source});
  const ProgramEnd ending = run(file_, arguments, folder, time);
  if (ending.late)
    throw Unavailable(printable(file_, 200) +
                      formatted(": ended after %g s", std::chrono::duration<double>(time).count()) +
                      "; allow it more time, or choose a formulation by blocks");
  if (!ending.good)
    throw Unavailable(printable(file_, 200) + ": cannot compile the kernels: " +
                      error_text(ending.output) + "; set CXX to another C++ compiler");
  struct stat status {};
  if (::fstatat(folder, library.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
    throw Unavailable(printable(file_, 200) +
                      ": succeeds but makes no library; set CXX to a C++ compiler");
}

}  // namespace desmo::load
