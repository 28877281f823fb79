// pair_agreement [CASES] [EXACT] [FILE]: the check of pairs on flights whose nearest approach is
// known by construction: in passing, at joints, at departure and arrival, at rest, and at instants
// that no double is; and on EXACT more the exact check too. These go to FILE with what was proved,
// for pair_agreement.py. Exit 1 when either check calls a touch apart, or refuses what is a
// micrometre beyond.

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "geom/base/parallel.h"
#include "geom/text/json_line.h"
#include "support/pair_case.h"
#include "traj/record/pair_record.h"
#include "traj/record/trajectory_record.h"
#include "traj/together/pair_check.h"

namespace {

using support::PairCase;
using support::Random;
using traj::Vec3;

bool apart(const PairCase& c) {
  return traj::check_pair(c.first(), c.second(), std::array{c.zone}, c.parked).apart;
}

// A coordinate of a segment at a share of its time, exact.
mpq_class at(const traj::Segment& s, int axis, const mpq_class& share) {
  std::array<mpq_class, traj::kPoints> q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = s.point[i][axis];
  for (std::size_t m = q.size() - 1; m > 0; --m) {
    for (std::size_t i = 0; i < m; ++i) q[i] += share * (q[i + 1] - q[i]);
  }
  return q[0];
}

// Times are any doubles. Where the first flight passes a joint, the second is within 1e-12 m inside
// of the zone, and its own place is no double.
PairCase at_any_time(Random& random) {
  PairCase c;
  const support::ZoneCase zone = support::random_zone(random);
  c.zone = zone.zone;
  c.start_a = random.uniform(-1e5, 1e5);
  c.a.segments = {support::random_segment(random, random.uniform(1e-3, 60)),
                  support::random_segment(random, random.uniform(1e-3, 60))};
  c.a.segments[1].point[0] = c.a.segments[0].point.back();
  traj::Segment s = support::random_segment(random, random.uniform(10, 100));
  const mpq_class instant = mpq_class(c.start_a) + mpq_class(c.a.segments[0].duration);
  c.start_b = c.start_a + c.a.segments[0].duration - random.uniform(0, s.duration);
  const mpq_class share = (instant - mpq_class(c.start_b)) / mpq_class(s.duration);
  if (share < 0 || share > 1) return at_any_time(random);
  // Above or below, at half the radius at most.
  const Vec3 inner = support::inner(random, c.zone);
  const bool above = random.below(2);
  for (int axis = 0; axis < 3; ++axis) {
    mpq_class wanted = mpq_class(c.a.segments[1].point[0][axis]) - mpq_class(inner[axis]);
    if (axis == 2) {
      const mpq_class reach(c.zone.reach.z());
      wanted = mpq_class(c.a.segments[1].point[0][2]) + (above ? reach : mpq_class(-reach));
    }
    // Onto the grid of 2^-40, towards the first flight.
    const mpq_class shift = (wanted - at(s, axis, share)) * (mpz_class(1) << 40);
    mpz_class whole;
    if (axis == 2 && !above) {
      mpz_cdiv_q(whole.get_mpz_t(), shift.get_num_mpz_t(), shift.get_den_mpz_t());
    } else {
      mpz_fdiv_q(whole.get_mpz_t(), shift.get_num_mpz_t(), shift.get_den_mpz_t());
    }
    const double by = std::ldexp(whole.get_d(), -40);
    for (Vec3& p : s.point) p[axis] += by;
  }
  c.b.segments = {s};
  return c;
}

struct Counts {
  std::size_t cases = 0;
  std::size_t apart = 0;
};

// `steps` of depth for each case.
template <class Make>
Counts judge(std::size_t cases, unsigned seed, const Make& make) {
  constexpr std::size_t kBlock = 1000;
  std::vector<Counts> blocks((cases + kBlock - 1) / kBlock);
  geom::parallel_for(blocks.size(), {2, {}}, [&](std::size_t i) {
    Random random(1000003 * seed + i);
    for (std::size_t k = i * kBlock; k < std::min(cases, (i + 1) * kBlock); ++k) {
      ++blocks[i].cases;
      blocks[i].apart += apart(make(random));
    }
  });
  Counts all;
  for (const Counts& c : blocks) {
    all.cases += c.cases;
    all.apart += c.apart;
  }
  return all;
}

constexpr std::array kNames{"over or under", "past",         "at a joint",
                            "at arrival",    "at departure", "at rest"};

bool all_kinds(std::size_t each) {
  bool right = true;
  for (int kind = 0; kind < support::kMeetings; ++kind) {
    const auto how = static_cast<support::Meeting>(kind);
    const Counts touching = judge(each, 2 * static_cast<unsigned>(kind) + 1, [&](Random& random) {
      const int depth = random.below(4);
      const double steps = depth == 0   ? 0
                           : depth == 1 ? random.stepped(0, 0x1p-20, 0x1p-31)
                                        : random.stepped(0, 0.0625, 0x1p-31);
      return support::meeting(random, how, steps);
    });
    const Counts beyond = judge(each / 4, 2 * static_cast<unsigned>(kind) + 2, [&](Random& random) {
      return support::meeting(random, how, random.below(2) ? -1e-6 : -0x1p-19);
    });
    fmt::print("{:14} touching: {:7} of {:7} apart   1e-6 m beyond: {:7} of {:7} apart\n",
               kNames[static_cast<std::size_t>(kind)], touching.apart, touching.cases, beyond.apart,
               beyond.cases);
    right = right && touching.apart == 0 && beyond.apart == beyond.cases;
  }
  return right;
}

std::string record_of(const char* id, const traj::Trajectory& trajectory, double start) {
  traj::TrajectoryRecord record;
  record.id = id;
  record.status = traj::TrajectoryStatus::solved;
  record.trajectory = trajectory;
  record.time.start = start;
  const std::string line = traj::to_json_line(record);
  return line.substr(0, line.size() - 1);
}

// A case with what was found, a line.
std::string line_of(const PairCase& c, bool fast, const traj::ExactPair& exact) {
  const traj::TogetherTask task{{"a", "b"}, {{c.zone, {}}, c.parked, true}, {}, {}};
  const auto object = [](const std::string& text) { return text.substr(0, text.size() - 1); };
  geom::JsonLine line;
  line.add_json("a", record_of("a", c.a, c.start_a)).add_json("b", record_of("b", c.b, c.start_b));
  line.add("fast", fast).add("exact", exact.apart);
  line.add_json("claim", object(traj::certificate_line(task, {})));
  line.add_json("proof", object(traj::certificate_line({{0, 1}, exact}, task)));
  return line.line();
}

// From a metre inside to a metre beyond, and much within 1e-9 m.
PairCase any_case(Random& random) {
  if (random.below(7) == 0) return at_any_time(random);
  const auto how = static_cast<support::Meeting>(random.below(support::kMeetings));
  const int kind = random.below(4);
  if (kind == 0) return support::meeting(random, how, 0);
  if (kind == 1) return support::meeting(random, how, -0x1p-31);
  const double most = kind == 2 ? 0x1p-28 : 0.0625;
  return support::meeting(random, how, random.stepped(-most, most, 0x1p-31));
}

bool exactly(std::size_t cases, const std::string& file) {
  constexpr std::size_t kBlock = 100;
  struct Block {
    std::size_t fast = 0;
    std::size_t exact = 0;
    std::size_t wrong = 0;  // accepted by the fast check alone
    std::string lines;
  };
  std::vector<Block> blocks((cases + kBlock - 1) / kBlock);
  geom::parallel_for(blocks.size(), {2, {}}, [&](std::size_t i) {
    Random random(777 + i);
    Block& block = blocks[i];
    for (std::size_t k = i * kBlock; k < std::min(cases, (i + 1) * kBlock); ++k) {
      const PairCase c = any_case(random);
      const bool fast = apart(c);
      const auto exact =
          traj::check_pair_exactly(c.first(), c.second(), std::array{c.zone}, c.parked);
      block.fast += fast;
      block.exact += exact.apart;
      block.wrong += fast && !exact.apart;
      if (!file.empty()) block.lines += line_of(c, fast, exact);
    }
  });
  Block all;
  std::ofstream out;
  if (!file.empty()) out.open(file);
  for (const Block& block : blocks) {
    all.fast += block.fast;
    all.exact += block.exact;
    all.wrong += block.wrong;
    out << block.lines;
  }
  fmt::print(
      "near a touch: of {} the fast check accepts {}, the exact one {}; the fast one alone {}\n",
      cases, all.fast, all.exact, all.wrong);
  return all.wrong == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto cases = static_cast<std::size_t>(argc > 1 ? std::stod(argv[1]) : 1e5);
  bool right = all_kinds(cases / 7);
  const Counts any = judge(cases / 7, 99, at_any_time);
  fmt::print("{:14} touching: {:7} of {:7} apart\n", "at any time", any.apart, any.cases);
  right = right && any.apart == 0;
  const auto exact = static_cast<std::size_t>(argc > 2 ? std::stod(argv[2]) : 1000);
  right = exactly(exact, argc > 3 ? argv[3] : "") && right;
  return right ? 0 : 1;
}
