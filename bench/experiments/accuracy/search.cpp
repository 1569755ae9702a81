#include "bench/experiments/accuracy/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <span>

#include "bench/experiments/accuracy/settings_grid.h"
#include "bench/kit/variant_costs.h"

namespace desmo::accuracy {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double min_sample = 2e-3;  // least duration of a sample [s]
constexpr int dense_limit = 114;     // most coordinates (≤) of dense global solves, O(n³) a step
// Ratios of times (≤) at which the slower of two may yet prove the faster:
constexpr double max_ratio_of_formulations = 1.6;  // with other settings
constexpr double max_ratio_of_samples = 1.5;       // with further samples
constexpr double max_ratio_of_motions = 1.25;      // on the whole motion instead of its beginning
constexpr std::size_t finalists = 16;  // number of trials in a batch: sampled anew, chosen from
constexpr std::size_t max_tried_on_whole = 100;  // with a budget: trials on the whole motion (≤)

/// Returns settings that tell formulations apart: the paper's, and those that usually cost least.
std::vector<Settings> telling_settings() {
  return {Settings{},
          {.tolerance = 1e-8, .guess = Guess::adams8, .jacobian = JacobianUpdate::step}};
}

class Searcher {
 public:
  Searcher(const TunedMotion& motion, const Goal& goal, const SearchOptions& options)
      : whole_(motion.whole), beginning_(motion.beginning), goal_(goal), options_(options) {}

  SearchResult run() {
    std::list<Trial> trials;
    for (const Variant* v : formulations())
      for (const Settings& s : full_settings(*v)) add(trials, beginning_, *v, s);
    say(std::to_string(trials.size()) + " configurations");
    for (Trial& t : trials) t.verify();
    for (Trial& t : trials) t.time(min_sample);
    std::vector<Trial*> hopeful;
    for (Trial& t : trials)
      if (meets_goal(t)) hopeful.push_back(&t);
    decide(hopeful);
    for (const Trial& t : trials) found_.tried.push_back(tried(t, false));
    std::ranges::stable_sort(found_.tried, {}, &TriedConfiguration::seconds);
    return std::move(found_);
  }

 private:
  void say(const std::string& what) const {
    if (options_.say) options_.say(what);
  }

  static void add(std::list<Trial>& trials, const Problem& problem, const Variant& v,
                  const Settings& s) {
    if (unsupported_reason(v, s).empty()) trials.emplace_back(problem, Configuration{&v, s});
  }

  /// Returns the formulations that may be the fastest with some settings: with one of the telling
  /// settings they are nearly as fast as the fastest.
  std::vector<const Variant*> formulations() {
    std::vector<const Variant*> all = options_.formulations, kept;
    if (all.empty())
      for (const Variant& v : variants())
        if (!bench::is_dense_global(v) || whole_.plan.model.coordinates() <= dense_limit)
          all.push_back(&v);
    say(std::to_string(all.size()) + " formulations");
    for (const Settings& s : telling_settings()) {
      std::list<Trial> trials;
      for (const Variant* v : all) add(trials, beginning_, *v, s);
      for (Trial& t : trials) t.verify();
      for (int round = 0; round < 2; ++round)
        for (Trial& t : trials) t.time(min_sample);
      double best = infinity;
      for (const Trial& t : trials) best = std::min(best, t.min_seconds());
      for (const Trial& t : trials)
        if (t.min_seconds() <= max_ratio_of_formulations * best &&
            std::ranges::find(kept, t.configuration().variant) == kept.end())
          kept.push_back(t.configuration().variant);
    }
    return kept;
  }

  double error(const Trial& t) const {
    return t.is_verified() ? t.error[goal_.level].max : infinity;
  }
  bool meets_goal(const Trial& t) const {
    if (!t.is_verified()) return false;
    return goal_.budget > 0 ? t.min_seconds() <= goal_.budget
                            : error(t) <= goal_.max_error / error_margin;
  }

  /// Returns the error in whole half decades, so that effects of rounding do not decide.
  double error_class(const Trial& t) const { return std::round(2 * std::log10(error(t))); }

  /// Returns whether another trial may prove better than the best one on the whole motion.
  bool is_indistinct(const Trial& best, const Trial& other) const {
    return other.min_seconds() <= max_ratio_of_motions * best.min_seconds() &&
           (goal_.budget == 0 || error_class(other) <= error_class(best));
  }

  /// Sorts trials by time or, with a budget, by error class and then by time.
  void sort(std::vector<Trial*>& trials) const {
    const auto time = [](const Trial* t) { return t->min_seconds(); };
    std::ranges::stable_sort(trials, {}, time);
    if (goal_.budget > 0)
      std::ranges::stable_sort(trials, {}, [&](const Trial* t) { return error_class(*t); });
  }

  /// Samples the times of the best trials again, in turn, and tries these on the whole motion,
  /// until one meets the goal there.
  void decide(std::vector<Trial*> hopeful) {
    sample_again(hopeful);
    sort(hopeful);
    std::list<Trial> on_the_whole;
    if (goal_.budget > 0) {
      hopeful = tried_on_the_whole(hopeful, on_the_whole);
      sort(hopeful);
    }
    for (std::size_t first = 0; first < hopeful.size() && !found_.choice; first += finalists) {
      const std::size_t last = std::min(hopeful.size(), first + finalists);
      std::vector<Trial*> batch(hopeful.begin() + static_cast<std::ptrdiff_t>(first),
                                hopeful.begin() + static_cast<std::ptrdiff_t>(last));
      say("the best " + std::to_string(batch.size()) + " once more, and over the whole motion");
      for (int round = 0; round < options_.rounds; ++round)
        for (Trial* t : batch) t->time(min_sample);
      sort(batch);
      choose_on_whole(batch);
    }
  }

  /// Samples the fastest trials twice more: one disturbed sample must not keep a trial out.
  void sample_again(const std::vector<Trial*>& hopeful) const {
    double best = infinity;
    for (const Trial* t : hopeful) best = std::min(best, t->min_seconds());
    for (int round = 0; round < 2; ++round)
      for (Trial* t : hopeful)
        if (t->min_seconds() <= max_ratio_of_samples * best) t->time(min_sample);
  }

  Trial& try_on_whole(std::list<Trial>& trials, const Trial& on_beginning) {
    Trial& trial = trials.emplace_back(whole_, on_beginning.configuration());
    trial.verify();
    trial.time(min_sample);
    return trial;
  }

  /// Tries the first trials on the whole motion, since the most accurate on its beginning need not
  /// be so later. Returns those that meet the goal there.
  std::vector<Trial*> tried_on_the_whole(const std::vector<Trial*>& hopeful,
                                         std::list<Trial>& trials) {
    std::vector<Trial*> kept;
    for (const Trial* t : std::span(hopeful).first(std::min(hopeful.size(), max_tried_on_whole))) {
      Trial& trial = try_on_whole(trials, *t);
      if (meets_goal(trial)) kept.push_back(&trial);
    }
    return kept;
  }

  /// Chooses from a batch that is sorted best first. On the whole motion it tries the trials up to
  /// the first one that meets the goal there, and those that are indistinct from it. It chooses the
  /// best of all that meet the goal.
  void choose_on_whole(const std::vector<Trial*>& batch) {
    std::list<Trial> trials;
    std::vector<Trial*> holding;
    const Trial* first = nullptr;
    for (const Trial* t : batch) {
      if (first && !is_indistinct(*first, *t)) break;
      Trial& trial = try_on_whole(trials, *t);
      if (!meets_goal(trial)) continue;
      holding.push_back(&trial);
      if (!first) first = t;
    }
    for (int round = 0; round < options_.rounds; ++round)
      for (Trial* t : holding) t->time(min_sample);
    for (const Trial& t : trials) found_.tried.push_back(tried(t, true));
    if (holding.empty()) return;
    sort(holding);
    choose(*holding.front());
  }

  void choose(Trial& best) {
    Trial usual(whole_, {best.configuration().variant, Settings{}});
    usual.verify();
    for (int round = 0; round < options_.rounds; ++round) usual.time(min_sample);
    found_.choice = best.configuration();
    found_.error = best.error;
    found_.seconds = best.min_seconds();
    found_.usual_seconds = usual.min_seconds();
  }

  TriedConfiguration tried(const Trial& t, bool whole) const {
    return {t.id(), error(t), t.min_seconds(), whole};
  }

  const Problem &whole_, &beginning_;
  const Goal& goal_;
  const SearchOptions& options_;
  SearchResult found_;
};

}  // namespace

TunedMotion make_tuned_motion(const Plan& plan, const TimeGrid& grid) {
  constexpr int first_instants = 101;
  // More than most motions have. Errors are largest at instants where the prediction alone meets
  // the tolerance, which may be rare.
  constexpr int compared = 1001;
  TimeGrid beginning = grid;
  beginning.instants = std::min(grid.instants, first_instants);
  return {bench::make_problem(plan, grid, compared),
          bench::make_problem(plan, beginning, first_instants / 2)};
}

SearchResult search(const TunedMotion& motion, const Goal& goal, const SearchOptions& options) {
  return Searcher(motion, goal, options).run();
}

}  // namespace desmo::accuracy
