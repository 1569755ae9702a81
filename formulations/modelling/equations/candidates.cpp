#include "formulations/modelling/equations/candidates.h"

#include "formulations/modelling/bodies/body_equations.h"
#include "formulations/modelling/equations/coordinate_equations.h"
#include "formulations/modelling/equations/equation_writer.h"
#include "formulations/modelling/equations/joint_equations.h"

namespace desmo {

namespace {

template <int D>
Candidates write_all(EquationWriter& w) {
  write_body_equations<D>(w);
  write_joint_equations(w);
  write_coordinate_equations<D>(w);
  return w.take();
}

}  // namespace

Candidates make_candidates(const Mechanism& d, const RigidBodies& rigid, const Structure& structure,
                           const std::vector<Motion>& motions) {
  EquationWriter w(d, rigid, make_coordinates(d, rigid, structure, motions));
  return d.dimension == 2 ? write_all<2>(w) : write_all<3>(w);
}

}  // namespace desmo
