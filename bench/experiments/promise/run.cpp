// desmo_bench promise: is every number right, or flagged?
#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bench/experiments/experiments.h"
#include "bench/experiments/promise/tally.h"
#include "bench/kit/record/record.h"
#include "formulations/algebra/blas.h"

namespace desmo::promise {

namespace {

using Json = nlohmann::ordered_json;

constexpr int all_scenes = 1000, quick_scenes = 40;

struct Options : bench::CommonOptions {
  int scenes = 0, seed = 1, threads = 2;
  std::string progress;
  std::optional<int> write_scene;
};

/// The scenes done so far: a line each in a file, after a line that says of what. So a run that was
/// interrupted goes on.
class Progress {
 public:
  /// Reads what is there. A file of another experiment is begun anew. An empty path: no file.
  Progress(const std::string& path, const std::string& head) {
    if (path.empty()) return;
    std::ifstream before(path);
    std::string line;
    if (std::getline(before, line) && line == head)
      while (std::getline(before, line) && !before.eof()) keep(from_json(Json::parse(line)));
    before.close();
    file_.open(path, std::ios::trunc);
    if (!file_) throw std::runtime_error("cannot write '" + path + "'");
    file_ << head << '\n';
    for (const auto& [number, result] : done_) file_ << to_json(result).dump() << '\n';
    file_.flush();
  }

  void add(SceneResult result) {
    const std::lock_guard lock(mutex_);
    if (file_.is_open()) file_ << to_json(result).dump() + '\n' << std::flush;
    std::cerr << "scene " << result.number << ": " << result.family << ", " << result.aim << ": "
              << (result.failure.empty() ? result.verdicts : result.failure) << '\n';
    keep(std::move(result));
  }
  bool has(int number) const { return done_.contains(number); }
  std::vector<SceneResult> results(int scenes) const {
    std::vector<SceneResult> all;
    for (const auto& [number, result] : done_)
      if (number < scenes) all.push_back(result);
    return all;
  }

 private:
  void keep(SceneResult result) { done_[result.number] = std::move(result); }

  std::ofstream file_;
  std::mutex mutex_;
  std::map<int, SceneResult> done_;
};

void run_all(Progress& progress, const Options& options, const std::vector<std::string>& ids) {
  std::vector<int> left;
  for (int i = 0; i < options.scenes; ++i)
    if (!progress.has(i)) left.push_back(i);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i; (i = next++) < left.size();)
      progress.add(run_scene(options.seed, left[i], ids));
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < options.threads; ++i) others.emplace_back(work);
  work();
}

/// Returns the file of the scenes that are done: bench/run keeps it where the next run finds it.
std::string progress_path(const Options& options) {
  if (!options.progress.empty() || options.record.empty()) return options.progress;
  const std::filesystem::path folder = std::filesystem::absolute(options.record).parent_path();
  return (folder.parent_path() / ("promise-" + std::to_string(options.seed) + ".jsonl")).string();
}

}  // namespace

int run(const bench::CommandLine& line) {
  Options options;
  CLI::App parser("desmo_bench promise: is every number right, or flagged?");
  bench::add_common(parser, options,
                    {.quick = std::to_string(quick_scenes) + " scenes",
                     .filtered = "the id of the formulation, with settings",
                     .repetitions = {}});
  parser
      .add_option("--progress", options.progress,
                  "Note each scene that is done, and go on after the last of them; by default "
                  "next to the folder of the record")
      ->type_name("FILE");
  parser
      .add_option("--scenes", options.scenes,
                  "That many (" + std::to_string(all_scenes) + " by default)")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  parser.add_option("--seed", options.seed, "Draw others (1)")->type_name("S");
  parser.add_option("--threads", options.threads, "Scenes at once (2)")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  parser
      .add_option("--write-scene", options.write_scene, "Print the scene file of scene N, and end")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  if (!bench::read(parser, line.arguments)) return 0;
  set_blas_threads(1);
  if (options.write_scene) {
    std::cout << draw_scene(options.seed, *options.write_scene).text;
    return 0;
  }
  if (options.scenes == 0) options.scenes = options.quick ? quick_scenes : all_scenes;
  std::vector<std::string> ids = canonical_ids();
  std::erase_if(ids, [filter = std::regex(options.filter)](const std::string& id) {
    return !std::regex_search(id, filter);
  });
  if (ids.empty()) throw std::invalid_argument("nothing matches --filter");
  const TimeGrid no_grid{0, 1, 1};
  const Json head = bench::record_head(line.text, no_grid)["record"];
  Progress progress(progress_path(options), "seed " + std::to_string(options.seed) + ", " +
                                                std::to_string(ids.size()) + " ids, commit " +
                                                head["commit"].get<std::string>());
  std::optional<bench::RecordWriter> recording;
  if (!options.record.empty()) recording.emplace(options.record, line.text, line.experiment);
  run_all(progress, options, ids);
  const std::vector<SceneResult> results = progress.results(options.scenes);
  print(std::cout, results, ids, options.seed);
  if (recording) recording->write(no_grid, record_lists(results, ids));
  return tally(results, ids).all[static_cast<int>(PromiseVerdict::wrong)] == 0 ? 0 : 1;
}

}  // namespace desmo::promise
