// The text of a file, compressed or not.
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "report/read/json_document.h"

namespace desmo::report {
namespace {

using Buffer = std::array<char, 1 << 16>;

void append(std::string& text, const Buffer& buffer, std::size_t count) {
  text.append(buffer.data(), count);
  if (text.size() > max_record)
    throw InvalidRecord("larger than " + std::to_string(max_record) + " bytes");
}

std::string read_bytes(const std::filesystem::path& file) {
  std::error_code unreadable;  // is for the stream to say
  if (std::filesystem::is_directory(file, unreadable)) throw UnreadableFile("is a directory");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw UnreadableFile(std::string("cannot be read: ") + std::strerror(errno));
  std::string bytes;
  Buffer buffer;
  while (stream.read(buffer.data(), buffer.size()), stream.gcount() > 0)
    append(bytes, buffer, static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) throw UnreadableFile("cannot be read to its end");
  return bytes;
}

bool is_compressed(const std::string& bytes) { return bytes.starts_with("\x1f\x8b"); }

/// Ends the stream whatever happens.
class Inflation {
 public:
  Inflation() {
    constexpr int gzip = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, gzip) != Z_OK) throw InvalidRecord("cannot be decompressed");
  }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  ~Inflation() { inflateEnd(&stream_); }

  std::string text_of(std::string& bytes) {
    stream_.next_in = reinterpret_cast<Bytef*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    for (int state = Z_OK; state != Z_STREAM_END;) {
      Buffer buffer;
      stream_.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream_.avail_out = static_cast<uInt>(buffer.size());
      state = inflate(&stream_, Z_NO_FLUSH);
      if (state != Z_OK && state != Z_STREAM_END)
        throw InvalidRecord("not complete compressed data (gzip)");
      append(text, buffer, buffer.size() - stream_.avail_out);
    }
    return text;
  }

 private:
  z_stream stream_{};
};

}  // namespace

std::string read_whole(const std::filesystem::path& file) {
  std::string bytes = read_bytes(file);
  return is_compressed(bytes) ? Inflation().text_of(bytes) : bytes;
}

}  // namespace desmo::report
