#include "nlp.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "nlp_piece.h"

namespace traj {
namespace {

constexpr double kUnbounded = 1e20;  // beyond Ipopt's nlp_upper_bound_inf
constexpr double kJointReach = 10;   // metres a joint may move

}  // namespace

Nlp::Nlp(NlpSpec spec) : spec_(std::move(spec)) {
  assert(spec_.corridor.size() >= 1 && spec_.state.size() == spec_.corridor.size() + 1);
  add_variables();
  add_rows();
  add_hessian_entries();
}

double Nlp::scale(std::size_t piece, int local) const {
  if (local == kTime) return 1;
  const bool later = local > kTime;
  const int q = (later ? local - kPiece : local) / 3;
  return spec_.scale[piece + (later ? 1 : 0)][static_cast<std::size_t>(q)];
}

int Nlp::global(std::size_t piece, int local) const {
  if (piece == 0 && local < kTime) return -1;
  if (piece + 1 == spec_.corridor.size() && local > kTime) return -1;
  return kPiece * static_cast<int>(piece) - kJoint + local;
}

void Nlp::add_variables() {
  const std::size_t n = spec_.corridor.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double t = spec_.time[k];
    start_.push_back(t);
    lower_.push_back(std::min(0.05, t / 2));
    upper_.push_back(10 * t);
    if (k + 1 == n) break;
    const State& s = spec_.state[k + 1];
    for (int i = 0; i < kJoint; ++i) {
      const bool position = i < 3;
      const std::array<const Vec3*, 4> parts{&s.position, &s.velocity, &s.acceleration, &s.jerk};
      start_.push_back(
          position ? 0 : (*parts[static_cast<std::size_t>(i / 3)])[i % 3] / scale(k + 1, i));
      lower_.push_back(position ? -kJointReach : -kUnbounded);
      upper_.push_back(position ? kJointReach : kUnbounded);
    }
  }
}

// Position, velocity, acceleration or jerk of the guess: of the state at the piece's start, then
// end.
const Vec3& Nlp::fixed_part(std::size_t piece, int m) const {
  const State& s = spec_.state[piece + (m < 4 ? 0 : 1)];
  const std::array<const Vec3*, 4> parts{&s.position, &s.velocity, &s.acceleration, &s.jerk};
  return *parts[static_cast<std::size_t>(power_of(m))];
}

// Whether a point depends on any variable, and is not another piece's too: the first point of a
// derivative is the last of the piece before.
bool Nlp::moves(std::size_t piece, int order, int point) const {
  if (order > 0 && point == 0) return false;
  for (int m = 0; m < kStates; ++m) {
    if (kTables[order][point][m] == 0) continue;
    if (global(piece, local_of(m, 0)) >= 0) return true;
    // Of what is fixed, only what is not at rest moves with the duration.
    if (power_of(m) != order && !fixed_part(piece, m).isZero(0)) return true;
  }
  return false;
}

template <class F>
void Nlp::for_each_local(const Row& row, const F& f) const {
  for (int m = 0; m < kStates; ++m) {
    if (kTables[row.order][row.point][m] == 0 || global(row.piece, local_of(m, 0)) < 0) continue;
    for (int i = 0; i < 3; ++i) {
      if (row.order > 0 || row.normal[i] != 0) f(m, i);
    }
  }
}

void Nlp::add_row(Row row) {
  row.on_time = false;
  for (int m = 0; m < kStates; ++m) {
    if (kTables[row.order][row.point][m] != 0 && power_of(m) != row.order) row.on_time = true;
  }
  row.first_entry = jacobian_entries_.size();
  const int index = static_cast<int>(rows_.size());
  for_each_local(row, [&](int m, int i) {
    jacobian_entries_.push_back({index, global(row.piece, local_of(m, i))});
  });
  if (row.on_time) jacobian_entries_.push_back({index, global(row.piece, kTime)});
  rows_.push_back(row);
}

void Nlp::add_rows() {
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    first_group_.push_back(groups_.size());
    for (int point = 0; point < kPoints; ++point) {
      if (!moves(k, 0, point) || spec_.corridor[k].planes.empty()) continue;
      const std::size_t first = rows_.size();
      for (const Plane& plane : spec_.corridor[k].planes) {
        add_row({k, 0, point, plane.normal, 0, false, 0});
        bound_.push_back(plane.offset);
      }
      groups_.push_back({0, point, first, rows_.size()});
    }
    for (std::size_t l = 0; l < spec_.limits.size(); ++l) {
      const QuadraticLimit& limit = spec_.limits[l];
      for (int point = 0; point < kPoints - limit.order; ++point) {
        if (!moves(k, limit.order, point)) continue;
        add_row({k, limit.order, point, Vec3::Zero(), l, false, 0});
        bound_.push_back(limit.bound);
        groups_.push_back({limit.order, point, rows_.size() - 1, rows_.size()});
      }
    }
  }
  first_group_.push_back(groups_.size());
}

std::span<const Nlp::Group> Nlp::groups(std::size_t piece) const {
  return std::span(groups_).subspan(first_group_[piece],
                                    first_group_[piece + 1] - first_group_[piece]);
}

// The constraint's derivative by its Bernstein point.
Vec3 Nlp::slope(const Row& row, const Vec3& z) const {
  if (row.order == 0) return row.normal;
  const QuadraticLimit& limit = spec_.limits[row.limit];
  return 2 * limit.weight.cwiseProduct(z + limit.shift);
}

void Nlp::add_hessian_entries() {
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    for (int i = 0; i < kLocal; ++i) {
      for (int j = 0; j <= i; ++j) {
        const int row = global(k, i);
        const int column = global(k, j);
        if (row >= 0 && column >= 0) hessian_entries_.push_back({row, column});
      }
    }
  }
}

State Nlp::state(std::size_t joint, std::span<const double> x) const {
  State s = spec_.state[joint];
  if (joint == 0 || joint == spec_.corridor.size()) return s;
  const double* y = &x[kPiece * joint - kJoint];
  const auto part = [&](int q) { return Vec3(y[3 * q], y[3 * q + 1], y[3 * q + 2]); };
  s.position += part(0);
  s.velocity = part(1) * spec_.scale[joint][1];
  s.acceleration = part(2) * spec_.scale[joint][2];
  s.jerk = part(3) * spec_.scale[joint][3];
  return s;
}

Nlp::Piece Nlp::piece(std::size_t index, std::span<const double> x) const {
  const State a = state(index, x);
  const State b = state(index + 1, x);
  const double t = x[kPiece * index];
  return {{a.position, a.velocity, a.acceleration, a.jerk, b.position, b.velocity, b.acceleration,
           b.jerk},
          t,
          Powers(t)};
}

double Nlp::objective(std::span<const double> x) const {
  double sum = 0;
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    Piece p = piece(k, x);
    // The form does not see a common shift; without it large coordinates cancel badly.
    p.state[4] -= p.state[0];
    p.state[0].setZero();
    double snap = 0;
    for (int m = 1; m < kStates; ++m) {
      for (int n = 1; n < kStates; ++n) {
        const int e = power_of(m) + power_of(n) - kDegree;
        snap += kSnapForm[m][n] * p.power(e) * p.state[m].dot(p.state[n]);
      }
    }
    sum += p.time + spec_.rho * snap;
  }
  return sum;
}

std::vector<double> Nlp::gradient(std::span<const double> x) const {
  std::vector<double> out(x.size(), 0.0);
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    Piece p = piece(k, x);
    p.state[4] -= p.state[0];
    p.state[0].setZero();
    double in_time = 1;
    for (int m = 0; m < kStates; ++m) {
      Vec3 pull = Vec3::Zero();
      for (int n = 0; n < kStates; ++n) {
        const int e = power_of(m) + power_of(n) - kDegree;
        pull += (kSnapForm[m][n] * p.power(e)) * p.state[n];
        in_time += spec_.rho * kSnapForm[m][n] * e * p.power(e - 1) * p.state[m].dot(p.state[n]);
      }
      for (int i = 0; i < 3; ++i) {
        const int local = local_of(m, i);
        if (const int g = global(k, local); g >= 0) {
          out[static_cast<std::size_t>(g)] += 2 * spec_.rho * pull[i] * scale(k, local);
        }
      }
    }
    out[kPiece * k] += in_time;
  }
  return out;
}

std::vector<double> Nlp::constraint_values(std::span<const double> x) const {
  std::vector<double> out;
  out.reserve(rows_.size());
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    const Piece p = piece(k, x);
    for (const Group& group : groups(k)) {
      const Vec3 z = p.value(group.order, group.point);
      for (std::size_t r = group.first_row; r < group.last_row; ++r) {
        const Row& row = rows_[r];
        if (row.order == 0) {
          out.push_back(row.normal.dot(z));
          continue;
        }
        const QuadraticLimit& limit = spec_.limits[row.limit];
        out.push_back(limit.weight.dot((z + limit.shift).cwiseAbs2()));
      }
    }
  }
  return out;
}

std::vector<Nlp::Point> Nlp::points(std::span<const double> x) const {
  std::vector<Point> out;
  out.reserve(groups_.size());
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    const Piece p = piece(k, x);
    for (const Group& group : groups(k)) out.push_back(p.point(group.order, group.point));
  }
  return out;
}

std::vector<double> Nlp::jacobian(std::span<const double> x) const {
  std::vector<double> out;
  out.reserve(jacobian_entries_.size());
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    const Piece p = piece(k, x);
    for (const Group& group : groups(k)) {
      const Point z = p.point(group.order, group.point);
      for (std::size_t r = group.first_row; r < group.last_row; ++r) {
        const Row& row = rows_[r];
        const Vec3 by_point = slope(row, z.value);
        for_each_local(row, [&](int m, int i) {
          out.push_back(by_point[i] * z.weight[static_cast<std::size_t>(m)] *
                        scale(k, local_of(m, i)));
        });
        if (row.on_time) out.push_back(by_point.dot(z.dt));
      }
    }
  }
  return out;
}

std::vector<double> Nlp::jacobian_times(std::span<const Point> points,
                                        std::span<const double> d) const {
  std::vector<double> out;
  out.reserve(rows_.size());
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    std::array<Vec3, kStates> step;
    for (int m = 0; m < kStates; ++m) {
      for (int i = 0; i < 3; ++i) {
        const int local = local_of(m, i);
        const int g = global(k, local);
        step[static_cast<std::size_t>(m)][i] =
            g < 0 ? 0 : scale(k, local) * d[static_cast<std::size_t>(g)];
      }
    }
    for (std::size_t g = first_group_[k]; g < first_group_[k + 1]; ++g) {
      const Group& group = groups_[g];
      const Point& z = points[g];
      Vec3 moved = d[kPiece * k] * z.dt;
      for (std::size_t m = 0; m < kStates; ++m) moved += z.weight[m] * step[m];
      for (std::size_t r = group.first_row; r < group.last_row; ++r) {
        out.push_back(slope(rows_[r], z.value).dot(moved));
      }
    }
  }
  return out;
}

std::vector<double> Nlp::transposed_jacobian_times(std::span<const Point> points,
                                                   std::span<const double> v) const {
  std::vector<double> out(start_.size(), 0.0);
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    std::array<Vec3, kStates> pull;
    pull.fill(Vec3::Zero());
    for (std::size_t g = first_group_[k]; g < first_group_[k + 1]; ++g) {
      const Group& group = groups_[g];
      const Point& z = points[g];
      Vec3 sum = Vec3::Zero();
      for (std::size_t r = group.first_row; r < group.last_row; ++r) {
        sum += v[r] * slope(rows_[r], z.value);
      }
      for (std::size_t m = 0; m < kStates; ++m) pull[m] += z.weight[m] * sum;
      out[kPiece * k] += sum.dot(z.dt);
    }
    for (int m = 0; m < kStates; ++m) {
      for (int i = 0; i < 3; ++i) {
        const int local = local_of(m, i);
        const int g = global(k, local);
        if (g < 0) continue;
        out[static_cast<std::size_t>(g)] += scale(k, local) * pull[static_cast<std::size_t>(m)][i];
      }
    }
  }
  return out;
}

Trajectory Nlp::trajectory(std::span<const double> x) const {
  Trajectory out;
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    out.segments.push_back(hermite(state(k, x), state(k + 1, x), x[kPiece * k]));
  }
  return out;
}

}  // namespace traj
