// What trials show of the check: claims that hold, that do not, and that lack trials.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "report/check/trials.h"
#include "tests/report/check/check_sample.h"

namespace desmo::report::certificate_test {
namespace {

class CertificateOf : public ::testing::Test {
 protected:
  void TearDown() override {
    std::filesystem::remove(file_);
    std::filesystem::remove(trial_);
  }

  void add(const std::string& kind, const std::string& load, const Json& check, int times = 1) {
    for (int i = 1; i <= times; ++i) {
      std::ofstream(trial_) << Json{
          {"trial", {{"kind", kind}, {"load", load}, {"number", i}, {"cell", watched}}},
          {"check", check}};
      add_trial(file_, trial_);
    }
  }
  void add_text(const std::string& text) { std::ofstream(file_, std::ios::app) << text; }
  CheckCertificate certificate() { return read_certificate(file_); }

  std::string complaint() {
    try {
      certificate();
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  const std::string name_ = "desmo_certificate_" + std::to_string(::getpid());
  const std::filesystem::path file_ = std::filesystem::temp_directory_path() / (name_ + ".jsonl"),
                              trial_ = std::filesystem::temp_directory_path() / (name_ + ".json");
};

Json slower(double factor) {
  Json check = check_sample();
  slow_down(check, watched, factor);
  confirm(check, watched, factor);
  return check;
}

Json more_work() {
  Json check = check_sample();
  check["work"]["instructions"][watched]["head"] = 1'050'000;
  return check;
}

TEST_F(CertificateOf, HoldsWithEveryTrialAndNotWithOneLess) {
  for (const char* load : {"idle", "loaded"}) {
    add("unchanged", load, check_sample(), 30);
    add("relinked", load, check_sample(), 6);
    add("aligned", load, check_sample(), 6);
    add("slower", load, slower(1.1), 59);
    add("faster", load, slower(0.9), 6);
    add("slower", load, check_sample());  // one in sixty may be missed
  }
  add("more_work", "idle", more_work(), 59);
  EXPECT_FALSE(certificate().holds);
  EXPECT_FALSE(certificate().refuted);
  add("more_work", "idle", more_work());
  EXPECT_TRUE(certificate().holds);
  add("slower", "idle", check_sample());
  EXPECT_FALSE(certificate().holds);
  EXPECT_TRUE(certificate().refuted);
}

TEST_F(CertificateOf, OneFalseAlarmRefutesIt) {
  add("unchanged", "idle", slower(1.1));
  EXPECT_TRUE(certificate().refuted);
}

TEST_F(CertificateOf, NamingAnotherCellTooIsNotFinding) {
  Json check = slower(1.1);
  slow_down(check, "truck_suspension/114/group_symbolic_inlined", 1.1);
  confirm(check, "truck_suspension/114/group_symbolic_inlined", 1.1);
  add("slower", "idle", check, 2);
  EXPECT_TRUE(certificate().refuted);
}

TEST_F(CertificateOf, TrialsOfTwoMachinesMakeNone) {
  add("unchanged", "idle", check_sample());
  Json other = check_sample();
  for (const char* side : {"base", "head"}) {
    other[side]["record"]["machine"]["cpu"] = "other";
    for (Json& candidate : other[side]["paper"]["cells"]) candidate["machine"] = "other";
  }
  EXPECT_THROW(add("unchanged", "idle", other), MixedRecord);
  EXPECT_EQ(complaint(), "accepted");  // and nothing was added
}

TEST_F(CertificateOf, ALineIsShort) {
  add("unchanged", "idle", check_sample());
  const auto head_and_one = std::filesystem::file_size(file_);
  add("unchanged", "idle", check_sample());
  EXPECT_LT(std::filesystem::file_size(file_) - head_and_one, 200u);
}

TEST_F(CertificateOf, BlankLinesAreNoTrials) {
  add_text("\n");
  add("unchanged", "idle", check_sample());
  add_text(" \r\n\n");
  add("unchanged", "idle", slower(1.1));
  EXPECT_TRUE(certificate().refuted);
  add_text("\nx\n");
  EXPECT_NE(complaint().find(".jsonl: line 8: "), std::string::npos) << complaint();
}

TEST_F(CertificateOf, ALineThatIsCutOffIsNamed) {
  add("unchanged", "idle", check_sample(), 2);
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 10);
  EXPECT_NE(complaint().find(".jsonl: line 3: "), std::string::npos) << complaint();
}

TEST(FiledCertificate, Holds) {
  EXPECT_TRUE(read_certificate(DESMO_SOURCE_DIR "/results/certificate.jsonl").holds);
}

}  // namespace
}  // namespace desmo::report::certificate_test
