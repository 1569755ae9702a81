#include "tests/fuzz/campaign.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <new>
#include <ranges>
#include <stdexcept>

#include "cases/mechanism/formatted.h"
#include "formulations/runtime/process.h"
#include "tests/fuzz/mutator.h"

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>
#endif

namespace desmo::fuzz {
namespace {

constexpr int cpu_limit = 10, wall_limit = 300;  // s, of one input; generous for slow machines
constexpr long inputs_a_child = 500;             // leaks are looked for after as many
constexpr int saved_of_a_kind = 3;
enum ExitCode { done = 0, found = 10, leaked = 11 };

/// Memory in which a child tells its parent how far it got, even when it dies.
struct Board {
  long input;
  std::array<long, outcome_names.size()> outcomes;
  char finding[4000];
};

/// Returns a board that this process and its children share; never freed.
Board& shared_board() {
  void* const memory =
      ::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  return *new (memory) Board{};
}

std::string text_of(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char buffer[4096];
  while (const std::size_t size = std::fread(buffer, 1, sizeof buffer, file))
    text.append(buffer, size);
  return text;
}

// The signals end the process: where it loops, nothing in it can be relied on.
void limit_time() {
  const itimerval cpu{{0, 0}, {cpu_limit, 0}};
  ::setitimer(ITIMER_PROF, &cpu, nullptr);
  ::alarm(wall_limit);
}

using Try = std::function<TrialOutcome(long)>;

[[noreturn]] void be_child(long first, long last, const Try& attempt_input, Board& board,
                           std::FILE* log) {
  ::dup2(::fileno(log), STDERR_FILENO);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  for (long i = first; i < last; ++i) {
    board.input = i;
    limit_time();
    try {
      ++board.outcomes[static_cast<std::size_t>(attempt_input(i))];
    } catch (const std::exception& finding) {
      std::snprintf(board.finding, sizeof board.finding, "%s", finding.what());
      ::_exit(found);
    }
  }
#if defined(__SANITIZE_ADDRESS__)
  if (__lsan_do_recoverable_leak_check() != 0) ::_exit(leaked);
#endif
  ::_exit(done);
}

/// Tries the inputs in a child process. Returns its wait status, and what it wrote.
std::pair<int, std::string> run_child(long first, long last, const Try& attempt_input,
                                      Board& board) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> log(std::tmpfile(), std::fclose);
  if (!log) throw std::runtime_error("no temporary file can be made");
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) be_child(first, last, attempt_input, board, log.get());
  int status = 0;
  load::wait_for_end(child, status);
  return {status, text_of(log.get())};
}

// The line of a sanitizer's report that says what and where.
std::string headline(const std::string& report) {
  for (const char* mark : {"runtime error: ", "SUMMARY: ", "ERROR: ", "Assertion"})
    if (const std::size_t at = report.find(mark); at != report.npos) {
      const std::size_t before = report.rfind('\n', at);
      const std::size_t begin = before == report.npos ? 0 : before + 1;
      return report.substr(begin, report.find('\n', at) - begin);
    }
  return report.substr(0, report.find('\n'));
}

/// Returns the class and the detail of what ended a child.
std::pair<std::string, std::string> finding_of(int status, const Board& board,
                                               const std::string& written) {
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (code == found) {
    const std::string text = board.finding;
    const std::size_t line_end = text.find('\n');
    return {text.substr(0, line_end), text.substr(line_end + 1)};
  }
  if (signal == SIGPROF || signal == SIGALRM)
    return {"more than " + std::to_string(cpu_limit) + " s of CPU", written};
  if (code == leaked) return {"leak: " + headline(written), written};
  const std::string how =
      signal ? "signal " + std::to_string(signal) : "exit code " + std::to_string(code);
  return {how + ": " + headline(written), written};
}

/// Calls `attempt_input` of first … last - 1.
Campaign try_all(long first, long last, const Try& attempt_input, bool progress) {
  static Board& board = shared_board();
  Campaign campaign;
  for (long next = first; next < last;) {
    const long end = std::min(last, next + inputs_a_child);
    board = {};
    const auto [status, written] = run_child(next, end, attempt_input, board);
    for (std::size_t k = 0; k < outcome_names.size(); ++k)
      campaign.outcomes[k] += board.outcomes[k];
    next = end;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != done) {
      const auto [kind, detail] = finding_of(status, board, written);
      Campaign::Kind& known = campaign.findings[kind];
      if (known.inputs.empty()) known.detail = detail;
      known.inputs.push_back(board.input);
      next = board.input + 1;
    }
    if (progress)
      std::fprintf(stderr, "%ld inputs, %zu classes of findings\n", next - first,
                   campaign.findings.size());
  }
  return campaign;
}

Random random_of(std::uint64_t seed, long i) {
  Random of_seed(seed);
  return Random(of_seed.bits() + static_cast<std::uint64_t>(i));
}

/// Returns the formulation that solves an input.
const Variant& variant_of(std::uint64_t seed, long i) {
  Random random = random_of(~seed, i);
  const auto table = variants();
  return random.pick(table);
}

}  // namespace

std::string make_input(const std::vector<Sample>& corpus, std::uint64_t seed, long i) {
  static const std::vector<Json> documents = [&] {
    std::vector<Json> all;
    for (const Sample& sample : corpus) all.push_back(Json::parse(sample.text));
    return all;
  }();
  Random random = random_of(seed, i);
  return mutated(documents, random);
}

Campaign run(const Options& o) {
  const std::vector<Sample> corpus = load_corpus(o.corpus);
  const auto attempt_input = [&](long i) {
    return attempt(make_input(corpus, o.seed, i), o.corpus, variant_of(o.seed, i));
  };
  Campaign campaign = try_all(o.first, o.first + o.inputs, attempt_input, o.progress);
  if (o.save.empty()) return campaign;
  std::filesystem::create_directories(o.save);
  for (const auto& [kind, found] : campaign.findings)
    for (const long i : found.inputs | std::views::take(saved_of_a_kind))
      std::ofstream(o.save / formatted("%llu_%ld.json", static_cast<unsigned long long>(o.seed), i),
                    std::ios::binary)
          << make_input(corpus, o.seed, i);
  return campaign;
}

Campaign replay(const std::string& text, const std::filesystem::path& folder) {
  const auto attempt_input = [&](long i) {
    return attempt(text, folder, variants()[static_cast<std::size_t>(i)]);
  };
  return try_all(0, static_cast<long>(variants().size()), attempt_input, false);
}

std::string report(const Campaign& campaign) {
  std::string text;
  for (std::size_t k = 0; k < outcome_names.size(); ++k)
    text += formatted("%8ld %s\n", campaign.outcomes[k], outcome_names[k]);
  for (const auto& [kind, of_kind] : campaign.findings)
    text += formatted("FINDING, %zu times, first input %ld: %s\n  %s\n", of_kind.inputs.size(),
                      of_kind.inputs.front(), kind.c_str(), of_kind.detail.substr(0, 1500).c_str());
  return text;
}

}  // namespace desmo::fuzz
