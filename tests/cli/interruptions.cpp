// Runs that end early, or cannot write: they leave nothing half-written.

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/cli/program.h"

namespace desmo::interruptions_test {
namespace {

namespace fs = std::filesystem;

/// More than anybody waits for.
const std::string endless = slider_crank(150, R"(, "time": {"end": 5000, "step": 0.00001})");

TEST_F(Cli, InterruptedRunsLeaveNothing) {
  write("endless.json", endless);
  const auto output_grows = [&] {
    return std::ranges::any_of(fs::directory_iterator(folder_ / "out"), [](const auto& entry) {
      return entry.path().filename() != "motion.csv" && entry.file_size() > 0;
    });
  };
  const std::string solve = DESMO_CLI " solve endless.json --quiet -o out/motion.csv";
  EXPECT_EQ(interrupt(solve, SIGINT, output_grows), 130);
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  std::ofstream(out("motion.csv")) << "kept";
  EXPECT_EQ(interrupt(solve, SIGTERM, output_grows), 143);
  EXPECT_EQ(text_of(out("motion.csv")), "kept");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), {}), 1);
}

TEST_F(Cli, OutputThatCannotBeWritten) {
  expect_said(74, "solve slider_crank -o /dev/full",
              "/dev/full: cannot be written (No space left on device)");
  EXPECT_EQ(desmo("solve slider_crank >/dev/full"), 74);
  EXPECT_EQ(desmo("list >/dev/full"), 74);
  EXPECT_EQ(desmo("--help >/dev/full"), 74);
  EXPECT_EQ(desmo("solve slider_crank >&-"), 74);
  expect_said(74, "solve slider_crank -o nowhere/motion.csv",
              "desmo: nowhere/motion.csv: cannot be written");
  EXPECT_EQ(desmo("solve slider_crank -o out"), 74);
  EXPECT_EQ(desmo("solve slider_crank -o ''"), 64);
  // No file may grow beyond 8 blocks: as on a full disk.
  EXPECT_EQ(
      shell("sh -c 'ulimit -f 8; exec " DESMO_CLI " solve slider_crank --quiet -o out/motion.csv'"),
      74);
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  EXPECT_EQ(desmo("solve slider_crank --quiet -o /dev/null"), 0);
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST_F(Cli, WritesThroughLinksAndKeepsPermissions) {
  std::ofstream(out("real.csv")) << "old";
  fs::permissions(out("real.csv"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.csv", out("link.csv"));
  ASSERT_EQ(desmo("solve slider_crank --quiet -o out/link.csv"), 0) << err_;
  EXPECT_TRUE(fs::is_symlink(out("link.csv")));
  EXPECT_TRUE(text_of(out("real.csv")).starts_with("t [s],"));
  EXPECT_EQ(fs::status(out("real.csv")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  // A link to a link to a file that is yet to be, in another folder.
  fs::create_directory(out("there"));
  fs::create_symlink("there/link.csv", out("dangling.csv"));
  fs::create_symlink("new.csv", out("there/link.csv"));
  ASSERT_EQ(desmo("solve slider_crank --quiet -o out/dangling.csv"), 0) << err_;
  EXPECT_TRUE(fs::is_symlink(out("dangling.csv")) && fs::is_symlink(out("there/link.csv")));
  EXPECT_TRUE(text_of(out("there/new.csv")).starts_with("t [s],"));
  fs::create_symlink("circle.csv", out("circle.csv"));
  EXPECT_EQ(desmo("solve slider_crank --quiet -o out/circle.csv"), 74);
  fs::create_symlink("nowhere/new.csv", out("lost.csv"));
  EXPECT_EQ(desmo("solve slider_crank --quiet -o out/lost.csv"), 74);
  EXPECT_TRUE(fs::is_symlink(out("lost.csv")));
}

TEST_F(Cli, WritesIntoThePipeThatALinkLeadsTo) {
  EXPECT_EQ(shell("{ " DESMO_CLI
                  " solve slider_crank --quiet -o /dev/stdout; echo $? >code; } | cat >piped.csv"),
            0);
  EXPECT_EQ(text_of(folder_ / "code"), "0\n") << err_;
  EXPECT_TRUE(text_of(folder_ / "piped.csv").starts_with("t [s],"));
}

TEST_F(Cli, EndsQuietlyWhenNobodyReads) {
  EXPECT_EQ(shell("{ " DESMO_CLI " solve four_bar:40 --quiet; echo $? >code; } | head -n 1"), 0);
  EXPECT_EQ(text_of(folder_ / "code"), "141\n");
  EXPECT_EQ(err_, "");
}

}  // namespace
}  // namespace desmo::interruptions_test
