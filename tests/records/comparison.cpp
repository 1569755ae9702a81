// A record that desmo_bench has just written, in the report.

#include "tests/started.h"

namespace desmo::bench::comparison_test {
namespace {

using FreshRecord = InFolder;

// With a peer, a request, and several threads and one.
TEST_F(FreshRecord, IsRead) {
  const std::string record = file("record.json");
  const Ended measured =
      run(DESMO_BENCH " --duration=0.2 --benchmark_repetitions=3 --record=" + record +
          " '--benchmark_filter=truck_suspension/558/(peer:tree$|global_automatic_klu(/request:"
          "outputs)?$|group_symbolic_explicit/guess:adams8/segments:4/.*(threads|clock))'");
  ASSERT_EQ(measured.code, 0) << measured.text;
  for (const char* part : {"\"peers\": [", "\"requests\": [", "\"clock\":\"wall\"",
                           "\"clock\":\"cpu\"", "/clock:wall\""})
    EXPECT_CONTAINS(text_of(record), part);
  const Ended report = run(DESMO_REPORT " tables " + record + " --table threads_truck_suspension");
  EXPECT_EQ(report.code, 0);
  EXPECT_LACKS(report.text, "one thread not measured");
}

}  // namespace
}  // namespace desmo::bench::comparison_test
