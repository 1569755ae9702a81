#include "formulations/runtime/cache.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <random>
#include <system_error>
#include <utility>
#include <vector>

#include "cases/mechanism/names.h"
#include "formulations/runtime/digest.h"
#include "formulations/runtime/unavailable.h"

namespace desmo::load {

namespace fs = std::filesystem;

namespace {

constexpr mode_t all_of_others = 0077, writing_of_others = 0022;  // permissions of all other users
constexpr std::size_t max_files = 256;             // number of finished files that are kept (≤)
constexpr const char* unfinished = "unfinished.";  // prefix of the names of unfinished files
constexpr std::chrono::hours abandoned{1};         // age (>) of an unfinished file to be removed
constexpr off_t max_file = off_t{256} << 20;       // size of a file that is read (≤) [bytes]

// A C++ comment, so that a sealed source file still compiles.
constexpr std::string_view seal_begin = "\n// desmo ";
constexpr std::size_t seal_size = seal_begin.size() + 64 + 1;

std::string seal(const std::string& name, std::string_view content) {
  const std::string size = std::to_string(content.size());
  return std::string(seal_begin) + Digest().add(name).add("\n" + size + "\n").add(content).hex() +
         "\n";
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw Unavailable(printable(folder.string(), 300) + ": " + why +
                    "; mend that, or set XDG_CACHE_HOME to another folder");
}

[[noreturn]] void refuse(const fs::path& folder, int error) {
  refuse(folder, std::string("cannot be used (") + std::strerror(error) + ")");
}

fs::path home() {
  if (const char* folder = std::getenv("HOME"); folder && *folder == '/') return folder;
  const passwd* user = ::getpwuid(::geteuid());
  if (!user || *user->pw_dir != '/')
    throw Unavailable("no home folder for compiled code; set XDG_CACHE_HOME");
  return user->pw_dir;
}

/// Returns XDG_CACHE_HOME; ~/.cache when that is not set or not absolute (XDG Base Directory
/// Specification).
fs::path base_folder() {
  const char* const wanted = std::getenv("XDG_CACHE_HOME");
  return wanted && *wanted == '/' ? fs::path(wanted) : home() / ".cache";
}

/// Opens a folder in another one, and makes it where it is missing. Throws Unavailable when it is a
/// link, belongs to another user or has a `forbidden` permission.
Descriptor open_own(const Descriptor& around, const char* name, const fs::path& path,
                    mode_t forbidden) {
  if (::mkdirat(around.number(), name, 0700) != 0 && errno != EEXIST) refuse(path, errno);
  Descriptor folder(
      ::openat(around.number(), name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!folder.is_open())
    refuse(path,
           errno == ELOOP || errno == ENOTDIR ? "is a link or no folder" : std::strerror(errno));
  struct stat status {};
  if (::fstat(folder.number(), &status) != 0) refuse(path, errno);
  if (status.st_uid != ::geteuid()) refuse(path, "belongs to another user");
  if (status.st_mode & forbidden)
    refuse(path, forbidden == all_of_others ? "is open to others (chmod 700)"
                                            : "can be written to by others (chmod go-w)");
  return folder;
}

/// Returns the content of a regular file that the user owns. Returns nullopt for any other, for one
/// with a `forbidden` permission and for one larger than max_file.
std::optional<std::string> content_of(int folder, const std::string& name, mode_t forbidden = 0) {
  const Descriptor file(
      ::openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode) ||
      status.st_uid != ::geteuid() || (status.st_mode & forbidden) != 0 ||
      status.st_size > max_file)
    return std::nullopt;
  std::string text(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t got = ::read(file.number(), text.data() + done, text.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  text.resize(done);
  return text;
}

bool write_all(const Descriptor& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.number(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string new_name() {
  std::random_device random;
  return unfinished + std::to_string(::getpid()) + "." + std::to_string(random());
}

/// The name of a file that the destructor removes, if one of that name still exists.
struct Temporary {
  ~Temporary() { ::unlinkat(folder, name.c_str(), 0); }
  int folder;
  std::string name;
};

}  // namespace

Cache Cache::open() {
  Cache cache;
  const fs::path base = base_folder();
  ::mkdir(base.c_str(), 0700);
  const Descriptor around(::open(base.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!around.is_open()) refuse(base, errno);
  const Descriptor own = open_own(around, "desmo", base / "desmo", writing_of_others);
  cache.folder_ = base / "desmo" / "kernels";
  cache.descriptor_ = open_own(own, "kernels", cache.folder_, all_of_others);
  return cache;
}

std::optional<std::string> Cache::read(const std::string& name) const {
  std::optional<std::string> text = content_of(descriptor(), name, all_of_others);
  if (!text || text->size() < seal_size) return std::nullopt;
  const std::string_view content(text->data(), text->size() - seal_size);
  if (!text->ends_with(seal(name, content))) return std::nullopt;
  text->resize(content.size());
  return text;
}

void Cache::write(const std::string& name, std::string_view content) const {
  remove_old();
  const Temporary temporary{descriptor(), new_name()};
  const Descriptor file(::openat(descriptor(), temporary.name.c_str(),
                                 O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (!file.is_open() || !write_all(file, content) || !write_all(file, seal(name, content)) ||
      ::renameat(descriptor(), temporary.name.c_str(), descriptor(), name.c_str()) != 0)
    refuse(folder_, errno);
}

void Cache::remove(const std::string& name) const { ::unlinkat(descriptor(), name.c_str(), 0); }

std::string Cache::content_made_by(const std::function<void(const std::string& name)>& make) const {
  const Temporary temporary{descriptor(), new_name()};
  make(temporary.name);
  std::optional<std::string> content = content_of(descriptor(), temporary.name);
  if (!content) refuse(folder_, "has not got what was to be made there");
  return *std::move(content);
}

void Cache::remove_old() const {
  std::vector<std::pair<fs::file_time_type, std::string>> finished;
  const auto now = fs::file_time_type::clock::now();
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    const fs::file_time_type time = entry.last_write_time(error);
    if (error) continue;  // another process removed it
    if (name.ends_with(".cpp") || name.ends_with(".so"))
      finished.emplace_back(time, name);
    else if (name.starts_with(unfinished) && time + abandoned < now)
      remove(name);
  }
  if (finished.size() < max_files) return;
  std::ranges::sort(finished);
  for (std::size_t i = 0; i <= finished.size() - max_files; ++i) remove(finished[i].second);
}

}  // namespace desmo::load
