#include "cases/io/requestable.h"

#include <algorithm>
#include <functional>

#include "cases/mechanism/carriers.h"
#include "cases/mechanism/joint_forms.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

// Number of patterns in a request, ≤: each is compared with every name.
constexpr int max_patterns = 100;

/// Adds the names of the entries of a list from index `first` on that can be asked for.
/// - can_be_asked_for: function of the index
template <class Entry>
void fill(RequestKey& names, const std::vector<Entry>& list, const auto& can_be_asked_for,
          int first = 0) {
  for (int i = first; i < static_cast<int>(list.size()); ++i)
    if (can_be_asked_for(i)) names.add(list[i].name, i);
}

}  // namespace

Requestable::Requestable(const Mechanism& mechanism) : mechanism_(mechanism) {
  const Carriers of_points(mechanism_, &Mechanism::Body::points),
      of_vectors(mechanism_, &Mechanism::Body::vectors);
  const auto is_angle = [&](int c) { return mechanism_.coordinates[c].is_angle(); };
  const auto any = [](int) { return true; };
  fill(points, mechanism_.points, [&](int p) { return of_points.is_carried(p); });
  fill(vectors, mechanism_.vectors, [&](int v) { return of_vectors.is_carried(v); });
  fill(angles, mechanism_.coordinates, is_angle);
  fill(distances, mechanism_.coordinates, std::not_fn(is_angle));
  fill(bodies, mechanism_.bodies, any);
  fill(rotations, mechanism_.bodies, any, 1);  // index 0 is the ground
  fill(joints, mechanism_.joints, [&](int j) {
    return turns(mechanism_.joints[j].type) || slides(mechanism_.joints[j].type);
  });
}

std::vector<AskedEntity> Requestable::read(const JsonValue& entry, const RequestKey& names) {
  std::vector<AskedEntity> asked;
  const auto list = entry.find(names.key);
  if (!list) return asked;
  if (list->is_object() && names.defines) {
    for (const JsonValue& defined : list->members())
      asked.push_back({names.find(defined, defined.key()), {}});
    return asked;
  }
  const std::vector<JsonValue> listed = list->elements();
  if (listed.empty()) list->complain("is an empty list; name something or leave it out");
  for (const JsonValue& name : listed) {
    if (name.is_object() && names.defines)
      name.complain("defines something in a list of names; give \"" + names.key +
                    "\": {\"NAME\": …} in an entry of its own");
    if (name.text().find('*') != std::string_view::npos) {
      match(name, names, asked);
    } else {
      check_kind(name, names);
      if (&names == &joints) check_joint(name);
      asked.push_back({names.find(name), {}});
    }
  }
  return asked;
}

void Requestable::match(const JsonValue& pattern, const RequestKey& names,
                        std::vector<AskedEntity>& asked) {
  if (characters(pattern.text()) > max_name)
    pattern.complain("the pattern is longer than " + std::to_string(max_name) +
                     " characters; shorten it");
  if (++patterns_ > max_patterns)
    pattern.complain("the request has more than " + std::to_string(max_patterns) +
                     " patterns with *; join some");
  const std::size_t before = asked.size();
  for (const std::string_view name : names.names())
    if (matches(pattern.text(), name)) asked.push_back({*names.position(name), pattern.text()});
  if (asked.size() == before)
    pattern.complain("the pattern " + in_quotes(pattern.text()) + " matches none of the " +
                     names.key + "; " + suggestion(pattern.text(), names.names()));
}

/// Refuses three names with messages of their own. NameTable::find(), which is called next, would
/// only offer similar names of the key's kind.
/// - the ground, under "rotations"
/// - the name of an entity of another kind, except under "rotations" and "joints"
/// - a point or vector that no body carries, likewise
void Requestable::check_kind(const JsonValue& name, const RequestKey& names) const {
  if (&names == &rotations && name.text() == mechanism_.bodies.front().name)
    name.complain("the ground never turns; name a body that moves");
  if (names.position(name.text()) || &names == &rotations || &names == &joints) return;
  for (const RequestKey* other : {&points, &vectors, &angles, &distances, &bodies})
    if (other->position(name.text()))
      name.complain(in_quotes(name.text()) + " is none of the " + names.key +
                    "; ask for it under \"" + other->key + "\"");
  const auto is_named = [&](const auto& entry) { return entry.name == name.text(); };
  if (std::ranges::any_of(mechanism_.points, is_named) ||
      std::ranges::any_of(mechanism_.vectors, is_named))
    name.complain(in_quotes(name.text()) +
                  " is carried by no body and has no motion; list it in a body");
}

/// Refuses a joint that neither turns about one axis nor slides along one.
void Requestable::check_joint(const JsonValue& name) const {
  if (joints.position(name.text())) return;
  const auto joint = std::ranges::find(mechanism_.joints, name.text(), &Mechanism::Joint::name);
  if (joint == mechanism_.joints.end()) return;
  name.complain(in_quotes(name.text()) + " is a joint of type " +
                in_quotes(find_joint_form(joint->type, mechanism_.dimension)->name) +
                ", which neither turns about one axis nor slides along one; ask for rotations or "
                "points of its bodies");
}

std::string Requestable::read_component(const JsonValue& value) const {
  const std::string_view name = value.text(), entity = name.substr(0, name.rfind('.'));
  const bool is_component =
      entity.size() + 2 == name.size() &&
      std::string_view("xyz").substr(0, mechanism_.dimension).find(name.back()) !=
          std::string_view::npos &&
      (points.position(entity) || vectors.position(entity));
  if (!is_component && !angles.position(name) && !distances.position(name))
    value.complain("unknown coordinate " + in_quotes(name) +
                   "; give one, or a component of a point or vector such as 'C.x'; " +
                   suggestion(name, names_of(mechanism_.coordinates)));
  return std::string(name);
}

}  // namespace desmo
