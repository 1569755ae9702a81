#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "cases/mechanism/checks.h"
#include "cases/mechanism/joint_forms.h"

namespace desmo {

void name_joints(Mechanism& mechanism) {
  // A type or a body may not exist: validate() refuses it later.
  const auto type_name = [](Mechanism::JointType type) {
    const auto form = std::ranges::find(joint_forms(), type, &JointForm::type);
    return form == joint_forms().end() ? std::string("joint") : std::string(form->name);
  };
  const auto body_name = [&](int b) {
    return is_in(b, mechanism.bodies) ? mechanism.bodies[b].name : std::to_string(b);
  };
  std::set<std::string> taken;
  for (const Mechanism::Joint& joint : mechanism.joints) taken.insert(joint.name);
  std::map<std::string, int> counts;
  for (Mechanism::Joint& joint : mechanism.joints) {
    if (!joint.name.empty()) continue;
    const std::string stem =
        type_name(joint.type) + "/" + body_name(joint.bodies[0]) + "/" + body_name(joint.bodies[1]);
    int& count = counts[stem];
    do {
      joint.name = ++count == 1 ? stem : stem + "/" + std::to_string(count);
    } while (!taken.insert(joint.name).second);
  }
}

}  // namespace desmo
