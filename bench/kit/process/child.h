#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::bench {

/// Settings with which a program is run.
struct Launch {
  std::vector<std::string> arguments;    ///< the program's path first
  std::vector<std::string> environment;  ///< whole environment, NAME=value
  int core = -1;                         ///< the only core to run on; -1: any
  /// Runs a copy of the program that is made for this run alone, and so lies on pages of memory of
  /// its own. A file gets its pages by chance, and keeps them as long as it is in memory. They
  /// decide which parts of its loops compete for cache lines: times differ by 3 % and more.
  bool fresh_copy = false;
};

/// A running program that answers questions line by line. Constructor, say() and read_answer()
/// throw std::runtime_error when the program cannot be started or has ended. A program that cannot
/// be executed ends with exit code 127.
class Child {
 public:
  explicit Child(const Launch& launch);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();  ///< closes its input and waits for its end

  void say(std::string_view line);  ///< sends a line, given without its end
  std::string read_answer();        ///< the next line, without its end

  /// Closes its input and waits for its end. Returns its exit code, or 128 + the signal that ended
  /// it. output: receives everything that was not yet read. Throws std::runtime_error where the
  /// exit code cannot be had, as when this process ignores SIGCHLD.
  int finish(std::string& output);

 private:
  std::string program_;
  pid_t process_ = -1;
  std::FILE *in_ = nullptr, *out_ = nullptr;
};

/// Returns the launch of a program in a fixed environment: PATH, one thread of BLAS, every symbol
/// resolved at the start, locale C. Keeps LD_LIBRARY_PATH and DESMO_LIBCOINHSL, which say where
/// libraries are.
Launch fixed_launch(std::vector<std::string> arguments);

/// Returns the cores that this process may use.
std::vector<int> usable_cores();

}  // namespace desmo::bench
