#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace desmo {

constexpr std::size_t max_file = std::size_t{64} << 20;  ///< [bytes]

/// Reason why a file cannot be read, and the remedy.
class UnreadableFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the bytes of a regular file of at most `max_file`. Throws UnreadableFile.
std::string read_text(const std::filesystem::path& file);

/// Does the same for a file that is part of the input: throws InputError, naming it.
std::string read_input(const std::filesystem::path& file);

}  // namespace desmo
