#include "cases/io/new_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace desmo {
namespace {

[[noreturn]] void fail(const std::string& what, int error) {
  throw OutputError(what + ": " + std::strerror(error));
}

void write_all(int file, std::string_view text, const std::string& name) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t written = ::write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(name + " cannot be written", written < 0 ? errno : ENOSPC);
    done += static_cast<std::size_t>(written);
  }
}

// The files that exist under a temporary name; removed unless all were put in place.
class Temporaries {
 public:
  explicit Temporaries(std::filesystem::path folder) : folder_(std::move(folder)) {}
  Temporaries(const Temporaries&) = delete;
  Temporaries& operator=(const Temporaries&) = delete;
  ~Temporaries() {
    std::error_code ignored;
    for (const auto& name : names_) std::filesystem::remove(temporary(name), ignored);
  }

  void add(const NewFile& added) {
    const std::string name = (folder_ / added.file_name).string();
    const int file =
        ::open(temporary(added.file_name).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) fail(name + " cannot be written", errno);
    names_.push_back(added.file_name);
    try {
      write_all(file, added.content, name);
    } catch (...) {
      ::close(file);
      throw;
    }
    // A full disk may be noticed only here.
    const bool kept = ::fsync(file) == 0;
    const int sync_error = errno;
    const bool closed = ::close(file) == 0;
    if (!kept || !closed) fail(name + " cannot be written", kept ? errno : sync_error);
  }

  void put_in_place() {
    for (const auto& name : names_) {
      std::error_code error;
      std::filesystem::rename(temporary(name), folder_ / name, error);
      if (error)
        throw OutputError((folder_ / name).string() + " cannot be replaced: " + error.message());
    }
    names_.clear();
  }

 private:
  std::filesystem::path temporary(const std::string& name) const {
    return folder_ / ("." + name + ".part");
  }

  std::filesystem::path folder_;
  std::vector<std::string> names_;
};

}  // namespace

void write_files(const std::filesystem::path& folder, const std::vector<NewFile>& files) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError(folder.string() + " cannot be created: " + error.message());
  Temporaries temporaries(folder);
  for (const NewFile& file : files) temporaries.add(file);
  temporaries.put_in_place();
}

void write_standard_output(std::string_view text) {
  write_all(STDOUT_FILENO, text, "standard output");
}

}  // namespace desmo
