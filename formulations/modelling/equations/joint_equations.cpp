#include <string>
#include <string_view>

#include "cases/mechanism/joint_forms.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

/// Returns the dimensions that a joint keeps constant: as drawn, or zeros when a body has its own
/// frame, so that its drawing is an estimate.
template <class Kind, class Operands>
std::array<Derived, Kind::constants> kept(const EquationWriter& w, const Mechanism::Joint& j,
                                          double magnitude, const Operands& operands) {
  for (const int b : j.bodies)
    if (w.mechanism.bodies[b].own) return {};
  return measured<Kind>(w.mechanism, magnitude, operands);
}

/// Keeps the offset of a joint's second point constant. In the plane it counts from the line
/// through the first point along the vector. In space it counts from the plane through the first
/// point that is normal to the vector.
template <class Kind>
void keep_off(EquationWriter& w, const Mechanism::Joint& j, std::string_view name_end) {
  const int u = j.vectors[0], p = j.points[0], q = j.points[1];
  w.constrain<Kind>(EquationSource::joint, j.name + std::string(name_end),
                    {w.vector(u), w.point(p), w.point(q)},
                    kept<Kind>(w, j, w.reach, [&](const auto& drawing) {
                      return std::array{drawing.vector(u), drawing.point(p), drawing.point(q)};
                    }));
}

/// Keeps the axes of a universal joint at the same angle.
void keep_angle(EquationWriter& w, const Mechanism::Joint& j) {
  const Mechanism::Direction a{j.vectors[0]}, b{j.vectors[1]};
  const auto product = kept<Dot<3>>(w, j, 1, [&](const auto& drawing) {
    return std::array{drawing.vector(a.vector), drawing.vector(b.vector)};
  });
  if (w.note_product(a, b, product[0].value, 2))
    w.constrain<Dot<3>>(EquationSource::joint, j.name + ": " + w.text(a) + " with " + w.text(b),
                        {w.vector(a.vector), w.vector(b.vector)}, product);
}

}  // namespace

void write_joint_equations(EquationWriter& w) {
  for (std::size_t i = 0; i < w.mechanism.joints.size(); ++i) {
    const Mechanism::Joint& j = w.mechanism.joints[i];
    const int first = w.rigid.of_body[j.bodies[0]], second = w.rigid.of_body[j.bodies[1]];
    if (first == second || (w.framed && w.framed->tree.is_of_tree[i])) continue;
    w.begin(first, second);
    if (w.mechanism.dimension == 2) {
      if (slides(j.type) && writes_offset(w, j)) keep_off<Offset>(w, j, offset_equation);
    } else if (find_joint_form(j.type, 3)->in_plane) {
      keep_off<Projection<3>>(w, j, plane_distance_equation);
    } else if (j.type == Mechanism::JointType::universal) {
      keep_angle(w, j);
    }
  }
}

}  // namespace desmo
