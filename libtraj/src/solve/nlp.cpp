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

Nlp::Lanes lanes(const Vec3& v) { return {v[0], v[1], v[2], 0}; }

}  // namespace

Nlp::Nlp(NlpSpec spec) : spec_(std::move(spec)) {
  assert(spec_.corridor.size() >= 1 && spec_.state.size() == spec_.corridor.size() + 1);
  for (const QuadraticLimit& limit : spec_.limits) {
    limits_.push_back({lanes(limit.weight), lanes(limit.shift)});
  }
  for (const State& state : spec_.state) {
    guess_.insert(guess_.end(), {lanes(state.position), lanes(state.velocity),
                                 lanes(state.acceleration), lanes(state.jerk)});
  }
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
      if (row.order > 0 || row.normal[static_cast<std::size_t>(i)] != 0) f(m, i);
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
        add_row({k, 0, point, lanes(plane.normal), 0, false, 0});
        bound_.push_back(plane.offset);
      }
      groups_.push_back({0, point, first, rows_.size()});
    }
    for (std::size_t l = 0; l < spec_.limits.size(); ++l) {
      const QuadraticLimit& limit = spec_.limits[l];
      for (int point = 0; point < kPoints - limit.order; ++point) {
        if (!moves(k, limit.order, point)) continue;
        add_row({k, limit.order, point, {}, l, false, 0});
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

// Adds derivatives by the states of a piece.
SKYWAY_FOUR_LANES inline void Nlp::add_to_states(std::size_t piece,
                                                 const std::array<Lanes, kStates>& pull,
                                                 double factor, std::vector<double>& out) const {
  for (int m = 0; m < kStates; ++m) {
    const int first = global(piece, local_of(m, 0));
    if (first < 0) continue;
    const double share = factor * scale(piece, local_of(m, 0));
    for (std::size_t i = 0; i < 3; ++i) {
      out[static_cast<std::size_t>(first) + i] += share * pull[static_cast<std::size_t>(m)][i];
    }
  }
}

double Nlp::objective(std::span<const double> x) const {
  const auto sum = [&]() SKYWAY_FOUR_LANES {
    double out = 0;
    for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
      Piece p = piece(k, x);
      p.shift_to_start();
      std::array<Lanes, kStates> half;
      p.snap_times_states<0>(half);
      out += p.time + spec_.rho * p.times_states(half);
    }
    return out;
  };
  return with_four_lanes(sum);
}

std::vector<double> Nlp::gradient(std::span<const double> x) const {
  std::vector<double> out(x.size(), 0.0);
  const auto add_pieces = [&]() SKYWAY_FOUR_LANES {
    for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
      Piece p = piece(k, x);
      p.shift_to_start();
      std::array<Lanes, kStates> half;
      p.snap_times_states<1>(half);
      out[kPiece * k] += 1 + spec_.rho * p.times_states(half);
      p.snap_times_states<0>(half);
      add_to_states(k, half, 2 * spec_.rho, out);
    }
  };
  with_four_lanes(add_pieces);
  return out;
}

std::vector<double> Nlp::constraint_values(std::span<const double> x) const {
  std::vector<double> out(rows_.size());
  const auto add_pieces = [&]() SKYWAY_FOUR_LANES {
    for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
      const Piece p = piece(k, x);
      for (const Group& group : groups(k)) {
        Lanes z;
        p.value(group.order, group.point, z);
        for (std::size_t r = group.first_row; r < group.last_row; ++r) {
          const Row& row = rows_[r];
          Four terms;
          if (row.order == 0) {
            terms = four(row.normal.data()) * four(z.data());
          } else {
            const LimitLanes& limit = limits_[row.limit];
            const Four from = four(z.data()) + four(limit.shift.data());
            terms = four(limit.weight.data()) * (from * from);
          }
          out[r] = terms[0] + terms[1] + terms[2];
        }
      }
    }
  };
  with_four_lanes(add_pieces);
  return out;
}

std::vector<Nlp::Point> Nlp::points(std::span<const double> x, std::vector<Point> memory) const {
  std::vector<Point> out = std::move(memory);
  out.resize(groups_.size());
  const auto add_pieces = [&]() SKYWAY_FOUR_LANES {
    for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
      const Piece p = piece(k, x);
      for (std::size_t g = first_group_[k]; g < first_group_[k + 1]; ++g) {
        p.point(groups_[g].order, groups_[g].point, out[g]);
      }
    }
  };
  with_four_lanes(add_pieces);
  return out;
}

std::vector<double> Nlp::jacobian(std::span<const double> x) const {
  std::vector<double> out;
  out.reserve(jacobian_entries_.size());
  const std::vector<Point> points = this->points(x);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Point& z = points[g];
    for (std::size_t r = groups_[g].first_row; r < groups_[g].last_row; ++r) {
      const Row& row = rows_[r];
      Lanes by_point;
      slope(row, z.value, by_point.data());
      for_each_local(row, [&](int m, int i) {
        out.push_back(by_point[static_cast<std::size_t>(i)] *
                      z.weight[static_cast<std::size_t>(m)] * scale(row.piece, local_of(m, i)));
      });
      if (!row.on_time) continue;
      out.push_back(by_point[0] * z.dt[0] + by_point[1] * z.dt[1] + by_point[2] * z.dt[2]);
    }
  }
  return out;
}

std::vector<double> Nlp::jacobian_times(std::span<const Point> points,
                                        std::span<const double> d) const {
  std::vector<double> out(rows_.size());
  const auto add_pieces = [&]() SKYWAY_FOUR_LANES {
    for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
      std::array<Lanes, kStates> step{};
      for (int m = 0; m < kStates; ++m) {
        const int first = global(k, local_of(m, 0));
        if (first < 0) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          step[static_cast<std::size_t>(m)][i] =
              scale(k, local_of(m, 0)) * d[static_cast<std::size_t>(first) + i];
        }
      }
      for (std::size_t g = first_group_[k]; g < first_group_[k + 1]; ++g) {
        const Point& z = points[g];
        Four moved = d[kPiece * k] * four(z.dt.data());
#pragma GCC unroll 8
        for (std::size_t m = 0; m < kStates; ++m) moved += z.weight[m] * four(step[m].data());
        for (std::size_t r = groups_[g].first_row; r < groups_[g].last_row; ++r) {
          Lanes by_point;
          slope(rows_[r], z.value, by_point.data());
          const Four terms = four(by_point.data()) * moved;
          out[r] = terms[0] + terms[1] + terms[2];
        }
      }
    }
  };
  with_four_lanes(add_pieces);
  return out;
}

std::vector<double> Nlp::transposed_jacobian_times(std::span<const Point> points,
                                                   std::span<const double> v) const {
  std::vector<double> out(start_.size(), 0.0);
  const auto add_pieces = [&]() SKYWAY_FOUR_LANES {
    for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
      std::array<Lanes, kStates> pull{};
      Four in_time = {};
      for (std::size_t g = first_group_[k]; g < first_group_[k + 1]; ++g) {
        const Point& z = points[g];
        Four sum = {};
        for (std::size_t r = groups_[g].first_row; r < groups_[g].last_row; ++r) {
          Lanes by_point;
          slope(rows_[r], z.value, by_point.data());
          sum += v[r] * four(by_point.data());
        }
#pragma GCC unroll 8
        for (std::size_t m = 0; m < kStates; ++m) four(pull[m].data()) += z.weight[m] * sum;
        in_time += sum * four(z.dt.data());
      }
      out[kPiece * k] += in_time[0] + in_time[1] + in_time[2];
      add_to_states(k, pull, 1, out);
    }
  };
  with_four_lanes(add_pieces);
  return out;
}

Trajectory Nlp::trajectory(std::span<const double> x) const {
  const auto state = [&](std::size_t index) {
    std::array<Lanes, 4> parts;
    joint(index, x, parts.data());
    const auto part = [&](std::size_t q) { return Vec3(parts[q][0], parts[q][1], parts[q][2]); };
    return State{part(0), part(1), part(2), part(3)};
  };
  Trajectory out;
  for (std::size_t k = 0; k < spec_.corridor.size(); ++k) {
    out.segments.push_back(hermite(state(k), state(k + 1), x[kPiece * k]));
  }
  return out;
}

}  // namespace traj
