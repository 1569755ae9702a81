// What trials show of the check: claims that hold, that do not, and that lack trials.
#include "report/check/certificate.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "report/json_document.h"
#include "tests/report/check_sample.h"

namespace desmo::report::certificate_test {
namespace {

class CertificateOf : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  void add(const std::string& kind, const std::string& load, const Json& check, int times = 1) {
    const Json line = {{"trial", {{"kind", kind}, {"load", load}, {"cell", watched}}},
                       {"check", check}};
    for (int i = 0; i < times; ++i) lines_ += line.dump() + "\n";
  }
  Certificate certificate() {
    std::ofstream(file_) << lines_;
    return read_certificate(file_);
  }

  std::string lines_;
  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() /
      ("desmo_certificate_" + std::to_string(::getpid()) + ".jsonl");
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
    for (Json& cell : other[side]["cells"]) cell["machine"] = "other";
  }
  add("unchanged", "idle", other);
  EXPECT_THROW(certificate(), MixedRecord);
}

TEST_F(CertificateOf, BlankLinesAreNoTrials) {
  lines_ = "\n";
  add("unchanged", "idle", check_sample());
  lines_ += " \r\n\n";
  add("unchanged", "idle", slower(1.1));
  EXPECT_TRUE(certificate().refuted);
  lines_ += "\nx\n";
  try {
    certificate();
    FAIL();
  } catch (const InvalidRecord& error) {
    EXPECT_NE(std::string(error.what()).find("line 7"), std::string::npos) << error.what();
  }
}

TEST_F(CertificateOf, ALineThatIsCutOffIsNamed) {
  add("unchanged", "idle", check_sample(), 2);
  lines_.resize(lines_.size() - 10);
  try {
    certificate();
    FAIL();
  } catch (const InvalidRecord& error) {
    EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
  }
}

TEST(FiledCertificate, Holds) {
  EXPECT_TRUE(read_certificate(DESMO_SOURCE_DIR "/results/certificate.jsonl").holds);
}

}  // namespace
}  // namespace desmo::report::certificate_test
