#include "formulations/modelling/groups/matching.h"

#include <algorithm>

#include "cases/mechanism/disjoint_sets.h"

namespace desmo {

namespace {

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
  return triplets;
}

}  // namespace

Matching::Matching(const RigidBodies& rigid, const std::vector<Restriction>& all)
    : all_(all), bodies_(static_cast<int>(rigid.list.size())) {
  std::vector<int> first_freedom(bodies_ + 1, 0);
  for (int b = 0; b < bodies_; ++b) {
    first_freedom[b + 1] = first_freedom[b] + rigid.list[b].freedoms;
    body_of_freedom_.insert(body_of_freedom_.end(), rigid.list[b].freedoms, b);
  }
  for (std::size_t r = 0; r < all.size(); ++r)
    restriction_of_row_.insert(restriction_of_row_.end(), all[r].count, static_cast<int>(r));
  form_ = decompose(incidence(all, first_freedom));
}

Components Matching::components() const {
  Components result{0, std::vector<int>(bodies_, -1), std::vector<int>(all_.size(), -1)};
  add_irreducible(result);
  add_surplus(result);
  return result;
}

void Matching::add_irreducible(Components& c) const {
  for (int block = 0; block < form_->nb; ++block) {
    if (form_->s[block] < form_->cc[2] || form_->s[block] >= form_->cc[3]) continue;
    for (int j = form_->s[block]; j < form_->s[block + 1]; ++j)
      c.of_body[body_of_freedom_[form_->q[j]]] = c.count;
    for (int i = form_->r[block]; i < form_->r[block + 1]; ++i)
      c.of_restriction[restriction_of_row_[form_->p[i]]] = c.count;
    ++c.count;
  }
}

void Matching::add_surplus(Components& c) const {
  DisjointSets joined(bodies_);  // bodies that one surplus restriction concerns
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

std::vector<int> Matching::bodies_of_columns(int begin, int end) const {
  std::vector<int> result;
  for (int j = begin; j < end; ++j) result.push_back(body_of_freedom_[form_->q[j]]);
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace desmo
