#pragma once

#include "bench/experiments/promise/mechanisms.h"

namespace desmo::promise {

// Mechanisms of about unit size, with random dimensions. Plane ones:
Drawn four_bar(Random&);
Drawn parallelogram(Random&);
Drawn antiparallelogram(Random&);
Drawn deltoid(Random&);              ///< crank as long as the base, coupler as long as the rocker
Drawn scott_russell(Random&);        ///< crank and half of a bar whose end slides through the pivot
Drawn offset_slider_crank(Random&);  ///< driven by the crank
Drawn driven_slider(Random&);        ///< driven by the slider
Drawn oscillating_block(Random&);    ///< the rod slides through a block that turns
Drawn trammel(Random&);              ///< a bar whose ends slide on two lines, one end driven
Drawn peaucellier(Random&);
Drawn chebyshev(Random&);
Drawn two_loops(Random&);  ///< two to eight parallelograms in a row
Drawn toggle_press(Random&);

// Spatial ones:
Drawn bennett(Random&);
Drawn spherical_four_bar(Random&);
Drawn spatial_four_bar(Random&);  ///< RSSR
Drawn rssp(Random&);
Drawn hooke_joint(Random&);

}  // namespace desmo::promise
