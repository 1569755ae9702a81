#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <tuple>

#include "cases/mechanism/joint_forms.h"
#include "formulations/modelling/frames/frames.h"

namespace desmo {

namespace {

/// Turn by which a body may hang at a type of joint. A joint without a row is always cut.
struct TreeForm {
  Mechanism::JointType type;
  int dimension;
  Turn turn;
};

std::span<const TreeForm> tree_forms() {
  using enum Mechanism::JointType;
  static constexpr TreeForm table[]{
      {revolute, 2, Turn::in_plane},
      {prismatic, 2, Turn::none},
      {revolute_on_slider, 2, Turn::in_plane},
      {revolute, 3, Turn::about_axis},
      {prismatic, 3, Turn::none},
      {cylindrical, 3, Turn::about_axis},
      {universal, 3, Turn::about_two_axes},
      {spherical, 3, Turn::freely},
  };
  return table;
}

class TreeMaker {
 public:
  TreeMaker(const Mechanism& mechanism, const RigidBodies& rigid, const Structure& structure)
      : mechanism_(mechanism),
        rigid_(rigid),
        structure_(structure),
        freedoms_(mechanism.dimension == 2 ? 3 : 6),
        depth_(rigid.list.size(), -1) {
    tree_.hanging.resize(rigid.list.size());
    for (const RigidBody& body : rigid.list)
      tree_.has_frame.push_back(tree_.has_frame.empty() || body.freedoms == freedoms_);
    tree_.is_of_tree.assign(mechanism.joints.size(), false);
    depth_[0] = 0;
  }

  SpanningTree make(bool hangs_by_joints) {
    const TreeJoint by_free_joint{.turn =
                                      mechanism_.dimension == 2 ? Turn::in_plane : Turn::freely};
    for (const StructuralGroup& group : structure_.groups) {
      std::vector<int> left;
      for (const int r : group.bodies)
        if (tree_.has_frame[r]) left.push_back(r);
      while (!left.empty()) {
        if (hangs_by_joints && place_by_joint(left)) continue;
        place(left.front(), by_free_joint);
        left.erase(left.begin());
      }
      for (const int r : group.bodies)
        if (!tree_.has_frame[r]) tree_.order.push_back(r);
      for (const int r : group.bodies) depth_[r] = 0;  // as for all bodies of earlier groups
    }
    return std::move(tree_);
  }

 private:
  void place(int r, const TreeJoint& hanging) {
    tree_.hanging[r] = hanging;
    tree_.order.push_back(r);
    if (hanging.joint >= 0) tree_.is_of_tree[hanging.joint] = true;
    depth_[r] = depth_[hanging.parent] + 1;
  }

  /// Hangs one of the bodies that are left on a placed one. Returns false where no joint allows it.
  bool place_by_joint(std::vector<int>& left) {
    std::map<std::tuple<int, int, int, int>, TreeJoint> candidates;  // by rank: the first is taken
    for (int j = 0; j < static_cast<int>(mechanism_.joints.size()); ++j)
      for (const bool is_first : {true, false}) {
        const Mechanism::Joint& joint = mechanism_.joints[j];
        const int body = rigid_.of_body[joint.bodies[is_first ? 0 : 1]],
                  parent = rigid_.of_body[joint.bodies[is_first ? 1 : 0]];
        if (depth_[parent] < 0 || !tree_.has_frame[parent] ||
            std::ranges::find(left, body) == left.end())
          continue;
        const std::optional<Turn> turn = turn_of(joint, body, parent);
        if (!turn) continue;
        const int variables =
            freedoms_ - find_joint_form(joint.type, mechanism_.dimension)->freedoms_removed;
        candidates[{variables, -joints_of(body), depth_[parent], j}] = {parent, j, is_first, *turn};
      }
    if (candidates.empty()) return false;
    const TreeJoint& best = candidates.begin()->second;
    const int body = rigid_.of_body[mechanism_.joints[best.joint].bodies[best.is_first ? 0 : 1]];
    place(body, best);
    std::erase(left, body);
    return true;
  }

  /// Returns how a body turns that hangs on a parent by a joint; nullopt: the joint must be cut.
  std::optional<Turn> turn_of(const Mechanism::Joint& j, int body, int parent) const {
    // Bodies with the same axes have them as drawn: neither may have a shape of its own.
    const bool has_shape = rigid_.list[body].has_shape() || rigid_.list[parent].has_shape();
    for (const TreeForm& form : tree_forms())
      if (form.type == j.type && form.dimension == mechanism_.dimension &&
          !(form.turn == Turn::none && has_shape) && is_drawn_to_hang(j))
        return form.turn;
    return std::nullopt;
  }

  /// Returns false for universal joints that are not drawn at a right angle, and for planar sliding
  /// ones that are drawn with a point off the line. The drawing of a body with its own frame is an
  /// estimate: its joints are as they should be.
  bool is_drawn_to_hang(const Mechanism::Joint& j) const {
    if (mechanism_.bodies[j.bodies[0]].own || mechanism_.bodies[j.bodies[1]].own) return true;
    const Drawing<double> drawing{mechanism_};
    if (j.type == Mechanism::JointType::universal)
      return std::abs(dot(drawing.vector(j.vectors[0]), drawing.vector(j.vectors[1]))) <=
             direction_tolerance;
    if (mechanism_.dimension == 3 || !slides(j.type)) return true;
    const auto u = drawing.vector(j.vectors[0]), s = drawing.direction(j.line());
    const double off = std::abs(u[0] * s[1] - u[1] * s[0]);
    return off <= direction_tolerance * std::max(1e-300, nominal::extent(mechanism_));
  }

  int joints_of(int r) const {
    return static_cast<int>(std::ranges::count_if(
        mechanism_.joints, [&](const Mechanism::Joint& j) { return rigid_.is_joint_of(r, j); }));
  }

  const Mechanism& mechanism_;
  const RigidBodies& rigid_;
  const Structure& structure_;
  const int freedoms_;      // of a body
  std::vector<int> depth_;  // tree joints of its group above each placed body; -1: not placed
  SpanningTree tree_;
};

}  // namespace

SpanningTree make_tree(const Mechanism& mechanism, const RigidBodies& rigid,
                       const Structure& structure, Modelling modelling) {
  return TreeMaker(mechanism, rigid, structure).make(modelling == Modelling::relative);
}

}  // namespace desmo
