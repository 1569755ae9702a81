#include "formulations/modelling/groups/group_order.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace desmo {

Structure order_groups(const RigidBodies& rigid, const std::vector<Restriction>& all,
                       const Components& components) {
  std::vector<std::vector<int>> members(components.count), before(components.count),
      next(components.count);
  std::vector<int> restriction_count(components.count, 0);
  for (int b = 1; b < static_cast<int>(rigid.list.size()); ++b)
    members[components.of_body[b]].push_back(b);
  for (std::size_t r = 0; r < all.size(); ++r) {
    const int own = components.of_restriction[r];
    if (own < 0) continue;
    restriction_count[own] += all[r].count;
    for (const int b : all[r].bodies)
      if (components.of_body[b] != own) before[own].push_back(components.of_body[b]);
  }
  std::vector<int> waiting(components.count);
  for (int c = 0; c < components.count; ++c) {
    std::ranges::sort(before[c]);
    before[c].erase(std::unique(before[c].begin(), before[c].end()), before[c].end());
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

}  // namespace desmo
