#include "report/read/record_file.h"

#include <zlib.h>

#include <array>
#include <charconv>
#include <optional>

#include "cases/io/text_file.h"
#include "report/text/texts.h"

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
  std::string bytes = read_named_text(file);
  return bytes.starts_with("\x1f\x8b") ? decompressed(bytes, file.string()) : bytes;
}

namespace {

/// A version MAJOR.MINOR.PATCH, which compares in this order.
using Version = std::array<int, 3>;

std::optional<Version> parse_version(std::string_view text) {
  Version version{};
  const char *at = text.data(), *const end = at + text.size();
  for (std::size_t i = 0; i < version.size(); ++i) {
    if (i > 0 && (at == end || *at++ != '.')) return std::nullopt;
    const auto [stop, error] = std::from_chars(at, end, version[i]);
    if (error != std::errc{} || version[i] < 0) return std::nullopt;
    at = stop;
  }
  return at == end ? std::optional(version) : std::nullopt;
}

const Version known_version = *parse_version(schema_version);

}  // namespace

// Before 2.0.0 the key of the version was "version".
void check_schema(const RecordValue& root, const std::string& name) {
  const std::string schema = root["schema"].text();
  if (schema != name)
    root["schema"].complain(in_double_quotes(schema) + " is not " + in_double_quotes(name));
  const bool old = !root.find("schema_version") && root.find("version");
  const RecordValue node = root[old ? "version" : "schema_version"];
  const std::string text = node.text();
  const std::optional<Version> version = parse_version(text);
  if (!version) node.complain(in_double_quotes(text) + " is not a version, as " + schema_version);
  const int major = version->front(), known = known_version.front();
  if (major == known || major == known - 1) return;
  try {
    node.complain("schema version " + beginning_of(text) + ", and this program reads " +
                  std::to_string(known - 1) + ".x and " + std::to_string(known) + ".x; " +
                  (major > known ? "update desmo and build it again"
                                 : "measure it anew (bench/run, bench/check --renew-baseline), or "
                                   "read it with desmo_report of the commit that it names"));
  } catch (const InputError& error) {
    throw UnsupportedVersion(error.what());
  }
}

std::string note_on_version(const std::string& version) {
  if (parse_version(version) <= known_version) return {};
  return sentence("version.newer", {{"version", beginning_of(version)}, {"known", schema_version}});
}

}  // namespace desmo::report
