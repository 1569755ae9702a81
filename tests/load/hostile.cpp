// Names and folders that mean harm.

#include <unistd.h>

#include <cmath>
#include <string_view>

#include "tests/load/loading.h"

namespace desmo::load::hostile_test {
namespace {

constexpr std::string_view evil =
    "x */ }\n#include \"/etc/passwd\"\r\n?\?/\\\n\" '; $(touch pwned) `touch pwned` ../../pwned "
    "%n ";

/// The mechanism with these names for everything that has one, none of them twice.
Model renamed(Model m, std::string_view name) {
  int number = 0;
  const auto next = [&] { return std::string(name) + std::to_string(number++); };
  m.name = next();
  for (Entity& e : m.entities) e.name = next();
  for (Constraint& c : m.constraints) c.name = next();
  for (Group& g : m.groups) {
    g.name = next();
    for (std::string& body : g.bodies) body = next();
  }
  return m;
}

using Hostile = Loading;

TEST_F(Hostile, NamesDoNotGetIntoCodeOrItsName) {
  const Model plain = model_;
  model_ = renamed(plain, evil);
  ASSERT_EQ(load().problem, "");
  EXPECT_EQ(compilations(), 1);
  EXPECT_FALSE(fs::exists(folder_ / "pwned"));
  EXPECT_FALSE(fs::exists(cache() / "pwned"));
  model_ = plain;
  const GenerationOutcome own = load();
  EXPECT_EQ(own.problem, "");
  EXPECT_FALSE(own.compiled) << "it is the same code";
  ASSERT_EQ(cached("").size(), 2u);
  for (const fs::path& file : cached("")) {
    EXPECT_EQ(file.stem().string().find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(file.stem().string().size(), 64u);
  }
  const std::string source = text_of(cached(".cpp").at(0));
  for (const char* text : {"pwned", "passwd", "?\?/", "theta", "beta"})
    EXPECT_EQ(source.find(text), std::string::npos) << text;
}

TEST_F(Hostile, ValuesThatAreNoNumbersDoNoHarm) {
  model_.constraints.front().constants.assign(model_.constraints.front().constants.size(),
                                              std::nan(""));
  model_.estimate.assign(model_.estimate.size(), std::nan(""));
  EXPECT_NE(load().problem, "");
  EXPECT_EQ(compilations(), 0);
}

using Folders = Loading;

TEST_F(Folders, AreMadeForTheUserAlone) {
  ::setenv("XDG_CACHE_HOME", (folder_ / "new").c_str(), 1);
  ASSERT_EQ(load().problem, "");
  for (const char* made : {"new", "new/desmo", "new/desmo/kernels"})
    EXPECT_EQ(fs::status(folder_ / made).permissions(), fs::perms::owner_all) << made;
  for (const auto& file : fs::directory_iterator(folder_ / "new/desmo/kernels"))
    EXPECT_EQ(file.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << file;
}

TEST_F(Folders, ThatOthersCanReadOrWriteToAreRefused) {
  fs::create_directories(cache());
  fs::permissions(cache(), fs::perms::owner_all | fs::perms::group_read);
  fs::permissions(folder_ / "desmo", fs::perms::owner_all);
  expect_problem(cache().string() + ": is open to others (chmod 700)");
  fs::permissions(folder_ / "desmo", fs::perms::all);
  expect_problem((folder_ / "desmo").string() + ": can be written to by others");
}

TEST_F(Folders, ThatAreLinksAreRefused) {
  fs::create_directories(folder_ / "elsewhere");
  fs::permissions(folder_ / "elsewhere", fs::perms::owner_all);
  fs::create_directory(folder_ / "desmo");
  fs::permissions(folder_ / "desmo", fs::perms::owner_all);
  fs::create_directory_symlink(folder_ / "elsewhere", cache());
  expect_problem(cache().string() + ": is a link or no folder");
  fs::remove_all(folder_ / "desmo");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "desmo");
  expect_problem((folder_ / "desmo").string() + ": is a link or no folder");
}

TEST_F(Folders, OfOthersAreRefused) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
  fs::create_directories(cache());
  fs::permissions(folder_ / "desmo", fs::perms::owner_all);
  fs::permissions(cache(), fs::perms::owner_all);
  ASSERT_EQ(::chown(cache().c_str(), 65534, 65534), 0);
  expect_problem(cache().string() + ": belongs to another user");
}

TEST_F(Folders, ThatCannotBeMadeAreNamed) {
  ::setenv("XDG_CACHE_HOME", (folder_ / "no/such/folder").c_str(), 1);
  expect_problem((folder_ / "no/such/folder").string() + ": cannot be used");
  // A relative one does not count: the home folder's is used.
  ::setenv("XDG_CACHE_HOME", "relative", 1);
  const std::string home = ::getenv("HOME") ? ::getenv("HOME") : "";
  ::setenv("HOME", folder_.c_str(), 1);
  EXPECT_EQ(load().folder, (folder_ / ".cache/desmo/kernels").string());
  ::setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace desmo::load::hostile_test
