// Work in a process of its own: what comes back from it, and what is said when nothing does.

#include "bench/kit/process/own_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/refusal.h"

namespace desmo::bench::own_process_test {
namespace {

using Json = nlohmann::ordered_json;

std::string message_of(const std::function<Json()>& work) {
  return refusal<std::runtime_error>([&] { in_own_process("truck/558", work); });
}

TEST(OwnProcess, GivesBackWhatItMadeToTheLastDigit) {
  const Json made{{"seconds", {0.1, 1.0 / 3, 2e-300}}, {"text", std::string(1 << 20, 'x')}};
  EXPECT_EQ(in_own_process("truck/558", [&] { return made; }), made);
}

TEST(OwnProcess, ThatEndsOtherwiseIsNamed) {
  const std::string thrown = message_of([]() -> Json { throw std::runtime_error("no such part"); }),
                    killed = message_of([] {
                      std::raise(SIGKILL);
                      return Json();
                    });
  EXPECT_EQ(thrown, "truck/558 was not measured");
  EXPECT_EQ(killed, "truck/558: its process was ended by signal 9 (Killed)");
}

}  // namespace
}  // namespace desmo::bench::own_process_test
