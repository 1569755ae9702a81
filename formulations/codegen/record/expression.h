#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace desmo::generate {

// *Recording* runs the constraint code on a scalar that writes an expression graph.

enum class Op {
  constant,
  input,
  add,
  subtract,
  multiply,
  divide,
  negate,
  sine,
  cosine,
  square_root,
  magnitude,  ///< |a|
  table_0,    ///< Taylor coefficient of order 0, at a, of the table whose first number is input b
  table_1,
  table_2,
  table_3,
};

/// Returns the order of a coefficient of a table; -1 for other operations.
constexpr int table_order(Op op) {
  return op < Op::table_0 ? -1 : static_cast<int>(op) - static_cast<int>(Op::table_0);
}

/// A node of the expression graph. Its operands have smaller numbers.
struct Node {
  Op op;
  int a = -1, b = -1;  ///< operands; -1: none
  double value = 0;    ///< value of a constant
  std::string name;    ///< C++ text of an input
  bool moves = false;  ///< depends on an input other than a dimension: a position, rate, weight, …
};

/// The graph that recording scalars (Expr) write. Equal operations on the same operands share one
/// node, and operations on constants are folded. Each node carries its value at every sample point.
/// An elimination judges the sizes of its pivots by these values.
class Graph {
 public:
  /// Makes this the calling thread's current graph until it is destroyed. samples: number of sample
  /// points. Throws std::logic_error when the thread has another graph.
  explicit Graph(int samples);
  ~Graph();
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  /// Returns the calling thread's current graph, which must exist.
  static Graph& current();

  /// Adds an input and returns its node. sample_values: its value at each sample point. moves:
  /// false for a dimension.
  int input(std::string name, std::vector<double> sample_values, bool moves = true);
  /// Return the node of a constant, or of an operation, which they simplify where they can. Throw
  /// std::invalid_argument for a constant that is NaN, such as 0/0.
  int constant(double value);
  int unary(Op op, int a);
  int binary(Op op, int a, int b);

  const Node& node(int id) const { return nodes_[id]; }
  int size() const { return static_cast<int>(nodes_.size()); }
  std::size_t sample_count() const { return static_cast<std::size_t>(sample_count_); }
  const std::vector<double>& samples(int id) const { return samples_[id]; }
  /// Returns whether the expression is the constant `value`.
  bool is(int id, double value) const;
  /// Returns the constant operand of a product, or of a negated product; 1 for all other nodes.
  double factor(int id) const;

 private:
  /// A constant multiple: the node of the constant (-1: none) and the node that it multiplies.
  struct Scaled {
    int factor, of;
  };
  Scaled as_scaled(int id) const;
  /// Returns whether the expression is 1/of.
  bool is_reciprocal(int id, int of) const;
  int add(Node node, std::vector<double> sample_values);
  int find_or_add(Op op, int a, int b);
  double table_value(Op op, int a, int table, int sample) const;

  int sample_count_;
  std::vector<Node> nodes_;
  std::vector<std::vector<double>> samples_;
  std::map<std::tuple<Op, int, int>, int> operations_;
  std::map<double, int> constants_;
};

/// The recording scalar: arithmetic on it builds the current graph.
class Expr {
 public:
  Expr() : Expr(0.0) {}
  Expr(double value) : id_(Graph::current().constant(value)) {}
  static Expr node(int id) { return Expr(id, 0); }

  int id() const { return id_; }
  bool is_zero() const { return Graph::current().is(id_, 0); }
  bool is_constant() const { return Graph::current().node(id_).op == Op::constant; }
  bool moves() const { return Graph::current().node(id_).moves; }
  const std::vector<double>& samples() const { return Graph::current().samples(id_); }
  double factor() const { return Graph::current().factor(id_); }

  friend Expr operator+(Expr a, Expr b) { return binary(Op::add, a, b); }
  friend Expr operator-(Expr a, Expr b) { return binary(Op::subtract, a, b); }
  friend Expr operator*(Expr a, Expr b) { return binary(Op::multiply, a, b); }
  friend Expr operator/(Expr a, Expr b) { return binary(Op::divide, a, b); }
  friend Expr operator-(Expr a) { return unary(Op::negate, a); }
  friend Expr sin(Expr a) { return unary(Op::sine, a); }
  friend Expr cos(Expr a) { return unary(Op::cosine, a); }
  friend Expr sqrt(Expr a) { return unary(Op::square_root, a); }
  friend Expr abs(Expr a) { return unary(Op::magnitude, a); }
  /// Records a coefficient of a table, whose numbers are inputs with consecutive nodes.
  template <int k>
  friend Expr table_coefficient(const Expr* table, const Expr& x) {
    return table_at(k, table[0], x);
  }
  /// Returns coefficient k, at x, of the table that begins at the input `table`; 0 for k > 3.
  static Expr table_at(int k, Expr table, Expr x) {
    if (k > 3) return 0;
    return binary(static_cast<Op>(static_cast<int>(Op::table_0) + k), x, table);
  }

 private:
  Expr(int id, int) : id_(id) {}
  static Expr binary(Op op, Expr a, Expr b) {
    return node(Graph::current().binary(op, a.id_, b.id_));
  }
  static Expr unary(Op op, Expr a) { return node(Graph::current().unary(op, a.id_)); }

  int id_;
};

/// Returns a new input of the current graph that is 1 at every sample point. It serves as a weight,
/// on which no pivot depends.
Expr weight_input(std::string name);

/// Adds expressions to the end of a list.
void append(std::vector<Expr>& all, const std::vector<Expr>& more);

/// Returns the inputs that an expression reads, without dimensions, ascending by node.
std::vector<Expr> moving_inputs(Expr e);

/// Returns whether an expression contains one of these nodes, which must move (Node::moves).
bool reads(Expr e, const std::vector<Expr>& nodes);

/// Returns the expression with some inputs replaced. by_input: the replacement for each node of an
/// input.
Expr substitute(Expr e, const std::map<int, Expr>& by_input);

}  // namespace desmo::generate
