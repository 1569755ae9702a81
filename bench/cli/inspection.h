// The structure of a mechanism, collected once for every way of showing it.
#pragma once

#include <string>
#include <vector>

#include "bench/cli/input.h"
#include "formulations/structure/partition.h"

namespace desmo::cli {

struct InspectedGroup {
  int moving_bodies = 0;             ///< N_m of the paper; bodies fixed to each other are one
  std::vector<std::string> drivers;  ///< n_c of the paper: the coordinates driven in it
  std::vector<int> unknowns;
  std::vector<PartDefinition> blocks;  ///< irreducible ones, in solution order
  bool on_ground = false;              ///< joined to the ground
  std::vector<GroupId> joined_to;      ///< earlier groups, by a joint between bodies of both
};

struct Inspection {
  std::string title;
  int dimension;
  int bodies, joints;  ///< the ground left out
  ModellingResult modelled;
  std::vector<InspectedGroup> groups;  ///< of each group of the mechanism

  const Model& model() const { return modelled.model; }
  int constant_parts() const;
};

/// Throws InputError.
Inspection inspect(const Input& input);

/// "theta", "C.x": the name of a coordinate.
std::string coordinate_name(const Model& model, EntityId owner, int coordinate);

std::string to_text(const Inspection& inspection);
std::string to_json(const Inspection& inspection);
/// The structural diagram of the paper's figures 3.b and 4.b, for Graphviz: a circle with
/// (N_m, n_c) for each group and one for the ground, 0; arrows in solution order where a joint
/// connects bodies of two of them; a broken arrow where a driver alone does.
std::string to_dot(const Inspection& inspection);

}  // namespace desmo::cli
