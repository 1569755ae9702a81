#pragma once

#include <chrono>
#include <string>

namespace desmo::load {

/// A C++ compiler, and what it compiles kernels with.
class Compiler {
 public:
  /// That of the environment variable CXX (a name or a file, without arguments); where it is not
  /// set, the one that desmo was built with; where that is gone, c++. Throws Unavailable when there
  /// is none, or it does not say which version it is. lanes: of the kernels, which need a processor
  /// that has them.
  static Compiler find(int lanes = 1);

  const std::string& file() const { return file_; }
  /// The first line of what it says of itself.
  std::string version() const;
  /// Everything that the code it makes depends on, apart from the source.
  std::string identity() const;

  /// Makes a shared library from a C++ file; both are names in a folder that is open as `folder`.
  /// Throws Unavailable with the beginning of what the compiler says.
  void compile(const std::string& source, const std::string& library, int folder,
               std::chrono::milliseconds time) const;

 private:
  std::string file_, version_, flags_;
};

}  // namespace desmo::load
