#pragma once

// The optimiser's problem: variables, constraints, and their exact derivatives.

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "curve/hermite_form.h"
#include "four_lanes.h"
#include "traj/curve/trajectory.h"
#include "traj/solve/corridor.h"

namespace traj {

// A limit on a derivative z of the position: the sum of weight (z + shift)^2 over the axes <=
// bound.
struct QuadraticLimit {
  int order = 1;
  Vec3 weight;
  Vec3 shift = Vec3::Zero();
  double bound = 1;
};

// What the problem is made of.
struct NlpSpec {
  Corridor corridor;
  std::vector<State> state;  // the guess: one more than pieces; first and last are fixed, without
                             // acceleration and jerk
  std::vector<double> time;  // the guess: one a piece
  std::vector<QuadraticLimit> limits;
  double rho = 1e-3;
  std::vector<std::array<double, 4>> scale;  // of p, v, a, j at each joint; durations have none
};

// Variables in the order T0, X1, T1, X2, ..., T(n-1): durations, and scaled joint states
// X = (p - guess, v, a, j), so that a piece depends on at most kLocal in a row. Every constraint
// reads g(x) <= bound.
class Nlp {
 public:
  // What a piece depends on, in the order of local indices: the state at its start, its duration,
  // the state at its end.
  static constexpr int kJoint = 12;         // p, v, a, j of a joint along each axis
  static constexpr int kTime = kJoint;      // where the duration is
  static constexpr int kPiece = kTime + 1;  // where the second state begins; variables a piece adds
  static constexpr int kLocal = kPiece + kJoint;

  explicit Nlp(NlpSpec spec);

  struct Entry {  // of a sparse matrix
    int row;
    int column;
  };
  using Block = Eigen::Matrix<double, kLocal, kLocal>;

  using Lanes = std::array<double, 4>;  // x, y, z and 0

  // A Bernstein point of a derivative, sum of weight[m] state[m], and its own derivatives in time.
  struct Point {
    Lanes value, dt, dtt;
    std::array<double, kStates> weight, weight_dt;
  };

  struct Piece;  // the states and the duration of a piece, in metres and seconds (nlp_piece.h)

  int variables() const { return static_cast<int>(start_.size()); }
  int constraints() const { return static_cast<int>(rows_.size()); }
  const std::vector<double>& start() const { return start_; }
  const std::vector<double>& lower() const { return lower_; }
  const std::vector<double>& upper() const { return upper_; }
  const std::vector<double>& bound() const { return bound_; }

  double objective(std::span<const double> x) const;
  std::vector<double> gradient(std::span<const double> x) const;
  std::vector<double> constraint_values(std::span<const double> x) const;
  // The points that are constrained, piece by piece, which all first and second derivatives of the
  // constraints at x are made of. `memory` is used again.
  std::vector<Point> points(std::span<const double> x, std::vector<Point> memory = {}) const;
  const std::vector<Entry>& jacobian_entries() const { return jacobian_entries_; }
  std::vector<double> jacobian(std::span<const double> x) const;

  // The Lagrangian's Hessian, factor * objective + sum of multiplier * constraint: lower triangle,
  // one block a piece, so entries repeat and add up. Each block has its eigenvalues made
  // positive.
  const std::vector<Entry>& hessian_entries() const { return hessian_entries_; }
  std::vector<double> hessian(std::span<const double> x, double factor,
                              std::span<const double> multipliers) const;

  // The exact block of one piece, its lower triangle; rows and columns of what is fixed are 0.
  Block hessian_block(std::size_t piece, std::span<const double> x, double factor,
                      std::span<const double> multipliers) const;
  // The same plus the piece's part of J' diag(weights) J, where J is the constraints' Jacobian.
  // `points` are those at x.
  Block condensed_block(std::size_t piece, std::span<const double> x, std::span<const Point> points,
                        double factor, std::span<const double> multipliers,
                        std::span<const double> weights) const {
    Block block = Block::Zero();
    condense(piece, x, points, factor, multipliers, weights, block);
    return block;
  }
  // The same, in place: writes the lower triangle, and what else is written stays 0.
  void condense(std::size_t piece, std::span<const double> x, std::span<const Point> points,
                double factor, std::span<const double> multipliers, std::span<const double> weights,
                Block& block) const;
  int global(std::size_t piece, int local) const;  // -1 when fixed
  std::size_t pieces() const { return spec_.corridor.size(); }

  // J d, a number a constraint, and J' v, one a variable; J is that at the x of the points.
  std::vector<double> jacobian_times(std::span<const Point> points,
                                     std::span<const double> d) const;
  std::vector<double> transposed_jacobian_times(std::span<const Point> points,
                                                std::span<const double> v) const;

  Trajectory trajectory(std::span<const double> x) const;

 private:
  struct Row {
    std::size_t piece;
    int order;  // of the derivative; 0: a plane
    int point;  // Bernstein index
    Lanes normal;
    std::size_t limit;  // its number; of derivatives only
    bool on_time;       // whether it depends on the duration
    std::size_t first_entry;
  };
  struct Group {  // the rows of one Bernstein point
    int order;
    int point;
    std::size_t first_row;
    std::size_t last_row;  // one past
  };
  struct LimitLanes {  // of a QuadraticLimit
    Lanes weight, shift;
  };

  // Writes position, velocity, acceleration and jerk of a joint.
  void joint(std::size_t joint, std::span<const double> x, Lanes* out) const;
  Piece piece(std::size_t index, std::span<const double> x) const;
  double scale(std::size_t piece, int local) const;
  const Vec3& fixed_part(std::size_t piece, int state) const;
  bool moves(std::size_t piece, int order, int point) const;
  // The constraint's derivative by its Bernstein point.
  SKYWAY_FOUR_LANES void slope(const Row& row, const Lanes& z, double* out) const {
    if (row.order == 0) {
      four(out) = four(row.normal.data());
    } else {
      const LimitLanes& limit = limits_[row.limit];
      four(out) = 2 * four(limit.weight.data()) * (four(z.data()) + four(limit.shift.data()));
    }
  }
  std::span<const Group> groups(std::size_t piece) const;
  void add_to_states(std::size_t piece, const std::array<Lanes, kStates>& pull, double factor,
                     std::vector<double>& out) const;
  void add_variables();
  void add_rows();
  void add_row(Row row);
  void add_hessian_entries();
  template <class F>
  void for_each_local(const Row& row, const F& f) const;

  NlpSpec spec_;
  std::vector<Lanes> guess_;  // four a joint
  std::vector<LimitLanes> limits_;
  std::vector<double> start_, lower_, upper_, bound_;
  std::vector<Row> rows_;
  std::vector<Group> groups_;
  std::vector<std::size_t> first_group_;  // of each piece, and one past the end
  std::vector<Entry> jacobian_entries_;
  std::vector<Entry> hessian_entries_;
};

}  // namespace traj
