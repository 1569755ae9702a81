#include "bench/kit/process/own_process.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "formulations/runtime/process.h"

namespace desmo::bench {

using Json = nlohmann::ordered_json;

namespace {

using File = std::unique_ptr<std::FILE, decltype([](std::FILE* f) { std::fclose(f); })>;

std::runtime_error system_error(const std::string& what) {
  return std::runtime_error(what + ": " + std::strerror(errno));
}

void write(std::FILE* file, const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size() || std::fflush(file) != 0)
    throw system_error("cannot keep what was measured");
}

[[noreturn]] void be_the_process(const std::string& name, const std::function<Json()>& work,
                                 std::FILE* answer) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // ends with its parent, which alone waits for it
  int code = 0;
  try {
    write(answer, work().dump());
  } catch (const std::exception& e) {
    std::cerr << name << ": " << e.what() << '\n';
    code = 1;
  }
  std::cout.flush();
  std::fflush(nullptr);
  _exit(code);  // without destructors: objects copied from the parent are the parent's to end
}

}  // namespace

Json in_own_process(const std::string& name, const std::function<Json()>& work) {
  const File answer(std::tmpfile());
  if (!answer) throw system_error("no temporary file");
  std::cout.flush();
  std::fflush(nullptr);  // or both processes would write what is buffered
  const pid_t process = fork();
  if (process < 0) throw system_error("no process for " + name);
  if (process == 0) be_the_process(name, work, answer.get());

  int status = 0;
  if (!load::wait_for_end(process, status)) throw system_error("lost the process of " + name);
  if (WIFSIGNALED(status))
    throw std::runtime_error(name + ": its process was ended by signal " +
                             std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) +
                             ")");
  if (WEXITSTATUS(status) != 0) throw std::runtime_error(name + " was not measured");
  std::rewind(answer.get());
  return Json::parse(answer.get());
}

}  // namespace desmo::bench
