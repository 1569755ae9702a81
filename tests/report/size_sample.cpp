#include "tests/report/size_sample.h"

#include <utility>

namespace desmo::report {
namespace {

Json without_paper(const std::string& command) {
  Json record = structured_record();
  record.erase("paper");
  record["schema_version"] = "2.0.0";
  record["record"]["command"] = command;
  record["record"]["machine"]["caches"] = {
      "L1 Data 10 KiB, shared by 1", "L1 Instruction 32 KiB, shared by 1", "L2 Unified 100 KiB"};
  return record;
}

Json counted(const std::string& case_name, const std::string& id, int instructions) {
  return {{"case", case_name}, {"coordinates", 558},
          {"id", id},          {"instructions_per_step", instructions},
          {"steps", 50},       {"tool", "valgrind-0.0, glibc 0.0"}};
}

}  // namespace

Json timed_size(const std::string& case_name, int coordinates, const std::string& id,
                double microseconds) {
  return {{"case", case_name},
          {"coordinates", coordinates},
          {"unknowns", coordinates},
          {"id", id},
          {"step_seconds", 0.01},
          {"instants", 401},
          {"tolerance", 1e-12},
          {"status", "ok"},
          {"checked_against", "quadruple"},
          {"verification",
           {{"instants", 3}, {"position", 1e-12}, {"velocity", 1e-11}, {"acceleration", 1e-10}}},
          {"iterations_per_step", 3.0},
          {"residual", 1e-13},
          {"state_bytes", 24 * coordinates},
          {"bytes", 100 * coordinates},
          {"time_per_step",
           {{"clock", "cpu"},
            {"seconds", {1.5e-6 * microseconds, 1e-6 * microseconds, 1.02e-6 * microseconds}}}}};
}

Json sizes_record() {
  Json record = without_paper("desmo_bench size --synthetic");
  const std::string bars = "four_bar", klu = "global_automatic_klu";
  for (const auto& [n, nanoseconds] :
       {std::pair{10, 10}, {100, 10}, {1000, 10}, {10'000, 15}, {100'000, 20}}) {
    record["size"]["growth"].push_back(
        timed_size(bars, n, "group_symbolic_explicit", 1e-3 * nanoseconds * n));
    record["size"]["growth"].push_back(timed_size(bars, n, klu, 1e-2 * n * n));
  }
  record["size"]["growth"].back()["status"] = "failed";
  record["size"]["growth"].back()["message"] = "wrong by design";
  for (const int n : {10, 30, 100, 300}) {
    const double cube = 1e-3 * n * n * n;
    record["size"]["break_even"].push_back(timed_size(bars, n, "global_automatic_lapack", cube));
    record["size"]["break_even"].push_back(timed_size(bars, n, "global_automatic_eigen", 2 * cube));
    record["size"]["break_even"].push_back(timed_size(bars, n, klu, 3.6 * n));
    record["size"]["break_even"].push_back(
        timed_size(bars, n, "global_automatic_umfpack", 0.05 * n));
    record["size"]["break_even"].push_back(
        timed_size(bars, n, "global_automatic_cholmod", 1e3 * n * n));
  }
  return record;
}

Json instructions_record() {
  Json record = without_paper("desmo_instructions --synthetic");
  record["instructions"]["counts"] = {
      counted("truck_suspension", "global_automatic_klu", 1'400'000),
      counted("truck_suspension", "group_symbolic_lapack", 5'900'000),
      counted("truck_suspension", "group_symbolic_explicit/lanes:4", 14'000),
      counted("four_bar", "group_symbolic_inlined", 100'000)};
  return record;
}

}  // namespace desmo::report
