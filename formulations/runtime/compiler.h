#pragma once

#include <chrono>
#include <string>

namespace desmo::load {

/// A C++ compiler, with its options for kernels.
class Compiler {
 public:
  /// Finds a compiler: that of the environment variable CXX if it is set (a name or an absolute
  /// file, without arguments). Otherwise finds the one that desmo was built with, else c++. Throws
  /// Unavailable when CXX names no program, when there is none, or when it does not tell its
  /// version. lanes: lanes of the kernels; 8 need a processor with 512-bit registers.
  static Compiler find(int lanes = 1);

  const std::string& file() const { return file_; }
  /// Returns the first line of its version message.
  std::string version() const;
  /// Returns everything but the source that determines its output: file, version, options.
  std::string identity() const;

  /// Compiles a C++ file to a shared library. source and library: names in the folder whose open
  /// descriptor is `folder`. time: limit. Throws Unavailable when the compiler fails, with its
  /// first error, when it cannot be started, or when it takes longer.
  void compile(const std::string& source, const std::string& library, int folder,
               std::chrono::milliseconds time) const;

 private:
  std::string file_, version_, flags_;
};

}  // namespace desmo::load
