#include "formulations/modelling/groups/structure.h"

#include <algorithm>
#include <queue>
#include <ranges>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/disjoint_sets.h"
#include "cases/mechanism/names.h"
#include "formulations/model/csparse.h"

namespace desmo {

namespace {

/// Components of the mechanism: the component of each rigid body and of each restriction; −1: none
/// (the ground).
struct Components {
  int count = 0;
  std::vector<int> of_body, of_restriction;
};

/// A maximum matching between the restrictions of a mechanism and the freedoms of its bodies. It
/// results from the Dulmage–Mendelsohn decomposition of their incidence matrix (restrictions ×
/// freedoms).
class Matching {
 public:
  /// Computes the matching. restrictions must outlive it.
  Matching(const RigidBodies& rigid, const std::vector<Restriction>& restrictions)
      : all_(restrictions), bodies_(rigid.list.size()) {
    std::vector<int> first_freedom{0};
    for (const RigidBody& body : rigid.list) {
      body_of_freedom_.resize(first_freedom.back() + body.freedoms,
                              static_cast<int>(first_freedom.size()) - 1);
      first_freedom.push_back(static_cast<int>(body_of_freedom_.size()));
    }
    std::vector<std::pair<int, int>> ones;
    for (std::size_t r = 0; r < all_.size(); ++r)
      for (int i = 0; i < all_[r].count; ++i) {
        for (const int b : all_[r].bodies)
          for (int j = first_freedom[b]; j < first_freedom[b + 1]; ++j)
            ones.emplace_back(restriction_of_row_.size(), j);
        restriction_of_row_.push_back(static_cast<int>(r));
      }
    form_ = decompose(static_cast<int>(restriction_of_row_.size()), first_freedom.back(), ones);
  }

  /// Returns the number of freedoms that nothing determines.
  int undetermined() const { return form_->cc[1]; }
  /// Returns the rigid bodies of the under-determined block, any of which these freedoms may belong
  /// to, ascending.
  std::vector<int> undetermined_bodies() const { return bodies_of_columns(0, form_->cc[2]); }

  /// Returns a component for each irreducible block. Over-constrained bodies that a restriction
  /// connects form one component.
  Components components() const {
    Components result{0, std::vector<int>(bodies_, -1), std::vector<int>(all_.size(), -1)};
    add_irreducible(result);
    add_surplus(result);
    return result;
  }

 private:
  void add_irreducible(Components& c) const {
    for (int block = 0; block < form_->nb; ++block) {
      if (form_->s[block] < form_->cc[2] || form_->s[block] >= form_->cc[3]) continue;
      for (int j = form_->s[block]; j < form_->s[block + 1]; ++j)
        c.of_body[body_of_freedom_[form_->q[j]]] = c.count;
      for (int i = form_->r[block]; i < form_->r[block + 1]; ++i)
        c.of_restriction[restriction_of_row_[form_->p[i]]] = c.count;
      ++c.count;
    }
  }

  void add_surplus(Components& c) const {
    DisjointSets joined(bodies_);  // sets of bodies that surplus restrictions connect
    std::vector<int> restrictions;
    for (int i = form_->rr[2]; i < form_->rr[4]; ++i)
      restrictions.push_back(restriction_of_row_[form_->p[i]]);
    for (const int r : restrictions)
      for (const int b : all_[r].bodies) joined.unite(b, all_[r].bodies.front());
    for (const int b : bodies_of_columns(form_->cc[3], form_->cc[4])) {
      int& of_all = c.of_body[joined.find(b)];
      if (of_all < 0) of_all = c.count++;
      c.of_body[b] = of_all;
    }
    for (const int r : restrictions) c.of_restriction[r] = c.of_body[all_[r].bodies.front()];
  }

  std::vector<int> bodies_of_columns(int begin, int end) const {
    std::set<int> bodies;
    for (int j = begin; j < end; ++j) bodies.insert(body_of_freedom_[form_->q[j]]);
    return {bodies.begin(), bodies.end()};
  }

  const std::vector<Restriction>& all_;
  std::size_t bodies_;
  std::vector<int> body_of_freedom_, restriction_of_row_;
  CSparseForm form_;
};

/// Returns the components as structural groups in solution order. A group comes after the groups
/// whose bodies its restrictions involve. Ties are broken by the groups' first bodies.
Structure order_groups(const RigidBodies& rigid, const std::vector<Restriction>& all,
                       const Components& components) {
  std::vector<std::vector<int>> members(components.count), next(components.count);
  std::vector<std::set<int>> before(components.count);
  std::vector<int> restriction_count(components.count, 0);
  for (int b = 1; b < static_cast<int>(rigid.list.size()); ++b)
    members[components.of_body[b]].push_back(b);
  for (std::size_t r = 0; r < all.size(); ++r) {
    const int own = components.of_restriction[r];
    if (own < 0) continue;
    restriction_count[own] += all[r].count;
    for (const int b : all[r].bodies)
      if (components.of_body[b] != own) before[own].insert(components.of_body[b]);
  }
  std::vector<int> waiting(components.count);
  for (int c = 0; c < components.count; ++c) {
    waiting[c] = static_cast<int>(before[c].size());
    for (const int b : before[c]) next[b].push_back(c);
  }

  const auto later = [&](int a, int b) { return members[a].front() > members[b].front(); };
  std::priority_queue<int, std::vector<int>, decltype(later)> ready(later);
  for (int c = 0; c < components.count; ++c)
    if (waiting[c] == 0) ready.push(c);
  Structure structure;
  structure.of_body.assign(rigid.list.size(), -1);
  std::vector<int> position(components.count, -1);
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

std::string names_of(const Mechanism& mechanism, const RigidBodies& rigid,
                     const std::vector<int>& list) {
  constexpr int shown = 8;
  const auto name = [&](int i) {
    return "'" + mechanism.bodies[rigid.list[i].bodies.front()].name + "'";
  };
  return joined(list | std::views::take(shown), name) + (std::ssize(list) > shown ? ", …" : "");
}

[[noreturn]] void refuse_undetermined(const Mechanism& mechanism, const RigidBodies& rigid,
                                      const std::vector<int>& bodies, int missing) {
  // Coordinates that a request defines come after the mechanism's own.
  const auto measured =
      std::ranges::find_if(mechanism.coordinates, [&](const Mechanism::Coordinate& c) {
        return !c.driven && std::ranges::any_of(bodies_related(rigid, c), [&](int b) {
          return std::ranges::binary_search(bodies, b);
        });
      });
  std::string spins;
  for (const int b : bodies)
    if (const std::string about = undetermined_spin(mechanism, rigid, b); !about.empty())
      spins += "; '" + mechanism.bodies[rigid.list[b].bodies.front()].name +
               "' is free to spin about " + about + ", which its other points do not follow";
  throw std::invalid_argument(mechanism.name + " is under-constrained: " + std::to_string(missing) +
                              (missing == 1 ? " freedom" : " freedoms") + " among " +
                              names_of(mechanism, rigid, bodies) + (missing == 1 ? " is" : " are") +
                              " determined by no joint or driver" + spins + "; add a driver" +
                              (measured == mechanism.coordinates.end()
                                   ? " (declare a coordinate to drive)"
                                   : ", such as '" + measured->name + "',") +
                              " or a joint");
}

}  // namespace

Structure find_structure(const Mechanism& mechanism, const RigidBodies& rigid) {
  if (rigid.list.size() == 1)
    throw std::invalid_argument(mechanism.name + " has no body that moves");
  const std::vector<Restriction> all = find_restrictions(mechanism, rigid);
  const Matching matching(rigid, all);
  if (const int missing = matching.undetermined(); missing > 0)
    refuse_undetermined(mechanism, rigid, matching.undetermined_bodies(), missing);
  return order_groups(rigid, all, matching.components());
}

}  // namespace desmo
