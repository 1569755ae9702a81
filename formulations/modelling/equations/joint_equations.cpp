#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

using nominal::Vec;
using nominal::operator-;

/// What slides stays at the same offset from the line along which it does.
void keep_offset(EquationWriter& w, const Mechanism::Joint& j) {
  const Mechanism& d = w.mechanism;
  const Vec u = d.vectors[j.vectors[0]].direction;
  const Vec s = d.points[j.points[1]].position - d.points[j.points[0]].position;
  w.constrain<Offset>(Origin::joint, j.name + ": offset",
                      {w.vector(j.vectors[0]), w.point(j.points[0]), w.point(j.points[1])},
                      {snap(u[0] * s[1] - u[1] * s[0], w.reach)});
}

/// The axes of a universal joint stay at the same angle.
void keep_angle(EquationWriter& w, const Mechanism::Joint& j) {
  const Mechanism::Direction a{j.vectors[0]}, b{j.vectors[1]};
  const double product =
      snap(nominal::dot(nominal::direction(w.mechanism, a), nominal::direction(w.mechanism, b)), 1);
  if (w.note_product(a, b, product))
    w.constrain<Dot<3>>(Origin::joint, j.name + ": " + w.text(a) + " with " + w.text(b),
                        {w.vector(a.vector), w.vector(b.vector)}, {product});
}

}  // namespace

void write_joint_equations(EquationWriter& w) {
  for (const Mechanism::Joint& j : w.mechanism.joints) {
    if (w.rigid.of_body[j.bodies[0]] == w.rigid.of_body[j.bodies[1]]) continue;
    if (w.mechanism.dimension == 2) {
      if (slides(j) && !declares_distance(w.mechanism, j)) keep_offset(w, j);
    } else if (j.type == Mechanism::JointType::universal) {
      keep_angle(w, j);
    }
  }
}

}  // namespace desmo
