#include "bench/cli/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>

#include "bench/cli/errors.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace fs = std::filesystem;
namespace {

/// A name in the same folder, so that it can be renamed, that nobody else uses.
std::string name_beside(const std::string& target) {
  std::random_device random;
  const fs::path path(target);
  return (path.parent_path() /
          ("." + path.filename().string() + "." + std::to_string(random()) + ".unfinished"))
      .string();
}

/// So that a new name survives a loss of power. Not every file system can do that.
void sync_folder(const std::string& target) {
  const fs::path folder = fs::path(target).parent_path();
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

}  // namespace

Output::Output(const std::string& path) : path_(path == "-" ? "" : path) {
  if (path_.empty()) {
    file_ = STDOUT_FILENO;
    return;
  }
  try {
    open();
  } catch (...) {
    if (file_ >= 0) ::close(file_);
    if (!unfinished_.empty()) ::unlink(unfinished_.c_str());
    throw;
  }
}

void Output::open() {
  std::error_code ignored;
  target_ = fs::is_symlink(path_, ignored) ? fs::weakly_canonical(path_, ignored).string() : path_;
  if (target_.empty()) fail(ELOOP);
  if (fs::is_directory(target_, ignored) || target_.ends_with('/')) fail(EISDIR);
  struct stat status = {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail(errno);
    return;
  }
  // Renaming would replace even a file that is protected.
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail(errno);
  const std::string unfinished = name_beside(target_);
  guard_.emplace(unfinished);
  file_ = ::open(unfinished.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file_ < 0) fail(errno);
  unfinished_ = unfinished;
  if (exists && ::fchmod(file_, status.st_mode & 07777) != 0) fail(errno);
}

Output::~Output() {
  if (file_ >= 0 && !is_standard_output()) ::close(file_);
  if (!unfinished_.empty()) ::unlink(unfinished_.c_str());
}

void Output::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(written < 0 ? errno : ENOSPC);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void Output::finish() {
  if (is_standard_output()) return;
  // A full disk may be noticed only here.
  if (!unfinished_.empty() && ::fsync(file_) != 0) fail(errno);
  const int file = file_;
  file_ = -1;
  if (::close(file) != 0) fail(errno);
  if (unfinished_.empty()) return;
  if (::rename(unfinished_.c_str(), target_.c_str()) != 0) fail(errno);
  unfinished_.clear();
  guard_.reset();
  sync_folder(target_);
}

void Output::fail(int error) const {
  if (error == EPIPE) throw OutputClosed{};
  throw Error(unwritable_output,
              (is_standard_output() ? "standard output" : printable(path_, 300)) +
                  ": cannot be written (" + std::strerror(error) + "); " +
                  (error == ENOSPC || error == EFBIG || error == EDQUOT
                       ? "make room on the disk"
                       : "check the folder and its permissions"));
}

void write_standard_output(std::string_view text) { Output("").write(text); }

}  // namespace desmo::cli
