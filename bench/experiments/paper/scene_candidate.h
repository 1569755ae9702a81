#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/experiments/paper/extended_ids.h"
#include "bench/experiments/paper/options.h"
#include "bench/kit/formulation_candidate.h"

namespace desmo::paper {

/// A scene of the user's own, as the problem that is its whole mechanism's motion. Shared by its
/// candidates.
class MeasuredScene {
 public:
  /// Throws UnreadableFile and InputError, naming the file, for one that cannot be read or says
  /// something wrong, and std::invalid_argument where its name is that of a case of the suite.
  MeasuredScene(const std::string& file, const Options& options);

  /// Returns the file's name without its endings, as <case> of the benchmark's name and of a
  /// record: characters that it must not have are "_".
  const std::string& name() const { return name_; }
  const Problem& problem() const { return problem_; }

  /// Generates the code that a formulation needs and the program lacks, and adds it to the
  /// problem's. Returns why there is none, the same as when it was first asked; empty: there is.
  std::string add_code(const Configuration& configuration);

 private:
  std::string name_;
  Problem problem_;
  std::map<std::string, std::string> problems_;  // of code, by what it is generated for
};

/// A user's scene with one formulation, and the paper's settings where no others are named: neither
/// the scene's formulation nor its tolerance counts.
class SceneCandidate final : public FormulationCandidate {
 public:
  /// Refuses the candidate (Refusal::Kind::not_run), with the reason, where it would be too costly.
  SceneCandidate(std::shared_ptr<MeasuredScene> scene, const TimedConfiguration& configuration,
                 const Options& options);

  void add_to(nlohmann::ordered_json& lists) const override;

 private:
  const Problem& problem() const override { return scene_->problem(); }
  /// Does not run a formulation that has no code here, or whose settings it cannot have.
  Checked check(ReferenceCache& references, VerifyingRun& found) override;
  /// Differences are relative to the mechanism's size, speed and acceleration: its unit of length
  /// may be any.
  std::vector<Compared> compared(std::span<const ReferenceInstant> reference) const override;
  Summary run(Formulation& formulation, Observer& observer) const override;

  const std::shared_ptr<MeasuredScene> scene_;
  const CheckMode check_;
};

/// Returns every scene of the options with every formulation, with settings beyond the paper's, and
/// with those that were asked for. Throws what MeasuredScene throws, and std::invalid_argument
/// where two scenes have one name.
std::vector<std::unique_ptr<SceneCandidate>> make_scene_candidates(const Options& options);

}  // namespace desmo::paper
