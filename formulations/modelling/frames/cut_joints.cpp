// Closures of the joints that are not of the tree. Shared points close by their relations
// (body_equations.cpp); angles of universal joints and offsets in the plane, by
// joint_equations.cpp.

#include <algorithm>
#include <utility>
#include <vector>

#include "cases/mechanism/joint_forms.h"
#include "cases/numbers/space.h"
#include "formulations/modelling/equations/equation_writer.h"
#include "formulations/modelling/frames/axes.h"

namespace desmo {

namespace {

/// The sine between two shared vectors above which the second one tells more than the first.
constexpr double min_sine = 1e-6;

/// Closes the vectors that a body shares with earlier bodies. In space, the first one closes by
/// products with two of its normals on this body. It leaves a turn about itself. A further one
/// shared with the same body closes by a product with their common normal, unless they are
/// parallel.
void close_shared_vectors(FramedMechanism& framed, AxisMaker& axes,
                          const std::vector<int>& orientation, int own_vectors, int r) {
  std::vector<std::pair<int, int>> closed;  // other bodies, each with a vector that is closed
  const std::vector<int> vectors = framed.rigid.list[r].vectors;
  for (const int v : vectors) {
    const int other = framed.deriving_vector[v];
    if (v >= own_vectors || other == r || framed.rigid.list[r].basis.has_vector(v) ||
        orientation[other] == orientation[r])
      continue;
    const AxisMaker::Exact u = axes.own(r, v);
    const auto before = std::ranges::find(closed, other, &std::pair<int, int>::first);
    if (framed.mechanism.dimension == 2) {
      framed.vectors.push_back({v, axes.find_or_add_axis(r, cross({0, 0, 1}, u), "normal")});
    } else if (before == closed.end()) {
      const auto [first, second] = axes.find_or_add_normals(r, v);
      framed.vectors.push_back({v, first});
      framed.vectors.push_back({v, second});
    } else {
      const AxisMaker::Exact normal = cross(axes.own(r, before->second), u);
      if (!(sqrt(dot(normal, normal)).value > min_sine)) continue;
      framed.vectors.push_back({v, axes.find_or_add_axis(r, unit(normal), "normal")});
    }
    closed.emplace_back(other, v);
  }
}

/// Closes spatial sliding joints: the line between the points of one is normal to two vectors of a
/// body that carries the axis.
void close_sliding_joints(FramedMechanism& framed, AxisMaker& axes) {
  const Mechanism& d = framed.mechanism;
  for (int i = 0; i < static_cast<int>(d.joints.size()); ++i) {
    const Mechanism::Joint j = d.joints[i];
    const std::vector<int>& of_body = framed.rigid.of_body;
    if (framed.tree.is_of_tree[i] || !slides(j.type) ||
        of_body[j.bodies[0]] == of_body[j.bodies[1]])
      continue;
    for (const int b : {j.bodies[1], j.bodies[0]}) {
      const int r = of_body[b];
      if (!framed.tree.has_frame[r] || !carries(framed.rigid, r, {j.vectors[0]})) continue;
      const auto [first, second] = axes.find_or_add_normals(r, j.vectors[0]);
      framed.lines.push_back({i, first});
      framed.lines.push_back({i, second});
      break;
    }
  }
}

}  // namespace

void plan_cut_joints(FramedMechanism& framed, AxisMaker& axes, const std::vector<int>& orientation,
                     int own_vectors) {
  for (const int r : framed.tree.order)
    if (framed.tree.has_frame[r]) close_shared_vectors(framed, axes, orientation, own_vectors, r);
  if (framed.mechanism.dimension == 3) close_sliding_joints(framed, axes);
}

template <int D>
void write_cut_joints(EquationWriter& w) {
  for (const auto& [vector, normal] : w.framed->vectors)
    w.constrain<Dot<D>>(EquationSource::joint, w.text({vector}) + " with " + w.text({normal}),
                        {w.vector(vector), w.vector(normal)}, {Derived(0)});
  for (const auto& [joint, normal] : w.framed->lines) {
    const Mechanism::Joint& j = w.mechanism.joints[joint];
    w.begin(w.rigid.of_body[j.bodies[0]], w.rigid.of_body[j.bodies[1]]);
    w.constrain<Projection<D>>(EquationSource::joint, j.name + ": off along " + w.text({normal}),
                               {w.vector(normal), w.point(j.points[0]), w.point(j.points[1])},
                               {Derived(0)});
  }
}

template void write_cut_joints<2>(EquationWriter&);
template void write_cut_joints<3>(EquationWriter&);

}  // namespace desmo
