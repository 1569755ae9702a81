#include "cases/io/text_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "cases/io/input_error.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

// Refuses what is no regular file, since a device or a pipe could have no end.
void check_regular(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found)
    throw UnreadableFile("there is no such file; check its name and folder");
  if (status.type() == fs::file_type::directory)
    throw UnreadableFile("is a directory; give a file in it");
  if (status.type() == fs::file_type::none)
    throw UnreadableFile("cannot be read (" + error.message() + "); check its name");
  if (status.type() != fs::file_type::regular)
    throw UnreadableFile("is not a regular file; save its contents in one");
}

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  check_regular(file);
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw UnreadableFile(std::string("cannot be opened (") + std::strerror(errno) +
                         "); check its permissions");
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (stream.read(buffer.data(), buffer.size()), stream.gcount() > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_file) throw UnreadableFile("the file is larger than 64 MiB; divide it");
  }
  if (stream.bad()) throw UnreadableFile("cannot be read to its end; check the disk");
  return text;
}

std::string read_named_text(const std::filesystem::path& file) try {
  return read_text(file);
} catch (const UnreadableFile& error) {
  throw UnreadableFile(printable(file.string(), 300) + ": " + error.what());
}

std::string read_input(const std::filesystem::path& file) try {
  return read_named_text(file);
} catch (const UnreadableFile& error) {
  throw InputError(error.what());
}

}  // namespace desmo
