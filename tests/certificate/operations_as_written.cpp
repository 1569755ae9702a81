// Bounds of rounding count on operations as they are written: a product and a sum that are fused
// round once, and what was lost in the product is then counted where nothing was.

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace desmo::operations_as_written_test {
namespace {

/// Returns the number of fused instructions of each object in the library of proofs.
std::map<std::string, int> count_fused() {
  const std::unique_ptr<FILE, int (*)(FILE*)> listing(
      popen("objdump -d --no-show-raw-insn " DESMO_CERTIFICATE, "r"), pclose);
  std::map<std::string, int> counts;
  int* count = nullptr;
  char text[4096];
  while (listing && std::fgets(text, sizeof text, listing.get())) {
    const std::string line = text;
    if (const std::size_t end = line.find(".o:"); end != line.npos)
      count = &counts[line.substr(0, line.find('.'))];
    else if (count && (line.find("\tvfm") != line.npos || line.find("\tvfnm") != line.npos))
      ++*count;
  }
  return counts;
}

TEST(OperationsAsWritten, AreNotFusedWhereNobodyWroteIt) {
  // Sources whose own text, or that of a header, calls fma; that of Eigen in chosen_equations.
  const std::set<std::string> written{"block_equations",
                                      "block_image",
                                      "block_proof",
                                      "certificate",
                                      "chosen_equations",
                                      "coordinate_paths",
                                      "departure",
                                      "left_out_equations",
                                      "linear_equations",
                                      "path_equations",
                                      "path_proof",
                                      "preconditioner",
                                      "start"};
  const std::map<std::string, int> fused = count_fused();
  ASSERT_GT(fused.size(), written.size());
  for (const auto& [object, count] : fused)
    if (!written.contains(object)) EXPECT_EQ(count, 0) << object << " needs -ffp-contract=off";
#ifdef __FMA__
  EXPECT_GT(fused.at("preconditioner"), 0);
#endif
}

}  // namespace
}  // namespace desmo::operations_as_written_test
