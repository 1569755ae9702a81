#include "tests/report/size_sample.h"

#include <utility>

namespace desmo::report {
namespace {

Json counted(const std::string& case_name, const std::string& id, int instructions) {
  return {{"case", case_name}, {"coordinates", 558},
          {"id", id},          {"instructions_per_step", instructions},
          {"steps", 50},       {"tool", "valgrind-0.0, glibc 0.0"}};
}

/// Returns an element of `growth` or `break_even` of status "ok". microseconds: its smallest
/// sample.
Json timed_size(const std::string& case_name, int coordinates, const std::string& id,
                double microseconds) {
  return {{"case", case_name},
          {"coordinates", coordinates},
          {"unknowns", coordinates},
          {"id", id},
          {"tolerance", 1e-12},
          {"status", "ok"},
          {"checked_against", "quadruple"},
          {"verification", levels(1e-12, 1e-11, 1e-10)},
          {"iterations_per_step", 3.0},
          {"state_bytes", 24 * coordinates},
          {"bytes", 100 * coordinates},
          {"time_per_step", step_time(microseconds)}};
}

}  // namespace

Json sizes_record() {
  Json record = empty_record();
  record["record"]["machine"]["caches"] = {"L2 Unified 100 KiB", "L1 Data 10 KiB, shared by 1",
                                           "L1 Instruction 32 KiB, shared by 1", "a large one"};
  const std::string bars = "four_bar", klu = "global_automatic_klu";
  for (const auto& [n, nanoseconds] :
       {std::pair{10, 10}, {100, 10}, {1000, 10}, {10'000, 15}, {100'000, 20}}) {
    record["size"]["growth"].push_back(
        timed_size(bars, n, "group_symbolic_explicit", 1e-3 * nanoseconds * n));
    record["size"]["growth"].push_back(timed_size(bars, n, klu, 1e-2 * n * n));
  }
  fail(record["size"]["growth"].back());
  for (const int n : {10, 30, 100, 300}) {
    const double cube = 1e-3 * n * n * n;
    for (const auto& [solver, microseconds] : {std::pair{"lapack", cube},
                                               {"eigen", 2 * cube},
                                               {"klu", 3.6 * n},
                                               {"umfpack", 0.05 * n},
                                               {"cholmod", 1e3 * n * n}})
      record["size"]["break_even"].push_back(
          timed_size(bars, n, std::string("global_automatic_") + solver, microseconds));
  }
  return record;
}

Json modelling_record() {
  Json record = empty_record();
  for (const int n : {114, 558})
    for (const auto& [suffix, times] : {std::pair{"", 1},
                                        {"/coordinates:basis", 2},
                                        {"/coordinates:reference", 3},
                                        {"/coordinates:relative", 4}})
      for (const auto& [id, microseconds] :
           {std::pair{"global_automatic_cholmod", (n == 558 ? 40 : 20) * times},
            {"global_automatic_klu", 10},
            {"group_automatic_lapack", 20},
            {"group_automatic_klu", 5}}) {
        Json entry = timed_size(truck, n, std::string(id) + suffix, 1e-2 * microseconds * n);
        entry["unknowns"] = n / times;
        entry["entries"] = 5 * n;
        entry["condensation"] = times == 1 ? 0 : 7 * n;
        entry["condition"] = 80;
        record["modelling"]["times"].push_back(std::move(entry));
      }
  return record;
}

Json instructions_record() {
  Json record = empty_record();
  record["instructions"]["counts"] = {counted(truck, "global_automatic_klu", 1'400'000),
                                      counted(truck, "group_symbolic_lapack", 5'900'000),
                                      counted(truck, "group_symbolic_explicit/lanes:4", 14'000),
                                      counted("four_bar", "group_symbolic_inlined", 100'000)};
  return record;
}

History history_sample() {
  return {{"old", "young"},
          {{"aaa", "2026-01-01T00:00:00Z", "One", "GNU", {1000, std::nullopt}},
           {"bbb", "2026-01-02T00:00:00Z", "Two", "GNU", {1019, 2000}},
           {"ccc", "2026-01-03T00:00:00Z", "Three", "GNU", {1019, 2060}}}};
}

}  // namespace desmo::report
