#include "report/read/record_file.h"

#include <zlib.h>

#include <array>
#include <cstdlib>

#include "cases/io/text_file.h"

namespace desmo::report {
namespace {

/// Decompresses gzip data. Throws InputError.
std::string decompressed(std::string& bytes, const std::string& file) {
  z_stream stream{};
  constexpr int gzip = 16 + MAX_WBITS;
  if (inflateInit2(&stream, gzip) != Z_OK) throw InputError(file + ": cannot be decompressed");
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  std::array<char, 1 << 16> buffer;
  int state = Z_OK;
  while (state == Z_OK && text.size() <= max_file) {
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(buffer.data(), buffer.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (text.size() > max_file)
    throw InputError(file + ": larger than " + std::to_string(max_file) + " bytes");
  if (state != Z_STREAM_END) throw InputError(file + ": not complete compressed data (gzip)");
  return text;
}

}  // namespace

std::string read_record_text(const std::filesystem::path& file) {
  try {
    std::string bytes = read_text(file);
    return bytes.starts_with("\x1f\x8b") ? decompressed(bytes, file.string()) : bytes;
  } catch (const UnreadableFile& error) {
    throw UnreadableRecord(file.string() + ": " + error.what());
  }
}

// One version is read; an older one is measured anew, a newer one needs a newer program.
void check_schema(const RecordValue& root, const std::string& name) {
  const std::string schema = root["schema"].text();
  if (schema != name) root["schema"].complain("\"" + schema + "\" is not \"" + name + "\"");
  const bool old = !root.find("schema_version") && root.find("version");
  const RecordValue version = root[old ? "version" : "schema_version"];
  const std::string text = version.text();
  if (text == schema_version) return;
  const bool newer = std::atoi(text.c_str()) >= std::atoi(schema_version);
  try {
    version.complain("schema version " + text + ", and only " + schema_version + " is read; " +
                     (newer ? "a newer desmo_report may read it"
                            : "measure it anew (bench/run, bench/check --renew-baseline)"));
  } catch (const InputError& error) {
    throw UnsupportedVersion(error.what());
  }
}

}  // namespace desmo::report
