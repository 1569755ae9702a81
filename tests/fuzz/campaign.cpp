#include "tests/fuzz/campaign.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <new>
#include <stdexcept>

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

/// What a child tells its parent, even when it dies.
struct Board {
  long input;
  long outcomes[outcome_names.size()];
  double slowest;
  long slowest_input;
  char finding[4000];
};

class Shared {
 public:
  Shared()
      : memory_(::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS,
                       -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::bad_alloc();
  }
  ~Shared() { ::munmap(memory_, sizeof(Board)); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;
  Board* operator->() const { return static_cast<Board*>(memory_); }

 private:
  void* memory_;
};

/// What children write on standard error.
class Log {
 public:
  Log() : file_(std::tmpfile()) {
    if (!file_) throw std::runtime_error("no temporary file can be made");
  }
  ~Log() { std::fclose(file_); }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  void take_standard_error() const { ::dup2(::fileno(file_), STDERR_FILENO); }
  std::string take_text() const {
    std::string text;
    std::rewind(file_);
    char buffer[4096];
    while (const std::size_t size = std::fread(buffer, 1, sizeof buffer, file_))
      text.append(buffer, size);
    if (::ftruncate(::fileno(file_), 0) != 0) throw std::runtime_error("the log stays as it is");
    std::rewind(file_);
    return text;
  }

 private:
  std::FILE* file_;
};

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// The signals end the process: where it loops, nothing in it can be relied on.
void limit_time() {
  const itimerval cpu{{0, 0}, {cpu_limit, 0}};
  ::setitimer(ITIMER_PROF, &cpu, nullptr);
  ::alarm(wall_limit);
}

using Try = std::function<TrialOutcome(long)>;

[[noreturn]] void be_child(long first, long last, const Try& attempt_input, const Shared& board,
                           const Log& log) {
  log.take_standard_error();
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  for (long i = first; i < last; ++i) {
    board->input = i;
    limit_time();
    const double start = cpu_now();
    try {
      ++board->outcomes[static_cast<std::size_t>(attempt_input(i))];
    } catch (const std::exception& finding) {
      std::snprintf(board->finding, sizeof board->finding, "%s", finding.what());
      ::_exit(found);
    }
    if (const double seconds = cpu_now() - start; seconds > board->slowest) {
      board->slowest = seconds;
      board->slowest_input = i;
    }
  }
#if defined(__SANITIZE_ADDRESS__)
  if (__lsan_do_recoverable_leak_check() != 0) ::_exit(leaked);
#endif
  ::_exit(done);
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

/// The class and the detail of what ended a child.
std::pair<std::string, std::string> finding_of(int status, const Shared& board,
                                               const std::string& written) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == found) {
    const std::string text = board->finding;
    const std::size_t line_end = std::min(text.find('\n'), text.size());
    return {text.substr(0, line_end), text.substr(std::min(line_end + 1, text.size()))};
  }
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGALRM))
    return {"more than " + std::to_string(cpu_limit) + " s of CPU", written};
  if (WIFEXITED(status) && WEXITSTATUS(status) == leaked)
    return {"leak: " + headline(written), written};
  const std::string how = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                              : "exit code " + std::to_string(WEXITSTATUS(status));
  return {how + ": " + headline(written), written};
}

void add(const Shared& board, Campaign& campaign) {
  for (std::size_t k = 0; k < outcome_names.size(); ++k) campaign.outcomes[k] += board->outcomes[k];
  if (board->slowest <= campaign.slowest) return;
  campaign.slowest = board->slowest;
  campaign.slowest_input = board->slowest_input;
}

using OnFinding = std::function<void(long input, long earlier_of_its_kind)>;

/// Calls `attempt_input` of first … last - 1.
Campaign try_all(long first, long last, const Try& attempt_input, const OnFinding& on_finding,
                 bool progress) {
  Campaign campaign;
  const Shared board;
  const Log log;
  const auto start = std::chrono::steady_clock::now();
  long last_told = first;
  for (long next = first; next < last;) {
    const long end = std::min(last, next + inputs_a_child);
    new (board.operator->()) Board{};
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process can be started");
    if (child == 0) be_child(next, end, attempt_input, board, log);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    add(board, campaign);
    const std::string written = log.take_text();
    next = end;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != done) {
      const auto [kind, detail] = finding_of(status, board, written);
      Campaign::Kind& known = campaign.findings[kind];
      if (known.count == 0) {
        known.first = board->input;
        known.detail = detail;
      }
      on_finding(board->input, known.count++);
      next = board->input + 1;
    }
    if (progress && (next - last_told >= 1000 || next >= last)) {
      last_told = next;
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      std::fprintf(stderr, "%ld inputs, %.0f s, %zu classes of findings\n", next - first,
                   seconds.count(), campaign.findings.size());
    }
  }
  return campaign;
}

Random random_of(std::uint64_t seed, long i) {
  Random of_seed(seed);
  return Random(of_seed.next() + static_cast<std::uint64_t>(i));
}

}  // namespace

std::string make_input(const std::vector<Sample>& corpus, std::uint64_t seed, long i) {
  static const Mutator mutator(corpus);
  Random random = random_of(seed, i);
  return mutator.make(random);
}

const Variant& variant_of(std::uint64_t seed, long i) {
  Random random = random_of(~seed, i);
  const auto table = variants();
  return random.pick(table);
}

Campaign run(const Options& o) {
  const std::vector<Sample> corpus = load_corpus(o.corpus);
  const auto input = [&](long i) { return make_input(corpus, o.seed, i); };
  const auto save = [&](long i, long earlier_of_its_kind) {
    if (o.save.empty() || earlier_of_its_kind >= saved_of_a_kind) return;
    std::filesystem::create_directories(o.save);
    const std::string name = std::to_string(o.seed) + "_" + std::to_string(i) + ".json";
    std::ofstream(o.save / name, std::ios::binary) << input(i);
  };
  const auto attempt_input = [&](long i) {
    return attempt(input(i), o.corpus, variant_of(o.seed, i));
  };
  return try_all(o.first, o.first + o.inputs, attempt_input, save, o.progress);
}

Campaign replay(const std::string& text, const std::filesystem::path& folder) {
  const auto attempt_input = [&](long i) {
    return attempt(text, folder, variants()[static_cast<std::size_t>(i)]);
  };
  return try_all(
      0, static_cast<long>(variants().size()), attempt_input, [](long, long) {}, false);
}

std::string report(const Campaign& campaign) {
  std::string text;
  char line[200];
  for (std::size_t k = 0; k < outcome_names.size(); ++k) {
    std::snprintf(line, sizeof line, "%8ld %s\n", campaign.outcomes[k], outcome_names[k]);
    text += line;
  }
  std::snprintf(line, sizeof line, "slowest: %.2f s of CPU, input %ld\n", campaign.slowest,
                campaign.slowest_input);
  text += line;
  for (const auto& [kind, of_kind] : campaign.findings)
    text += "FINDING, " + std::to_string(of_kind.count) + " times, first input " +
            std::to_string(of_kind.first) + ": " + kind + "\n  " + of_kind.detail.substr(0, 1500) +
            "\n";
  return text;
}

}  // namespace desmo::fuzz
