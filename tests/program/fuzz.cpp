// Spoilt files: what the fuzzer needs to be worth its name, and a short run of it. A long one:
// desmo_fuzz --inputs 100000.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/fuzz/campaign.h"
#include "tests/fuzz/mutator.h"

namespace desmo::fuzz::fuzz_test {
namespace {

const std::filesystem::path corpus = DESMO_SOURCE_DIR "/tests/fuzz/corpus";

TEST(Fuzz, EveryFileOfTheCorpusIsSolvedWithEveryFormulation) {
  for (const Sample& sample : load_corpus(corpus)) {
    const Campaign c = replay(with_few_units(sample.text, 1), corpus);
    EXPECT_EQ(c.outcomes.back(), std::ssize(variants())) << sample.name << "\n" << report(c);
  }
}

// Inputs that were handled badly once.
TEST(Fuzz, FindingsStayRepaired) {
  for (const Sample& sample : load_folder(corpus / "findings")) {
    const Campaign c = replay(sample.text, corpus);
    EXPECT_TRUE(c.findings.empty()) << sample.name << "\n" << report(c);
  }
}

TEST(Fuzz, InputsDependOnSeedAndNumberAlone) {
  const std::vector<Sample> samples = load_corpus(corpus);
  const std::string third = make_input(samples, 5, 3);
  EXPECT_EQ(make_input(samples, 5, 3), third);
  EXPECT_NE(make_input(samples, 5, 4), third);
  EXPECT_NE(make_input(samples, 6, 3), third);
}

TEST(Fuzz, SizesOfScalableMechanismsAreCut) {
  EXPECT_EQ(with_few_units(R"({"axles": 100000, "dyads":2})", 3), R"({"axles": 3, "dyads":2})");
  EXPECT_EQ(with_few_units(R"({"dyads" : 1e5, "axles": )", 3), R"({"dyads" : 3, "axles": )");
}

// The sizes that are cut elsewhere.
TEST(Fuzz, SizesBeyondTheLimitsAreRefused) {
  for (const char* model : {R"({"generator": "four_bar", "dyads": 100001})",
                            R"({"generator": "four_bar", "dyads": 1e99})",
                            R"({"generator": "truck_suspension", "axles": 4294967297})"}) {
    const std::string scene =
        R"({"format": "desmo-scene", "version": 1, "mechanism": )" + std::string(model) + "}";
    EXPECT_EQ(attempt(scene, corpus, variants().front()), TrialOutcome::refused_as_file) << model;
  }
}

TEST(Fuzz, SpoiltFilesAreRefusedOrSolvedAndReachEveryStage) {
  Options options;
  options.corpus = corpus;
  options.inputs = DESMO_FUZZ_INPUTS;
  const Campaign c = run(options);
  EXPECT_TRUE(c.findings.empty()) << report(c);
  // A mutator whose inputs never get far tests a parser only.
  EXPECT_GT(c.outcomes.back(), options.inputs / 10) << report(c);
  for (const TrialOutcome outcome : {TrialOutcome::refused_as_file,
                                     TrialOutcome::refused_as_mechanism, TrialOutcome::not_solved})
    EXPECT_GT(c.outcomes[static_cast<std::size_t>(outcome)], options.inputs / 100) << report(c);
}

}  // namespace
}  // namespace desmo::fuzz::fuzz_test
