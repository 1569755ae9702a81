// Programs started as a user does.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/contains.h"

namespace desmo {

struct Ended {
  int code;
  std::string text;  ///< standard output and standard error
};

/// Runs a command of the shell; -1 is the code of one that a signal ended.
inline Ended run(const std::string& command) {
  FILE* const pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
  Ended ended;
  for (int c; (c = std::fgetc(pipe)) != EOF;) ended.text += static_cast<char>(c);
  const int status = pclose(pipe);
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace desmo
