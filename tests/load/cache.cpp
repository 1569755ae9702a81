// Files of the cache that are not as they were written, and several writers.

#include "formulations/runtime/cache.h"

#include <sys/wait.h>
#include <unistd.h>

#include "formulations/model/partition.h"
#include "tests/load/loading.h"

namespace desmo::load::cache_test {
namespace {

using CacheTest = Loading;

TEST_F(CacheTest, KeepsWhatIsWritten) {
  const Cache cache = Cache::open();
  const std::string content("\0 some bytes \xff\n// desmo ", 23);
  EXPECT_FALSE(cache.read("a.so"));
  cache.write("a.so", content);
  EXPECT_EQ(cache.read("a.so"), content);
  cache.write("a.so", "");
  EXPECT_EQ(cache.read("a.so"), "");
  EXPECT_EQ(Cache::open().read("a.so"), "");
}

TEST_F(CacheTest, DoesNotBelieveWhatIsNotAsItWasWritten) {
  const Cache cache = Cache::open();
  const fs::path file = cache.folder() / "a.so";
  const auto refused = [&](const std::string& spoilt) {
    cache.write("a.so", "content");
    write(file, spoilt);
    return !cache.read("a.so");
  };
  cache.write("a.so", "content");
  const std::string good = text_of(file);
  EXPECT_FALSE(refused(good));
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused("content"));
  EXPECT_TRUE(refused(good.substr(1)));
  EXPECT_TRUE(refused(good + "\n"));
  EXPECT_TRUE(refused("C" + good.substr(1)));

  cache.write("a.so", "content");
  fs::copy_file(file, cache.folder() / "b.so");
  EXPECT_FALSE(cache.read("b.so")) << "under another name";
  fs::rename(file, cache.folder() / "c");
  fs::create_symlink("c", file);
  EXPECT_FALSE(cache.read("a.so")) << "a link";
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_FALSE(cache.read("a.so")) << "a folder";
  fs::remove(file);
  cache.write("a.so", "content");
  fs::permissions(file, fs::perms::group_write, fs::perm_options::add);
  EXPECT_FALSE(cache.read("a.so")) << "others can write to it";
  if (::geteuid() == 0) {
    cache.write("a.so", "content");
    ASSERT_EQ(::chown(file.c_str(), 65534, 65534), 0);
    EXPECT_FALSE(cache.read("a.so")) << "of another user";
  }
}

TEST_F(CacheTest, LeavesNothingOfWhatWasNotFinished) {
  const Cache cache = Cache::open();
  const auto fail = [&](const std::string& name) {
    write(cache.folder() / name, "half");
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(cache.content_made_by(fail), std::runtime_error);
  EXPECT_TRUE(cached("").empty());
  EXPECT_THROW(cache.content_made_by([](const std::string&) {}), std::runtime_error);
  EXPECT_EQ(cache.content_made_by(
                [&](const std::string& name) { write(cache.folder() / name, "whole"); }),
            "whole");
  EXPECT_TRUE(cached("").empty());
}

TEST_F(CacheTest, ForgetsTheOldestAndWhatWasAbandoned) {
  const Cache cache = Cache::open();
  const auto now = fs::file_time_type::clock::now();
  write(cache.folder() / "unfinished.1.2", "");
  write(cache.folder() / "unfinished.3.4", "");
  write(cache.folder() / "of the user", "");
  fs::last_write_time(cache.folder() / "unfinished.1.2", now - std::chrono::hours(2));
  for (int i = 0; i < 300; ++i) {
    const fs::path file = cache.folder() / (std::to_string(i) + ".so");
    write(file, "");
    fs::last_write_time(file, now - std::chrono::minutes(i + 1));
  }
  cache.write("new.so", "");
  EXPECT_EQ(cached(".so").size(), 256u);
  EXPECT_TRUE(cache.read("new.so"));
  EXPECT_TRUE(fs::exists(cache.folder() / "0.so"));
  EXPECT_FALSE(fs::exists(cache.folder() / "299.so"));
  EXPECT_FALSE(fs::exists(cache.folder() / "unfinished.1.2"));
  EXPECT_TRUE(fs::exists(cache.folder() / "unfinished.3.4")) << "somebody is at work";
  EXPECT_TRUE(fs::exists(cache.folder() / "of the user"));
}

TEST_F(CacheTest, IsMendedWhereCompiledCodeIsSpoilt) {
  load();
  const fs::path library = cached(".so").at(0);
  const std::string good = text_of(library);
  write(library, good.substr(0, good.size() / 2));
  EXPECT_EQ(load().problem, "");
  EXPECT_EQ(compilations(), 2);
  EXPECT_FALSE(load().compiled);
}

TEST_F(CacheTest, ServesSeveralProcessesAtOnce) {
  const auto solve = [&] {
    KernelTable table;
    const bool good = load(table).problem.empty();
    const auto f = make_formulation(find_variant("group_symbolic_inlined"), model_, {}, table);
    return good && parts_of(*f).back().as_named && f->assemble(0).ok();
  };
  std::vector<pid_t> children;
  for (int i = 0; i < 3; ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) ::_exit(solve() ? 0 : 1);
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(exit_code(status), 0);
  }
  EXPECT_EQ(cached("").size(), 2u) << "one source, one library, nothing unfinished";
  EXPECT_FALSE(load().compiled);
}

}  // namespace
}  // namespace desmo::load::cache_test
