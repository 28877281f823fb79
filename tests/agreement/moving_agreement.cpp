// moving_agreement [CASES]: both checks against an obstacle that moves, the fast one and the exact
// one, on flights whose contact with it is known by construction: in passing, at a joint, at the
// obstacle's first and last instant, at departure and arrival, at rest on a pad, with obstacles
// that grow from nothing, and at instants that no double is. Exit 1 when either calls a touch
// clear, or refuses what is a micrometre beyond.

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <string>

#include "geom/base/parallel.h"
#include "support/moving_case.h"
#include "traj/together/exact/exact_moving.h"

namespace {

using support::Contact;
using support::MovingCase;
using support::Random;
using traj::Vec3;

// Times are any doubles. Where the flight passes a joint it touches a face, at most 2^-40 m deep.
MovingCase at_any_time(Random& random) {
  MovingCase c;
  const auto vector = [&](double low, double high) {
    return Vec3(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
  };
  c.start = random.uniform(-1e5, 1e5);
  for (int i = 0; i < 2; ++i) {
    traj::Segment s{random.uniform(1e-3, 60), {}, {}};
    for (Vec3& p : s.point) p = vector(-60, 60);
    c.trajectory.segments.push_back(s);
  }
  const Vec3 place = c.trajectory.segments[0].point.back();
  c.trajectory.segments[1].point.front() = place;
  const mpq_class instant = mpq_class(c.start) + mpq_class(c.trajectory.segments[0].duration);
  c.box.from = c.start + c.trajectory.segments[0].duration - random.uniform(1e-6, 50);
  c.box.until = c.box.from + random.uniform(50.1, 99);
  c.box.velocity = vector(-8, 8);
  if (random.below(2)) c.box.growth = vector(0, 2);
  if (random.below(2)) c.room = vector(0, 2);
  c.box.box = {place - Vec3::Constant(600), place + Vec3::Constant(600)};
  const int axis = random.below(3);
  const double side = random.below(2) ? 1 : -1;
  const mpq_class speed = mpq_class(c.box.velocity[axis]) + side * mpq_class(c.box.growth[axis]);
  const mpq_class face = mpq_class(place[axis]) - side * mpq_class(c.room[axis]) -
                         speed * (instant - mpq_class(c.box.from));
  const mpq_class steps = face * (mpz_class(1) << 40);
  mpz_class whole;  // on the grid of 2^-40, on the side of the flight
  if (side > 0) {
    mpz_cdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
  } else {
    mpz_fdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
  }
  const double corner = std::ldexp(whole.get_d(), -40);
  (side > 0 ? c.box.box.max : c.box.box.min)[axis] = corner;
  (side > 0 ? c.box.box.min : c.box.box.max)[axis] = corner - side * 99;
  return c;
}

struct Counts {
  std::size_t cases = 0;
  std::size_t fast = 0;        // that the fast check accepts
  std::size_t exact = 0;       // and the exact one
  std::size_t fast_alone = 0;  // and it refuses
  std::size_t bad = 0;         // no obstacle at all

  void add(const Counts& more) {
    cases += more.cases;
    fast += more.fast;
    exact += more.exact;
    fast_alone += more.fast_alone;
    bad += more.bad;
  }
};

Counts judged(const MovingCase& c) {
  const bool fast = traj::check_moving(c.flight(), c.box, c.parked).clear;
  const bool exact = traj::check_moving_exactly(c.flight(), c.box, c.parked).clear;
  return {1, fast, exact, fast && !exact, traj::moving_box_fault(c.box).has_value()};
}

template <class Make>
Counts judge(std::size_t cases, unsigned seed, const Make& make) {
  constexpr std::size_t kBlock = 500;
  std::vector<Counts> blocks((cases + kBlock - 1) / kBlock);
  geom::parallel_for(blocks.size(), {2, {}}, [&](std::size_t i) {
    Random random(1000003 * seed + i);
    for (std::size_t k = i * kBlock; k < std::min(cases, (i + 1) * kBlock); ++k) {
      blocks[i].add(judged(make(random)));
    }
  });
  Counts all;
  for (const Counts& c : blocks) all.add(c);
  return all;
}

// From 0 to 1 m deep, and much within 1e-6 m.
double depth_of(Random& random) {
  const int kind = random.below(3);
  if (kind == 0) return 0;
  return kind == 1 ? random.stepped(0, 0x1p-20, 0x1p-31) : random.stepped(0, 1, 0x1p-31);
}

constexpr std::array kNames{"in passing",   "at a joint", "at its begin",     "at its end",
                            "at departure", "at arrival", "before departure", "after arrival"};

bool all_kinds(std::size_t each) {
  bool right = true;
  for (int kind = 0; kind < support::kContacts; ++kind) {
    const auto how = static_cast<Contact>(kind);
    const auto seed = static_cast<unsigned>(3 * kind);
    const Counts touching = judge(each, seed + 1, [&](Random& random) {
      return support::contact(random, how, depth_of(random));
    });
    const Counts beyond = judge(each / 2, seed + 2, [&](Random& random) {
      return support::contact(random, how, random.below(2) ? -1e-6 : -0x1p-19);
    });
    const Counts near = judge(each / 2, seed + 3, [&](Random& random) {
      return support::contact(random, how, -random.stepped(0, 0x1p-28, 0x1p-31));
    });
    fmt::print(
        "{:16} touching: {} and {} of {} clear   1e-6 m beyond: {} and {} of {}   within 4e-9 m: "
        "{} "
        "and {} of {}\n",
        kNames[static_cast<std::size_t>(kind)], touching.fast, touching.exact, touching.cases,
        beyond.fast, beyond.exact, beyond.cases, near.fast, near.exact, near.cases);
    right = right && touching.fast == 0 && touching.exact == 0 && beyond.fast == beyond.cases &&
            beyond.exact == beyond.cases && near.fast_alone == 0 &&
            touching.bad + beyond.bad + near.bad == 0;
  }
  return right;
}

}  // namespace

int main(int argc, char** argv) {
  const auto cases = static_cast<std::size_t>(argc > 1 ? std::stod(argv[1]) : 1e5);
  fmt::print("the fast and the exact check:\n");
  bool right = all_kinds(cases / 17);
  const Counts any = judge(cases / 17, 99, at_any_time);
  fmt::print("{:16} touching: {} and {} of {} clear\n", "at any time", any.fast, any.exact,
             any.cases);
  right = right && any.fast == 0 && any.exact == 0 && any.bad == 0;
  return right ? 0 : 1;
}
