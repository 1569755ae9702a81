// Closed forms of gears, belts, racks, screws and mimic joints.

#include <cmath>

#include "tests/load/closed_forms.h"

namespace desmo::load::closed_forms {

Values gear_train(double t) {
  const Jet a = degrees(t, 900, 720, -90);
  const Jet c0 = atan2(Jet(5), Jet(-20)), b0 = Jet(pi / 2);
  const Jet b = b0 - Jet(20.0L / 30) * a, c = c0 + Jet(20.0L / 50) * a;
  Values v{{"b", b}, {"c", c}};
  add(v, "B", Vec2{{Jet(0.05L), 0}} + polar(Jet(0.02L), b));
  add(v, "C", Vec2{{Jet(0.13L), 0}} + polar(Jet(std::sqrt(0.02L * 0.02L + 0.005L * 0.005L)), c));
  return v;
}

/// The ratio of sun and arm is 1 + 60/24, as textbooks print it.
Values planetary_gear(double t) {
  const Jet sun = degrees(t, 0, 630, 60), drawn = atan2(Jet(3), Jet(10));
  const Jet arm = (sun - drawn) / Jet(1 + 60.0L / 24);
  const Jet planet = atan2(Jet(6), Jet(8)) - Jet(42.0L / 18) * arm;
  Values v{{"arm_angle", arm}, {"planet_angle", planet}};
  add(v, "Q", polar(Jet(0.042L), arm) + polar(Jet(0.01L), planet));
  return v;
}

Values rack_steering(double t) {
  const Jet pinion = Jet(-1.5L) + Jet(4) * sin(Jet(pi) * Jet::time(t));
  const Jet travel = Jet(0.3L) + Jet(0.015L) * (pinion + Jet(pi / 2));
  Values v{{"travel", travel}};
  const Jet rod = sqrt(Jet(0.28L * 0.28L + 0.03L * 0.03L)),
            arm = sqrt(Jet(0.02L * 0.02L + 0.13L * 0.13L));
  const Vec2 left{{travel - Jet(0.6L), 0}}, right{{travel, 0}};
  add(v, "EL", meet(left, rod, Vec2{{Jet(-0.6L), Jet(0.1L)}}, arm, Side::left));
  add(v, "ER", meet(right, rod, Vec2{{Jet(0.6L), Jet(0.1L)}}, arm, Side::right));
  return v;
}

/// The tip goes along the x axis, and the tool keeps its direction.
Values belt_arm(double t) {
  const Jet drawn = atan2(Jet(0.4L), Jet(0.3L)), shoulder = degrees(t, 750, 200, 40);
  const Jet turned = shoulder - drawn, elbow = Jet(-2) * drawn - Jet(2) * turned;
  const Jet wrist = Jet(pi / 2) + drawn + turned;
  const Vec2 W{{cos(shoulder), 0}};
  Values v{{"elbow", elbow}, {"wrist", wrist}};
  add(v, "E", polar(Jet(0.5L), shoulder));
  add(v, "W", W);
  add(v, "T", W + Vec2{{0, Jet(0.1L)}});
  return v;
}

Values screw_jack(double t) {
  const Jet turn = degrees(t, 20, 720, -100);
  const Jet lift = Jet(0.04L) + Jet(0.005L / 360 / degree) * turn;
  Values v{{"lift", lift}, {"A.z", lift}, {"B.z", lift}};
  add(v, "B", polar(Jet(0.02L), turn));
  return v;
}

Values mimic_gripper(double t) {
  const Vec2 H{{0, Jet(0.05L) + Jet(0.03L) * sin(Jet(pi) * Jet::time(t))}};
  const Vec2 P{{Jet(-0.2L), Jet(0.3L)}}, K0{{Jet(-0.25L), Jet(0.15L)}}, T0{{Jet(-0.1L), Jet(0.6L)}};
  const Vec2 K = meet(H, norm(K0 - Vec2{{0, Jet(0.05L)}}), P, norm(K0 - P), Side::left);
  const Vec2 T = carried(P, K, P, K0, T0);
  const Jet alpha = angle(T - P), beta = Jet(pi) - alpha;
  Values v{{"alpha", alpha}, {"beta", beta}};
  add(v, "TL", T);
  add(v, "TR", Vec2{{-T[0], T[1]}});
  return v;
}

/// A drum that is geared to an undriven angle starts three turns from the drawing, too.
Values wound_drum(double t) {
  const Jet theta = degrees(t, 1140, 300, 0), rel = theta - Jet(pi / 2);
  const Jet drum = Jet(pi / 2) - Jet(10.0L / 30) * theta;
  Values v{{"rel", rel}, {"drum", drum}};
  add(v, "B", Vec2{{3, 0}} + polar(Jet(1), drum));
  return v;
}

}  // namespace desmo::load::closed_forms
