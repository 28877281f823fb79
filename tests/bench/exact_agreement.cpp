// exact_agreement [CASES]: the fast check against the exact one, on curves whose distance to a box
// is known by construction. Exit 1 when either accepts a touch, or refuses what it should accept.

#include <fmt/format.h>

#include <chrono>
#include <string>

#include "support/touch_case.h"
#include "traj/check.h"
#include "traj/exact_check.h"

namespace {

struct Counts {
  int cases = 0;
  int fast = 0;   // accepted
  int exact = 0;  // accepted
  double fast_s = 0;
  double exact_s = 0;
};

template <class F>
bool timed(double& seconds, const F& accepts) {
  const auto start = std::chrono::steady_clock::now();
  const bool ok = accepts();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return ok;
}

void judge(const support::TouchCase& c, Counts& counts) {
  const geom::CollisionScene scene = c.scene();
  ++counts.cases;
  counts.fast +=
      timed(counts.fast_s, [&] { return check(scene, c.trajectory, traj::Limits{}).ok; });
  counts.exact += timed(counts.exact_s, [&] {
    return check_exactly({scene.map(), scene.vehicle(), scene.margin(), {}}, c.trajectory).ok;
  });
}

void print(const std::string& what, const Counts& c) {
  fmt::print(
      "{:37}{:8} cases  accepted: fast {:6}  exact {:6}  ms a case: fast {:.2f}  exact {:.2f}\n",
      what, c.cases, c.fast, c.exact, 1e3 * c.fast_s / c.cases, 1e3 * c.exact_s / c.cases);
}

}  // namespace

int main(int argc, char** argv) {
  const int cases = argc > 1 ? std::stoi(argv[1]) : 10000;
  support::Random random(71);
  Counts touching;
  Counts grazing;
  Counts edges;
  Counts clear;
  Counts nearly;
  for (int i = 0; i < cases; ++i) {
    // 0, then 2^-30 m (about 1e-9) to 1 m inside.
    const double depth = i % 32 ? std::ldexp(1, -(i % 32 - 1)) : 0;
    judge(support::touching(random, depth), touching);
    judge(support::under(random, -depth), grazing);
    judge(support::past_edge(random, -depth), edges);
    const auto beside = i % 2 ? support::under : support::past_edge;
    judge(beside(random, std::ldexp(1, -(i % 20))), clear);       // 1.9e-6 m to 1 m clear
    judge(beside(random, std::ldexp(1, -(32 + i % 9))), nearly);  // less than 2.4e-10 m
  }
  print("through or into a face, edge, corner", touching);
  print("grazing from below, 0 to 1 m", grazing);
  print("along a line into an edge, 0 to 1 m", edges);
  print("clear by 1.9e-6 to 1 m", clear);
  print("clear by 1e-12 to 2.3e-10 m", nearly);
  bool sound = true;
  for (const Counts& c : {touching, grazing, edges}) sound = sound && !c.fast && !c.exact;
  const bool tight = clear.fast == cases && clear.exact == cases && nearly.exact == cases;
  return sound && tight && nearly.fast == 0 ? 0 : 1;
}
