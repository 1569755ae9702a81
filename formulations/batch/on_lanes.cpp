#include "formulations/batch/on_lanes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "formulations/batch/lane_part.h"
#include "formulations/parts/explicit_part.h"
#include "formulations/structure/partition.h"

namespace desmo {

namespace {

/// Of parts, in the order of solution.
using Positions = std::vector<int>;

/// What belongs to several parts, as of one.
PartDefinition join(const std::vector<DefinedPart>& parts) {
  PartDefinition all;
  all.constant = parts.front().definition.constant;
  for (const DefinedPart& p : parts) {
    const PartDefinition& d = p.definition;
    all.groups.insert(all.groups.end(), d.groups.begin(), d.groups.end());
    all.unknowns.insert(all.unknowns.end(), d.unknowns.begin(), d.unknowns.end());
    all.equations.insert(all.equations.end(), d.equations.begin(), d.equations.end());
  }
  std::ranges::sort(all.groups);
  all.groups.erase(std::ranges::unique(all.groups).begin(), all.groups.end());
  std::ranges::sort(all.unknowns);
  std::ranges::sort(all.equations, {}, [](const Equation& e) {
    return std::pair{e.constraint, e.row};
  });
  return all;
}

class Lanes {
 public:
  Lanes(const Model& model, std::vector<DefinedPart> parts, const std::vector<int>& run_ends,
        const Settings& settings, const KernelTable& table)
      : model_(model),
        parts_(std::move(parts)),
        lanes_(settings.lanes),
        guess_(settings.guess),
        table_(table),
        kinds_(model.state_size(), StateKind::constant) {
    for (const int end : run_ends) run_of_.resize(end, static_cast<int>(runs_++));
    std::fill_n(kinds_.begin(), model.coordinates(), StateKind::solved);
    for (const DefinedPart& part : parts_)
      if (part.definition.constant)
        for (const int i : part.definition.unknowns) kinds_[i] = StateKind::constant;
    for (const Driver& d : model.drivers)
      kinds_[model.entities[d.coordinate].first] = StateKind::driven;
  }

  std::vector<DefinedPart> take() {
    Positions left;
    for (int i = 0; i < size(); ++i)
      if (parts_[i].definition.constant) left.push_back(i);
    std::vector<std::vector<Positions>> all_copies = sorted_by_kind(pieces());
    for (std::vector<Positions>& copies : all_copies) {
      std::span<const Positions> rest = copies;
      for (const std::size_t together : {copies.size(), copies.size() / lanes_ * lanes_})
        if (gains(copies, together)) {
          put(rest.first(together));
          rest = rest.subspan(together);
          break;
        }
      for (const Positions& copy : rest) left.insert(left.end(), copy.begin(), copy.end());
    }
    std::ranges::sort(left);
    return by_types(left);
  }

 private:
  int size() const { return static_cast<int>(parts_.size()); }

  const ExplicitPart* explicit_part(int i) const {
    return dynamic_cast<const ExplicitPart*>(parts_[i].solver.get());
  }

  /// Moving parts that are connected by what they need of each other.
  std::vector<Positions> pieces() const {
    Positions linked(parts_.size()), owner(model_.state_size(), -1);
    std::iota(linked.begin(), linked.end(), 0);
    const auto piece_of = [&](int i) {
      while (linked[i] != i) i = linked[i] = linked[linked[i]];
      return i;
    };
    for (int i = 0; i < size(); ++i) {
      const PartDefinition& part = parts_[i].definition;
      if (part.constant) continue;
      for (const int state : states_read(model_, part))
        if (const int needed = owner[state]; needed >= 0) linked[piece_of(needed)] = piece_of(i);
      for (const int unknown : part.unknowns) owner[unknown] = i;
    }
    std::map<int, Positions> pieces;
    for (int i = 0; i < size(); ++i)
      if (!parts_[i].definition.constant) pieces[piece_of(i)].push_back(i);
    std::vector<Positions> result;
    for (auto& [number, piece] : pieces) result.push_back(std::move(piece));
    return result;
  }

  bool are_alike(const Positions& a, const Positions& b) const {
    std::vector<const ExplicitPart*> of_a, of_b;
    for (const int i : a) of_a.push_back(explicit_part(i));
    for (const int i : b) of_b.push_back(explicit_part(i));
    return std::ranges::find(of_a, nullptr) == of_a.end() &&
           std::ranges::find(of_b, nullptr) == of_b.end() && are_copies(of_a, of_b);
  }

  std::vector<std::vector<Positions>> sorted_by_kind(std::vector<Positions> pieces) const {
    std::vector<std::vector<Positions>> kinds;
    for (Positions& piece : pieces) {
      const auto kind = std::ranges::find_if(
          kinds, [&](const auto& copies) { return are_alike(copies.front(), piece); });
      if (kind != kinds.end())
        kind->push_back(std::move(piece));
      else
        kinds.push_back({std::move(piece)});
    }
    return kinds;
  }

  /// The kernels for each part of a piece, by numbers of lanes for which there are all.
  std::vector<CopyKernels> kernels(const Positions& piece) const {
    std::vector<CopyKernels> result;
    for (const int lanes : lane_counts) {
      CopyKernels of_all;
      for (const int i : piece)
        if (const ExplicitPart* const part = explicit_part(i))
          if (const LaneKernel* k = table_.find_lane_kernel(part->kernel().fingerprint, lanes))
            of_all.push_back(k);
      if (lanes <= lanes_ && of_all.size() == piece.size()) result.push_back(std::move(of_all));
    }
    return result;
  }

  std::size_t calls(std::size_t parts) const { return (parts + lanes_ - 1) / lanes_; }

  /// Whether the first of these copies together, and the rest type by type, take no more calls of
  /// kernels than all of them type by type.
  bool gains(const std::vector<Positions>& copies, std::size_t together) const {
    if (together < 2 || kernels(copies.front()).empty()) return false;
    std::map<int, std::size_t> of_run;
    for (const int i : copies.front()) ++of_run[run_of_[i]];
    std::size_t by_type = 0, by_copy = copies.front().size() * calls(together);
    for (const auto& [run, parts] : of_run) {
      by_type += calls(parts * copies.size());
      by_copy += calls(parts * (copies.size() - together));
    }
    return by_copy <= by_type;
  }

  /// The copies as one part.
  void put(std::span<const Positions> copies) {
    std::vector<DefinedPart> taken;
    std::vector<Copy> members;
    std::vector<CopyKernels> of_copy = kernels(copies.front());
    double tolerance = 0;
    bool as_named = true;
    for (const Positions& copy : copies) {
      members.emplace_back();
      for (const int i : copy) {
        members.back().emplace_back(static_cast<ExplicitPart*>(parts_[i].solver.release()));
        tolerance = std::hypot(tolerance, parts_[i].tolerance);
        as_named = as_named && parts_[i].as_named;
        taken.push_back(std::move(parts_[i]));
      }
    }
    result_.push_back({.definition = join(taken),
                       .solver = std::make_unique<LanePart>(std::move(of_copy), std::move(members),
                                                            kinds_, guess_),
                       .as_named = as_named,
                       .tolerance = tolerance});
  }

  /// Run by run, where there is code together, or one by one; behind what is put already.
  std::vector<DefinedPart> by_types(const Positions& left) {
    std::vector<DefinedPart> copies = std::exchange(result_, {});
    for (auto first = left.begin(); first != left.end();) {
      const auto last =
          std::find_if(first, left.end(), [&](int i) { return run_of_[i] != run_of_[*first]; });
      std::vector<Positions> run;
      for (auto i = first; i != last; ++i) run.push_back({*i});
      const bool alike = std::ranges::all_of(
          run, [&](const Positions& one) { return are_alike(run.front(), one); });
      if (run.size() > 1 && alike && !kernels(run.front()).empty())
        put(run);
      else
        for (const Positions& one : run) result_.push_back(std::move(parts_[one.front()]));
      first = last;
    }
    const auto moving = std::ranges::find_if(
        result_, [](const DefinedPart& part) { return !part.definition.constant; });
    result_.insert(moving, std::make_move_iterator(copies.begin()),
                   std::make_move_iterator(copies.end()));
    return std::move(result_);
  }

  const Model& model_;
  std::vector<DefinedPart> parts_;
  const int lanes_;
  const Guess guess_;
  const KernelTable& table_;
  std::vector<int> run_of_;  // by part
  std::size_t runs_ = 0;
  std::vector<StateKind> kinds_;  // of each position in the state
  std::vector<DefinedPart> result_;
};

}  // namespace

std::vector<DefinedPart> on_lanes(const Model& model, std::vector<DefinedPart> parts,
                                  const std::vector<int>& run_ends, const Settings& settings,
                                  const KernelTable& table) {
  return Lanes(model, std::move(parts), run_ends, settings, table).take();
}

}  // namespace desmo
