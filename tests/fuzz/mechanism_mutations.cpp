#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cases/mechanism/joint_forms.h"
#include "tests/fuzz/mutations.h"

namespace desmo::fuzz {
namespace {

/// Names of all types of joint; those that exist in the plane and in space stand twice.
const std::vector<std::string_view> joint_types = [] {
  std::vector<std::string_view> names;
  for (const JointForm& form : joint_forms()) names.push_back(form.name);
  return names;
}();

/// A mechanism and the names of what is in it, as far as it still has them.
struct Parts {
  Tree* mechanism;
  std::vector<std::string> points, vectors, bodies, coordinates;

  explicit Parts(Tree& root) : mechanism(mechanism_in(root)) {
    if (!mechanism) return;
    points = names_under(*mechanism, "points");
    vectors = names_under(*mechanism, "vectors");
    bodies = names_under(*mechanism, "bodies");
    bodies.push_back("ground");
    coordinates = names_under(*mechanism, "coordinates");
  }

  Tree* member(std::string_view name, Tree::Kind kind) const {
    Tree* const found = mechanism ? mechanism->find(name) : nullptr;
    return found && found->kind == kind ? found : nullptr;
  }
  Tree* joints() const { return member("joints", Tree::Kind::list); }
  Tree* drivers() const { return member("drivers", Tree::Kind::list); }
  Tree* measured() const { return member("coordinates", Tree::Kind::object); }
  Tree* any_joint(Random& random) const {
    Tree* const all = joints();
    return all && !all->children.empty() ? &random.pick(all->children) : nullptr;
  }
  Tree* any_body(Random& random) const {
    if (!mechanism) return nullptr;
    Tree* const all = member("bodies", Tree::Kind::object);
    if (!all || all->children.empty() || random.one_in(5)) return mechanism->find("ground");
    return &random.pick(all->children);
  }
};

Tree some_of(const std::vector<std::string>& names, Random& random, std::size_t count) {
  Tree result = list({});
  for (; count > 0 && !names.empty(); --count)
    result.children.push_back(string_tree(random.pick(names)));
  return result;
}

void change_joint_type(Tree& root, Random& random) {
  const Parts parts(root);
  if (Tree* const joint = parts.any_joint(random))
    put((*joint)["type"], string_tree(random.pick(joint_types)));
}

void remove_joint(Tree& root, Random& random) {
  const Parts parts(root);
  Tree* const joints = parts.joints();
  if (joints && !joints->children.empty())
    joints->children.erase(joints->children.begin() +
                           static_cast<std::ptrdiff_t>(random.below(joints->children.size())));
}

// What it says is said already: more equations than unknowns, though they agree.
void repeat_joint(Tree& root, Random& random) {
  const Parts parts(root);
  Tree* const joint = parts.any_joint(random);
  if (!joint) return;
  Tree copy = *joint;
  if (Tree* const name = copy.find("name")) put(*name, string_tree("again"));
  parts.joints()->children.push_back(std::move(copy));
}

void reverse_joint(Tree& root, Random& random) {
  const Parts parts(root);
  Tree* const joint = parts.any_joint(random);
  if (!joint) return;
  for (const std::string_view member : {"bodies", "points", "vectors"})
    if (Tree* const found = joint->find(member)) std::ranges::reverse(found->children);
}

// The entities go with the joint, so that it is one that a file may have.
void add_joint(Tree& root, Random& random) {
  const Parts parts(root);
  if (!parts.joints() || parts.points.empty()) return;
  Tree joint = object();
  const std::string_view type = random.pick(joint_types);
  put(joint["type"], string_tree(type));
  put(joint["bodies"], some_of(parts.bodies, random, 2));
  if (type != "fixed") put(joint["points"], some_of(parts.points, random, 1 + random.below(2)));
  if (type != "fixed" && type != "spherical")
    put(joint["vectors"], some_of(parts.vectors, random, 1 + random.below(2)));
  for (const Tree& body : joint["bodies"].children) {
    Tree* const bodies = parts.member("bodies", Tree::Kind::object);
    Tree* const carrier = body.name() == "ground" ? parts.mechanism->find("ground")
                          : bodies                ? bodies->find(body.name())
                                                  : nullptr;
    if (!carrier || carrier->kind != Tree::Kind::object || random.one_in(4)) continue;
    for (const std::string_view member : {"points", "vectors"})
      if (const Tree* const used = joint.find(member))
        for (const Tree& entity : used->children) {
          Tree& carried = (*carrier)[member];
          if (carried.kind != Tree::Kind::list) put(carried, list({}));
          if (std::ranges::find(carried.children, entity.text, &Tree::text) ==
              carried.children.end())
            carried.children.push_back(entity);
        }
  }
  parts.joints()->children.push_back(std::move(joint));
}

void weld(Tree& root, Random& random) {
  const Parts parts(root);
  if (!parts.joints()) return;
  Tree joint = object();
  put(joint["type"], string_tree("fixed"));
  put(joint["bodies"], some_of(parts.bodies, random, 2));
  parts.joints()->children.push_back(std::move(joint));
}

void ground_body(Tree& root, Random& random) {
  const Parts parts(root);
  if (Tree* const joint = parts.any_joint(random))
    if (Tree* const bodies = joint->find("bodies"); bodies && !bodies->children.empty())
      put(random.pick(bodies->children), string_tree(random.pick(parts.bodies)));
}

void remove_body(Tree& root, Random& random) {
  const Parts parts(root);
  Tree* const bodies = parts.member("bodies", Tree::Kind::object);
  if (!bodies || bodies->children.empty()) return;
  const std::size_t at = random.below(bodies->children.size());
  const std::string name = bodies->children[at].key;
  bodies->children.erase(bodies->children.begin() + static_cast<std::ptrdiff_t>(at));
  Tree* const joints = parts.joints();
  if (joints && !random.one_in(4))
    std::erase_if(joints->children, [&](const Tree& joint) {
      const Tree* const joined = joint.find("bodies");
      return joined && std::ranges::find(joined->children, '"' + name + '"', &Tree::text) !=
                           joined->children.end();
    });
}

// A pendulum on another body: one more body, joint and freedom.
void add_body(Tree& root, Random& random) {
  const Parts parts(root);
  if (!parts.joints() || parts.points.empty()) return;
  const std::string name = "body" + std::to_string(random.below(1000));
  const std::string& hinge = random.pick(parts.points);
  const std::string tip = "tip" + std::to_string(random.below(1000));
  Tree position = *parts.mechanism->find("points")->find(hinge);
  if (position.kind != Tree::Kind::list || position.children.empty()) return;
  Tree& x = random.pick(position.children);
  x = scalar(x.number() + 1 + random.around_zero());
  put((*parts.mechanism)["points"][tip], std::move(position));
  Tree& body = (*parts.mechanism)["bodies"][name];
  put(body["points"], list({string_tree(hinge), string_tree(tip)}));
  const bool in_space =
      parts.mechanism->find("dimension") && parts.mechanism->find("dimension")->text == "3";
  Tree joint = object();
  put(joint["type"], string_tree(in_space && random.one_in(2) ? "spherical" : "revolute"));
  put(joint["bodies"], list({string_tree(random.pick(parts.bodies)), string_tree(name)}));
  put(joint["points"], list({string_tree(hinge)}));
  parts.joints()->children.push_back(std::move(joint));
  if (random.one_in(2)) return;
  Tree& coordinate = (*parts.mechanism)["coordinates"]["of_" + tip];
  put(coordinate["angle"], list({string_tree(hinge), string_tree(tip)}));
  if (Tree* const drivers = parts.drivers()) drivers->children.push_back(string_tree("of_" + tip));
}

void carry_otherwise(Tree& root, Random& random) {
  const Parts parts(root);
  Tree* const body = parts.any_body(random);
  if (!body || body->kind != Tree::Kind::object) return;
  const bool is_point = random.one_in(2);
  const std::vector<std::string>& names = is_point ? parts.points : parts.vectors;
  Tree& carried = (*body)[is_point ? "points" : "vectors"];
  if (carried.kind != Tree::Kind::list) put(carried, list({}));
  if (!carried.children.empty() && random.one_in(2))
    carried.children.erase(carried.children.begin() +
                           static_cast<std::ptrdiff_t>(random.below(carried.children.size())));
  else if (!names.empty())
    carried.children.push_back(string_tree(random.pick(names)));
}

void give_length(Tree& root, Random& random) {
  const Parts parts(root);
  if (Tree* const body = parts.any_body(random); body && body->kind == Tree::Kind::object)
    put((*body)["length"], random.one_in(3) ? scalar(std::string(extreme_number(random)))
                                            : scalar(1 + random.around_zero()));
}

Tree any_direction(const Parts& parts, Random& random) {
  if (!parts.vectors.empty() && random.one_in(2)) return string_tree(random.pick(parts.vectors));
  return some_of(parts.points, random, 2);
}

void add_coordinate(Tree& root, Random& random) {
  const Parts parts(root);
  if (!parts.measured() || parts.points.empty()) return;
  Tree c = object();
  switch (random.below(5)) {
    case 0:
      put(c["distance"], some_of(parts.points, random, 2));
      break;
    case 1:
      put(c["distance"], some_of(parts.points, random, 2));
      if (!parts.vectors.empty()) put(c["along"], string_tree(random.pick(parts.vectors)));
      break;
    case 2:
      put(c["component"], string_tree(random.pick(parts.points)));
      put(c["axis"], string_tree(std::string(1, "xyzw"[random.below(4)])));
      break;
    default:
      put(c["angle"], any_direction(parts, random));
      if (!parts.vectors.empty() && random.one_in(2))
        put(c["from"], string_tree((random.one_in(3) ? "-" : "") + random.pick(parts.vectors)));
      else if (random.one_in(2))
        put(c["from"], any_direction(parts, random));
      if (c.find("from") && random.one_in(2)) put(c["towards"], any_direction(parts, random));
      break;
  }
  if (random.one_in(3)) put(c["estimate"], scalar(3 * random.around_zero()));
  const std::string name = "c" + std::to_string(random.below(1000));
  put((*parts.measured())[name], std::move(c));
  if (Tree* const drivers = parts.drivers(); drivers && random.one_in(2)) {
    if (drivers->children.empty() || random.one_in(3))
      drivers->children.push_back(string_tree(name));
    else
      put(random.pick(drivers->children), string_tree(name));
  }
}

void remove_coordinate(Tree& root, Random& random) {
  const Parts parts(root);
  Tree* const all = parts.measured();
  if (all && !all->children.empty())
    all->children.erase(all->children.begin() +
                        static_cast<std::ptrdiff_t>(random.below(all->children.size())));
}

void estimate(Tree& root, Random& random) {
  const Parts parts(root);
  Tree* const all = parts.measured();
  if (!all || all->children.empty()) return;
  Tree& coordinate = random.pick(all->children);
  if (coordinate.kind == Tree::Kind::object)
    put(coordinate["estimate"], random.one_in(2) ? scalar(std::string(extreme_number(random)))
                                                 : scalar(4 * random.around_zero()));
}

void drive_otherwise(Tree& root, Random& random) {
  const Parts parts(root);
  Tree* const drivers = parts.drivers();
  if (!drivers || parts.coordinates.empty()) return;
  const Tree driven = string_tree(random.pick(parts.coordinates));
  if (drivers->children.empty() || random.one_in(3))
    drivers->children.push_back(driven);
  else if (random.one_in(3))
    drivers->children.pop_back();
  else
    put(random.pick(drivers->children), driven);
}

void change_units(Tree& root, Random& random) {
  const Parts parts(root);
  if (!parts.mechanism) return;
  static constexpr std::array<std::string_view, 6> lengths = {"m", "mm", "cm", "in", "1", "km"};
  Tree& units = (*parts.mechanism)["units"];
  if (units.kind != Tree::Kind::object) put(units, object());
  if (random.one_in(2))
    put(units["length"], string_tree(random.pick(lengths)));
  else
    put(units["angle"], string_tree(random.one_in(2) ? "deg" : "rad"));
}

constexpr TreeMutation all_mechanism_mutations[] = {
    change_joint_type, remove_joint,      repeat_joint,
    reverse_joint,     add_joint,         weld,
    ground_body,       remove_body,       add_body,
    carry_otherwise,   give_length,       add_coordinate,
    add_coordinate,    remove_coordinate, estimate,
    drive_otherwise,   drive_otherwise,   change_units};

}  // namespace

std::span<const TreeMutation> mechanism_mutations() { return all_mechanism_mutations; }

}  // namespace desmo::fuzz
