#include "bench/kit/record/new_file.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace desmo::bench {

NewFile::NewFile(const std::string& path) : path_(path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::is_symlink(path, ignored)) path_ = fs::weakly_canonical(path, ignored).string();
  const bool special = fs::exists(path_, ignored) && !fs::is_regular_file(path_, ignored);
  if (!special) unfinished_ = path_ + ".unfinished";
  out_.open(special ? path_ : unfinished_);
  if (!out_) throw std::runtime_error("cannot write the file '" + path + "'");
}

NewFile::~NewFile() {
  std::error_code ignored;
  if (!unfinished_.empty()) std::filesystem::remove(unfinished_, ignored);
}

void NewFile::write(const std::string& text) {
  out_ << text;
  out_.close();
  if (!out_ || (!unfinished_.empty() && std::rename(unfinished_.c_str(), path_.c_str()) != 0))
    throw std::runtime_error("cannot write the file '" + path_ + "'");
  unfinished_.clear();
}

}  // namespace desmo::bench
