#include "bench/kit/record/binary.h"

#include <link.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "formulations/runtime/digest.h"

namespace desmo::bench {

namespace {

/// What was loaded from a file: neither the program itself, which has no name here, nor what the
/// kernel supplies.
int collect(dl_phdr_info* object, std::size_t, void* names) {
  const std::string_view path = object->dlpi_name;
  if (path.find('/') != path.npos)
    static_cast<std::vector<std::string>*>(names)->emplace_back(path.substr(path.rfind('/') + 1));
  return 0;
}

}  // namespace

std::string binary_digest() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  if (!file) return "unknown";
  Digest digest;
  std::array<char, 1 << 16> buffer;
  while (file.read(buffer.data(), buffer.size()), file.gcount() > 0)
    digest.add({buffer.data(), static_cast<std::size_t>(file.gcount())});
  return file.bad() ? "unknown" : digest.hex();
}

Link this_link() {
  Link link{.type = {}, .flags = DESMO_LINK_FLAGS, .libraries = {}};
  dl_iterate_phdr(collect, &link.libraries);
  std::ranges::sort(link.libraries);
  link.type = link.libraries.empty() ? "static" : "dynamic";
  return link;
}

}  // namespace desmo::bench
