#pragma once

#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // OpenSSL's

namespace desmo {

/// SHA-256 of all that is added, in order. By OpenSSL, whose interface is public and kept: Boost's
/// digests are either a detail of another library (SHA-1) or younger than what Debian has.
class Digest {
 public:
  /// Throws std::runtime_error when OpenSSL does not offer the algorithm.
  Digest();
  ~Digest();

  Digest& add(std::string_view bytes);

  /// 64 hexadecimal digits, as sha256sum prints them. Nothing can be added afterwards.
  std::string hex();

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

}  // namespace desmo
