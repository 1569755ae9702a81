#pragma once

#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // OpenSSL's context of a digest

namespace desmo {

/// The SHA-256 digest of all bytes added, in order. OpenSSL computes it, because its interface is
/// public and stable; Boost's digests are internal (SHA-1) or newer than Debian's Boost.
class Digest {
 public:
  /// Begins a digest. Throws std::runtime_error when OpenSSL does not offer the algorithm.
  Digest();
  ~Digest();

  /// Adds bytes after those added before. Returns this object.
  Digest& add(std::string_view bytes);

  /// Returns 64 hexadecimal digits, as sha256sum prints them. Call it once, after the last add().
  std::string hex();

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

}  // namespace desmo
