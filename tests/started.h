// Programs started as a user does.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "tests/contains.h"

namespace desmo {

struct Ended {
  int code;
  std::string text;  ///< standard output and standard error
};

/// Returns the exit code of a status that wait() gives; -1: a signal ended the program.
inline int exit_code(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }

/// Runs a command of the shell.
inline Ended run(const std::string& command) {
  FILE* const pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
  Ended ended;
  for (int c; (c = std::fgetc(pipe)) != EOF;) ended.text += static_cast<char>(c);
  ended.code = exit_code(pclose(pipe));
  return ended;
}

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A test with a folder of its own, which is gone when it ends.
class InFolder : public testing::Test {
 protected:
  InFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "desmo_test_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no folder " + pattern);
    folder_ = pattern;
  }
  ~InFolder() override { std::filesystem::remove_all(folder_); }

  /// Runs a command of the shell. Returns its exit code; its streams end up in out_ and err_.
  int shell(const std::string& command) {
    const std::string out = file("stdout"), err = file("stderr");
    const int status = std::system(("{ " + command + "; } >" + out + " 2>" + err).c_str());
    out_ = text_of(out);
    err_ = text_of(err);
    return exit_code(status);
  }
  /// Returns the path of a file of the folder.
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file of the folder. Returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

  std::filesystem::path folder_;
  std::string out_, err_;
};

}  // namespace desmo
