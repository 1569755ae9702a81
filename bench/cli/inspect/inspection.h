// Structure of a mechanism, collected once for all output formats.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/cli/input.h"
#include "formulations/model/partition.h"

namespace desmo::cli {

struct InspectedGroup {
  int moving_bodies = 0;               ///< N_m of the paper; bodies fixed to each other are one
  std::vector<std::string> drivers;    ///< n_c of the paper: coordinates driven in it
  std::vector<std::string> couplings;  ///< coupling equations that it determines, or are left out
  std::vector<int> unknowns;
  std::vector<PartDefinition> blocks;   ///< irreducible blocks, in solution order
  std::vector<std::string> solved_for;  ///< unknowns of its linear systems: what is not derived
  bool on_ground = false;               ///< joined to the ground
  std::vector<GroupId> joined_to;       ///< earlier groups with a joint between bodies of both
};

/// The place of a body in the spanning tree of a model with frames.
struct HangingBody {
  std::string body, parent;
  std::string joint;  ///< empty: a free joint
};

struct Inspection {
  std::string title;
  int dimension;
  int bodies, joints;  ///< numbers without the ground
  ModellingResult modelled;
  std::vector<InspectedGroup> groups;  ///< one for each group of the model
  std::vector<HangingBody> tree{};     ///< parents first; empty: bodies have no frames
  std::vector<std::string> cut_joints{};

  const Model& model() const { return modelled.model; }
  int constant_parts() const;
};

/// Models an input and collects its structure. Throws InputError.
Inspection inspect(const Input& input, Modelling modelling = Modelling::natural);

/// Return the names of entities, and of the model's drivers.
std::vector<std::string> entity_names(const Model& model, const std::vector<EntityId>& entities);
std::vector<std::string> driver_names(const Model& model);

std::string to_text(const Inspection& inspection);
std::string to_json(const Inspection& inspection);

}  // namespace desmo::cli
