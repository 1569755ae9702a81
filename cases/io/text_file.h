#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace desmo {

constexpr std::size_t max_file = std::size_t{64} << 20;  ///< size of a file that is read, ≤ [bytes]

/// Error of a file that cannot be read. The message is the reason and the remedy.
class UnreadableFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the bytes of a regular file of at most `max_file`. Throws UnreadableFile.
std::string read_text(const std::filesystem::path& file);

/// Does what read_text() does; the message of UnreadableFile begins with the file's name.
std::string read_named_text(const std::filesystem::path& file);

/// Does what read_named_text() does, but throws InputError with that message.
std::string read_input(const std::filesystem::path& file);

}  // namespace desmo
