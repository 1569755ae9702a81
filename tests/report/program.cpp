#include "tests/report/program.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "tests/report/sample.h"

namespace desmo::report {

namespace fs = std::filesystem;

void Program::SetUp() {
  std::string pattern = (fs::temp_directory_path() / "desmo_report_XXXXXX").string();
  ASSERT_NE(mkdtemp(pattern.data()), nullptr);
  folder_ = pattern;
}

void Program::TearDown() { fs::remove_all(folder_); }

int Program::shell(const std::string& command) {
  const std::string out = (folder_ / "stdout").string(), err = (folder_ / "stderr").string();
  const int status = std::system(("{ " + command + "; } >" + out + " 2>" + err).c_str());
  out_ = read_text(out);
  err_ = read_text(err);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string Program::write(const std::string& name, const std::string& text) {
  const fs::path file = folder_ / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
  return file.string();
}

int Program::report(const std::string& arguments) {
  return shell(std::string(DESMO_REPORT_PROGRAM) + " " + arguments);
}

int Program::tables(const fs::path& record, const std::string& options) {
  return report("tables " + data_file(record).string() + " " + options);
}

std::map<std::string, std::string> Program::files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      files[entry.path().filename()] = read_text(entry.path());
  return files;
}

}  // namespace desmo::report
