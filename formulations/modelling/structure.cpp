#include "formulations/modelling/structure.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <string>

#include "formulations/csparse.h"

namespace desmo {

namespace {

/// Bodies that one restriction concerns, and how many equal restrictions there are.
struct Restriction {
  std::vector<int> bodies;
  int count;
};

std::vector<Restriction> collect_restrictions(const Description& d, const RigidBodies& rigid) {
  std::vector<Restriction> all;
  for (const Description::Joint& j : d.joints) {
    Restriction r{{}, restrictions(j.type, d.dimension)};
    for (const int b : j.bodies)
      if (rigid.of_body[b] != 0) r.bodies.push_back(rigid.of_body[b]);
    std::ranges::sort(r.bodies);
    const bool one_body = rigid.of_body[j.bodies[0]] == rigid.of_body[j.bodies[1]];
    if (!one_body) all.push_back(std::move(r));
  }
  for (const Description::Coordinate& c : d.coordinates) {
    if (!c.driven) continue;
    all.push_back({bodies_related(rigid, c), 1});
    if (all.back().bodies.empty())
      throw std::invalid_argument("driver '" + c.name + "' measures nothing that can move");
  }
  return all;
}

/// Restrictions × freedoms.
CSparseMatrix incidence(const std::vector<Restriction>& all,
                        const std::vector<int>& first_freedom) {
  int rows = 0;
  std::size_t entries = 1;
  for (const Restriction& r : all) {
    rows += r.count;
    for (const int b : r.bodies)
      entries += static_cast<std::size_t>(r.count) * (first_freedom[b + 1] - first_freedom[b]);
  }
  CSparseMatrix triplets(
      cs_di_spalloc(rows, first_freedom.back(), static_cast<int>(entries), 1, 1));
  if (!triplets) throw std::bad_alloc();
  int row = 0;
  for (const Restriction& r : all)
    for (int i = 0; i < r.count; ++i, ++row)
      for (const int b : r.bodies)
        for (int j = first_freedom[b]; j < first_freedom[b + 1]; ++j)
          cs_di_entry(triplets.get(), row, j, 1);
  return CSparseMatrix(cs_di_compress(triplets.get()));
}

std::string names_of(const Description& d, const RigidBodies& rigid, const std::vector<int>& list) {
  constexpr std::size_t shown = 8;
  std::string text;
  for (std::size_t i = 0; i < list.size() && i < shown; ++i)
    text += (i == 0 ? "'" : ", '") + d.bodies[rigid.list[list[i]].bodies.front()].name + "'";
  return list.size() > shown ? text + ", …" : text;
}

[[noreturn]] void refuse_undetermined(const Description& d, const RigidBodies& rigid,
                                      const std::vector<int>& bodies, int missing) {
  std::string measured;
  for (const Description::Coordinate& c : d.coordinates)
    if (!c.driven && std::ranges::any_of(bodies_related(rigid, c), [&](int b) {
          return std::ranges::binary_search(bodies, b);
        }))
      measured += (measured.empty() ? "'" : ", '") + c.name + "'";
  throw std::invalid_argument(
      d.name + " is under-constrained: " + std::to_string(missing) +
      (missing == 1 ? " freedom" : " freedoms") + " among " + names_of(d, rigid, bodies) +
      (missing == 1 ? " is" : " are") + " determined by no joint or driver; add a driver" +
      (measured.empty() ? " (declare a coordinate to drive)" : ", such as " + measured + ",") +
      " or a joint");
}

/// Numbers the components of rigid bodies from component ids; groups depend on each other through
/// the restrictions of the later one.
Structure order_groups(const RigidBodies& rigid, const std::vector<Restriction>& all,
                       const std::vector<int>& component_of_restriction,
                       const std::vector<int>& component, int components) {
  std::vector<std::vector<int>> members(components), before(components), next(components);
  std::vector<int> restriction_count(components, 0);
  for (int b = 1; b < static_cast<int>(rigid.list.size()); ++b) members[component[b]].push_back(b);
  for (std::size_t r = 0; r < all.size(); ++r) {
    const int own = component_of_restriction[r];
    if (own < 0) continue;
    restriction_count[own] += all[r].count;
    for (const int b : all[r].bodies)
      if (component[b] != own) before[own].push_back(component[b]);
  }
  std::vector<int> waiting(components);
  for (int c = 0; c < components; ++c) {
    std::ranges::sort(before[c]);
    before[c].erase(std::unique(before[c].begin(), before[c].end()), before[c].end());
    waiting[c] = static_cast<int>(before[c].size());
    for (const int b : before[c]) next[b].push_back(c);
  }

  // Solution order; where it leaves a choice, the group with the first body goes first.
  const auto later = [&](int a, int b) { return members[a].front() > members[b].front(); };
  std::priority_queue<int, std::vector<int>, decltype(later)> ready(later);
  for (int c = 0; c < components; ++c)
    if (waiting[c] == 0) ready.push(c);
  Structure structure;
  structure.of_body.assign(rigid.list.size(), -1);
  std::vector<int> position(components, -1);
  while (!ready.empty()) {
    const int c = ready.top();
    ready.pop();
    position[c] = static_cast<int>(structure.groups.size());
    StructuralGroup group{members[c], {}, 0, restriction_count[c]};
    for (const int b : before[c]) group.after.push_back(position[b]);
    std::ranges::sort(group.after);
    for (const int b : members[c]) {
      group.freedoms += rigid.list[b].freedoms;
      structure.of_body[b] = position[c];
    }
    structure.groups.push_back(std::move(group));
    for (const int n : next[c])
      if (--waiting[n] == 0) ready.push(n);
  }
  return structure;
}

}  // namespace

int restrictions(Description::JointType type, int dimension) {
  using enum Description::JointType;
  switch (type) {
    case revolute:
      return dimension == 2 ? 2 : 5;
    case prismatic:
      return dimension == 2 ? 2 : 5;
    case revolute_on_slider:
      return 1;
    case cylindrical:
      return 4;
    case universal:
      return 4;
    case spherical:
      return 3;
    case fixed:
      return dimension == 2 ? 3 : 6;
  }
  return 0;
}

std::vector<int> bodies_related(const RigidBodies& rigid, const Description::Coordinate& c) {
  std::vector<int> result;
  const auto add = [&](const std::vector<int>& carriers) {
    if (!carriers.empty() && carriers.front() != 0) result.push_back(carriers.front());
  };
  const auto add_direction = [&](const Description::Direction& direction) {
    if (!direction.is_given()) return;
    if (!direction.is_segment()) return add(rigid.of_vector[direction.vector]);
    const std::vector<int>&a = rigid.of_point[direction.from], &b = rigid.of_point[direction.to];
    std::vector<int> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    if (!both.empty()) return add(both);
    add(a);
    add(b);
  };
  if (c.type == Description::CoordinateType::along) {
    // What slides along the vector are the bodies that carry it, as far as they do.
    for (const int point : {c.of.from, c.of.to}) {
      std::vector<int> both;
      std::ranges::set_intersection(rigid.of_point[point], rigid.of_vector[c.vector],
                                    std::back_inserter(both));
      add(both.empty() ? rigid.of_point[point] : both);
    }
  } else {
    add_direction(c.of);
  }
  add_direction(c.from);
  add_direction(c.towards);
  if (c.point >= 0) add(rigid.of_point[c.point]);
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Structure find_structure(const Description& d, const RigidBodies& rigid) {
  const int bodies = static_cast<int>(rigid.list.size());
  if (bodies == 1) throw std::invalid_argument(d.name + " has no body that moves");
  std::vector<int> first_freedom(bodies + 1, 0), body_of_freedom;
  for (int b = 0; b < bodies; ++b) {
    first_freedom[b + 1] = first_freedom[b] + rigid.list[b].freedoms;
    body_of_freedom.insert(body_of_freedom.end(), rigid.list[b].freedoms, b);
  }
  const std::vector<Restriction> all = collect_restrictions(d, rigid);
  std::vector<int> restriction_of_row;
  for (std::size_t r = 0; r < all.size(); ++r)
    restriction_of_row.insert(restriction_of_row.end(), all[r].count, static_cast<int>(r));

  const CSparseMatrix matrix = incidence(all, first_freedom);
  const CSparseForm form(cs_di_dmperm(matrix.get(), 0));
  if (!form) throw std::bad_alloc();
  const auto bodies_of_columns = [&](int begin, int end) {
    std::vector<int> result;
    for (int j = begin; j < end; ++j) result.push_back(body_of_freedom[form->q[j]]);
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  };
  if (form->cc[1] > 0)
    refuse_undetermined(d, rigid, bodies_of_columns(0, form->cc[2]), form->cc[1]);

  // A group for each irreducible block; bodies with too many restrictions are one group wherever
  // a restriction joins them.
  std::vector<int> component(bodies, -1);
  int components = 0;
  std::vector<int> component_of_restriction(all.size(), -1);
  for (int block = 0; block < form->nb; ++block) {
    if (form->s[block] < form->cc[2] || form->s[block] >= form->cc[3]) continue;
    for (int j = form->s[block]; j < form->s[block + 1]; ++j)
      component[body_of_freedom[form->q[j]]] = components;
    for (int i = form->r[block]; i < form->r[block + 1]; ++i)
      component_of_restriction[restriction_of_row[form->p[i]]] = components;
    ++components;
  }
  const std::vector<int> surplus = bodies_of_columns(form->cc[3], form->cc[4]);
  std::vector<int> leader(bodies);
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](int b) {
    while (leader[b] != b) b = leader[b] = leader[leader[b]];
    return b;
  };
  std::vector<int> surplus_restrictions;
  for (int i = form->rr[2]; i < form->rr[4]; ++i)
    surplus_restrictions.push_back(restriction_of_row[form->p[i]]);
  for (const int r : surplus_restrictions)
    for (const int b : all[r].bodies) leader[find(b)] = find(all[r].bodies.front());
  for (const int b : surplus) {
    if (component[find(b)] < 0) component[find(b)] = components++;
    component[b] = component[find(b)];
  }
  for (const int r : surplus_restrictions)
    component_of_restriction[r] = component[all[r].bodies.front()];
  return order_groups(rigid, all, component_of_restriction, component, components);
}

}  // namespace desmo
