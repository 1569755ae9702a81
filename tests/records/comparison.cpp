// A record that desmo_bench has just written, in the report.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace desmo::bench::comparison_test {
namespace {

int run(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// With a peer, a request, and several threads and one.
TEST(FreshRecord, IsRead) {
  const std::string record = testing::TempDir() + "desmo_compared.json",
                    said = testing::TempDir() + "desmo_compared.txt";
  ASSERT_EQ(
      run(DESMO_BENCH " --duration=0.2 --benchmark_repetitions=3 --record=" + record +
          " '--benchmark_filter=truck_suspension/558/(peer:tree$|global_automatic_klu(/request:"
          "outputs)?$|group_symbolic_explicit/guess:adams8/segments:4/.*(threads|clock))'"
          " >/dev/null 2>&1"),
      0);
  for (const char* part : {"\"peers\": [", "\"requests\": [", "\"clock\":\"wall\"",
                           "\"clock\":\"cpu\"", "/clock:wall\""})
    EXPECT_NE(text_of(record).find(part), std::string::npos) << part;
  EXPECT_EQ(run(DESMO_REPORT " tables " + record + " --table threads_truck_suspension >" + said +
                " 2>&1"),
            0);
  EXPECT_EQ(text_of(said).find("one thread not measured"), std::string::npos) << text_of(said);
  std::filesystem::remove(record);
  std::filesystem::remove(said);
}

}  // namespace
}  // namespace desmo::bench::comparison_test
