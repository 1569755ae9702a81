#include "cases/io/new_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <list>
#include <random>

#include "cases/mechanism/names.h"

namespace desmo {

namespace fs = std::filesystem;

namespace {

/// Returns a random file name in the target's folder, so that the file can be renamed to the
/// target. A file of that name is not expected; opening would then fail. The name is as short for
/// every target, since file systems limit names.
std::string name_beside(const std::string& target) {
  std::random_device random;
  const std::string name = ".desmo." + std::to_string(random()) + ".unfinished";
  return (fs::path(target).parent_path() / name).string();
}

/// Returns the path that links lead to, whether or not it exists; "" after more than 40 links.
std::string followed(fs::path path) {
  constexpr int max_links = 40;  // as many as Linux follows
  std::error_code error;
  for (int links = 0; fs::is_symlink(path, error); ++links) {
    if (links == max_links) return "";
    path = path.parent_path() / fs::read_symlink(path, error);  // relative to the link's folder
  }
  return path.string();
}

/// Asks the file system to keep a new name through a loss of power. Ignores failures, since not
/// every file system can do that.
void sync_folder(const std::string& target) {
  const fs::path folder = fs::path(target).parent_path();
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

}  // namespace

// Delegates to another constructor, so that the destructor runs where open() throws.
OutputFile::OutputFile(const std::string& path, void (*begun)(const std::string&)) : OutputFile() {
  if (path.empty() || path == "-") {
    file_ = STDOUT_FILENO;
    return;
  }
  path_ = path;
  open(begun);
}

void OutputFile::open(void (*begun)(const std::string&)) {
  struct stat status = {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    // Only the system can follow the link from /dev/stdout to a pipe, which has no path.
    file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail(errno);
    return;
  }
  target_ = followed(path_);
  if (target_.empty()) fail(ELOOP);
  if (target_.ends_with('/')) fail(EISDIR);
  // Renaming would replace even a file that may not be written.
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail(errno);
  const std::string unfinished = name_beside(target_);
  if (begun) begun(unfinished);
  file_ = ::open(unfinished.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file_ < 0) fail(errno);
  unfinished_ = unfinished;
  if (exists && ::fchmod(file_, status.st_mode & 07777) != 0) fail(errno);
}

OutputFile::~OutputFile() {
  if (file_ >= 0 && !is_standard_output()) ::close(file_);
  if (!unfinished_.empty()) ::unlink(unfinished_.c_str());
}

void OutputFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(written < 0 ? errno : ENOSPC);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::finish() {
  if (is_standard_output()) return;
  close();
  rename();
}

void OutputFile::close() {
  // Some file systems report a full disk only here.
  if (!unfinished_.empty() && ::fsync(file_) != 0) fail(errno);
  const int file = file_;
  file_ = -1;
  if (::close(file) != 0) fail(errno);
}

void OutputFile::rename() {
  if (unfinished_.empty()) return;
  if (::rename(unfinished_.c_str(), target_.c_str()) != 0) fail(errno);
  unfinished_.clear();
  sync_folder(target_);
}

void OutputFile::fail(int error) const {
  throw OutputError((is_standard_output() ? "standard output" : printable(path_, 300) + ":") +
                        " cannot be written (" + std::strerror(error) + "); " +
                        (error == ENOSPC || error == EFBIG || error == EDQUOT
                             ? "make room on the disk"
                             : "check the folder and its permissions"),
                    error);
}

void write_files(const fs::path& folder, const std::vector<NewFile>& files) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw OutputError(folder.string() + " cannot be created: " + error.message());
  std::list<OutputFile> written;
  for (const NewFile& file : files) {
    OutputFile& output = written.emplace_back((folder / file.file_name).string());
    output.write(file.content);
    output.close();
  }
  for (OutputFile& output : written) output.rename();
}

void write_standard_output(std::string_view text) { OutputFile("").write(text); }

}  // namespace desmo
