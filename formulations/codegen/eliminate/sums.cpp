#include "formulations/codegen/eliminate/sums.h"

#include <algorithm>
#include <utility>

namespace desmo::generate {

namespace {

/// Latencies [cycles], rounded.
constexpr int addition = 3, multiplication = 4, division = 13, root = 20, sine_cosine_or_table = 40;

void collect(int id, bool subtracted, const IsWhole& is_whole, std::vector<Term>& terms) {
  const Node& n = Graph::current().node(id);
  const auto add = [&](int term, bool turned) {
    if (is_whole(term))
      terms.push_back({term, turned});
    else
      collect(term, turned, is_whole, terms);
  };
  if (n.op == Op::negate) {
    add(n.a, !subtracted);
  } else if (n.op == Op::add || n.op == Op::subtract) {
    add(n.a, subtracted);
    add(n.b, subtracted != (n.op == Op::subtract));
  } else {
    terms.push_back({id, subtracted});
  }
}

void collect(int id, const IsWhole& is_whole, std::vector<int>& factors) {
  const Node& n = Graph::current().node(id);
  if (n.op != Op::multiply) return factors.push_back(id);
  for (const int factor : {n.a, n.b})
    if (is_whole(factor))
      factors.push_back(factor);
    else
      collect(factor, is_whole, factors);
}

}  // namespace

int ArrivalTimes::of(int id) {
  found_.resize(Graph::current().size(), -1);
  if (found_[id] < 0) found_[id] = find(Graph::current().node(id));
  return found_[id];
}

/// Returns the cycle at which a node is known. The addition of a product takes no further cycle: a
/// single instruction multiplies and adds.
int ArrivalTimes::find(const Node& n) {
  const auto operands = [&] { return std::max(of(n.a), n.b < 0 ? 0 : of(n.b)); };
  const auto is_product = [](int id) { return Graph::current().node(id).op == Op::multiply; };
  switch (n.op) {
    case Op::constant:
      return 0;
    case Op::input: {
      const auto defined = defined_.find(n.name);
      return defined == defined_.end() ? 0 : defined->second;
    }
    case Op::add:
    case Op::subtract:
      return operands() + (is_product(n.a) || is_product(n.b) ? 0 : addition);
    case Op::multiply:
      return operands() + multiplication;
    case Op::divide:
      return operands() + division;
    case Op::square_root:
      return operands() + root;
    case Op::negate:
    case Op::magnitude:
      return operands();
    default:
      return operands() + sine_cosine_or_table;
  }
}

std::vector<Term> terms_of(int id, ArrivalTimes& arrival, const IsWhole& is_whole) {
  std::vector<Term> terms;
  collect(id, false, is_whole, terms);
  std::ranges::stable_sort(terms, {}, [&](const Term& term) { return arrival.of(term.id); });
  if (terms.size() > 1 && terms[0].subtracted && !terms[1].subtracted)
    std::swap(terms[0], terms[1]);
  return terms;
}

std::vector<int> factors_of(int id, ArrivalTimes& arrival, const IsWhole& is_whole) {
  std::vector<int> factors;
  collect(id, is_whole, factors);
  std::ranges::stable_sort(factors, {}, [&](int factor) { return arrival.of(factor); });
  return factors;
}

}  // namespace desmo::generate
