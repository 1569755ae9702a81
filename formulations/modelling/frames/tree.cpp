#include "formulations/modelling/frames/tree.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "cases/mechanism/drawing.h"
#include "cases/numbers/space.h"
#include "formulations/modelling/frames/axes.h"

namespace desmo {

namespace {

class TreeMaker {
 public:
  TreeMaker(const Mechanism& d, const RigidBodies& rigid, const Structure& structure)
      : d_(d), rigid_(rigid), structure_(structure), depth_(rigid.list.size(), -1) {
    const int freedoms = d.dimension == 2 ? 3 : 6;
    tree_.hanging.resize(rigid.list.size());
    for (const RigidBody& body : rigid.list)
      tree_.has_frame.push_back(tree_.has_frame.empty() || body.freedoms == freedoms);
    tree_.is_of_tree.assign(d.joints.size(), false);
    depth_[0] = 0;
  }

  SpanningTree make(bool hangs_by_joints) {
    for (const StructuralGroup& group : structure_.groups) {
      std::vector<int> left;
      for (const int r : group.bodies)
        if (tree_.has_frame[r]) left.push_back(r);
      while (!left.empty()) {
        if (hangs_by_joints && place_by_joint(left)) continue;
        place(left.front(), {});
        left.erase(left.begin());
      }
      for (const int r : group.bodies)
        if (!tree_.has_frame[r]) tree_.order.push_back(r);
      for (const int r : group.bodies) depth_[r] = 0;  // as for all bodies of earlier groups
    }
    return std::move(tree_);
  }

 private:
  struct Candidate {
    int body;
    TreeJoint hanging;
    std::tuple<int, int, int, int> rank;
  };

  void place(int r, const TreeJoint& hanging) {
    tree_.hanging[r] = hanging;
    tree_.order.push_back(r);
    if (hanging.joint >= 0) tree_.is_of_tree[hanging.joint] = true;
    depth_[r] = depth_[hanging.parent] + 1;
  }

  bool place_by_joint(std::vector<int>& left) {
    std::vector<Candidate> candidates;
    for (int j = 0; j < static_cast<int>(d_.joints.size()); ++j)
      for (const bool is_first : {true, false}) {
        const Mechanism::Joint& joint = d_.joints[j];
        const int body = rigid_.of_body[joint.bodies[is_first ? 0 : 1]],
                  parent = rigid_.of_body[joint.bodies[is_first ? 1 : 0]];
        const int variables = variables_of(joint, body, parent);
        if (variables == 0 || depth_[parent] < 0 || !tree_.has_frame[parent] ||
            std::ranges::find(left, body) == left.end())
          continue;
        candidates.push_back(
            {body, {parent, j, is_first}, {variables, -joints_of(body), depth_[parent], j}});
      }
    if (candidates.empty()) return false;
    const Candidate& best = *std::ranges::min_element(candidates, {}, &Candidate::rank);
    place(best.body, best.hanging);
    std::erase(left, best.body);
    return true;
  }

  /// Returns the number of freedoms that a joint leaves; 0: it cannot be of a tree.
  int variables_of(const Mechanism::Joint& j, int body, int parent) const {
    using enum Mechanism::JointType;
    if (body == parent) return 0;
    switch (j.type) {
      case revolute:
        return 1;
      case prismatic:  // both bodies get the same axes, as drawn: neither may have its own shape
        return rigid_.list[body].has_shape() || rigid_.list[parent].has_shape() || is_off_line(j)
                   ? 0
                   : 1;
      case revolute_on_slider:
      case cylindrical:
        return is_off_line(j) ? 0 : 2;
      case universal:
        return is_at_right_angle(j) ? 2 : 0;
      case spherical:
        return 3;
      case fixed:
      case hinge:
      case point_on_line:
      case point_on_plane:
      case planar:
        break;
    }
    return 0;
  }

  bool is_at_right_angle(const Mechanism::Joint& j) const {
    if (d_.bodies[j.bodies[0]].own || d_.bodies[j.bodies[1]].own) return true;
    const Drawing<double> drawing{d_};
    return std::abs(dot(drawing.vector(j.vectors[0]), drawing.vector(j.vectors[1]))) <=
           same_direction;
  }

  /// Returns whether a planar sliding joint is drawn with a point off its line. Such joints are
  /// cut.
  bool is_off_line(const Mechanism::Joint& j) const {
    if (d_.dimension == 3 || d_.bodies[j.bodies[0]].own || d_.bodies[j.bodies[1]].own) return false;
    const Drawing<double> drawing{d_};
    const auto u = drawing.vector(j.vectors[0]), s = drawing.direction(j.line());
    const double off = std::abs(u[0] * s[1] - u[1] * s[0]);
    return off > same_direction * std::max(1e-300, nominal::extent(d_));
  }

  int joints_of(int r) const {
    return static_cast<int>(std::ranges::count_if(
        d_.joints, [&](const Mechanism::Joint& j) { return rigid_.is_joint_of(r, j); }));
  }

  const Mechanism& d_;
  const RigidBodies& rigid_;
  const Structure& structure_;
  std::vector<int> depth_;  // tree joints of its group above each placed body; -1: not placed
  SpanningTree tree_;
};

}  // namespace

SpanningTree make_tree(const Mechanism& d, const RigidBodies& rigid, const Structure& structure,
                       Modelling modelling) {
  return TreeMaker(d, rigid, structure).make(modelling == Modelling::relative);
}

std::vector<int> first_carriers(const std::vector<std::vector<int>>& carriers,
                                const SpanningTree& tree) {
  // Position of each body in the tree's order; -1: the ground, which comes first.
  std::vector<int> position(tree.hanging.size(), -1);
  for (std::size_t i = 0; i < tree.order.size(); ++i) position[tree.order[i]] = static_cast<int>(i);
  std::vector<int> first;
  for (const std::vector<int>& all : carriers)
    first.push_back(all.empty() ? no_position : *std::ranges::min_element(all, {}, [&](int r) {
      return position[r];
    }));
  return first;
}

}  // namespace desmo
