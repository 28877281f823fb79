// exact_agreement [CASES] [EXACT]: the fast check, and on EXACT of the cases the exact one, on
// curves among up to 20 boxes whose distance to the nearest is known by construction. Exit 1 when
// either accepts a touch, or refuses what it should accept.

#include <fmt/format.h>

#include <string>

#include "support/touch_case.h"
#include "traj/proof/check.h"
#include "traj/proof/exact/exact_check.h"

namespace {

struct Counts {
  int cases = 0;   // of the fast check
  int judged = 0;  // of the exact one
  int fast = 0;    // accepted
  int exact = 0;   // accepted
};

void judge(support::TouchCase c, bool exactly, support::Random& random, Counts& counts) {
  support::add_others(random, c);
  const geom::CollisionScene scene = c.scene();
  ++counts.cases;
  counts.fast += check(scene, c.trajectory, traj::Limits{}).ok;
  if (!exactly) return;
  ++counts.judged;
  counts.exact +=
      check_exactly({scene.map(), scene.vehicle(), scene.margin(), {}}, c.trajectory).ok;
}

void print(const std::string& what, const Counts& c) {
  fmt::print("{:37}fast: {:7} of {:7} accepted  exact: {:6} of {:6}\n", what, c.fast, c.cases,
             c.exact, c.judged);
}

}  // namespace

int main(int argc, char** argv) {
  const int cases = (argc > 1 ? std::stoi(argv[1]) : 50000) / 5;  // of each kind
  const int exact = argc > 2 ? std::stoi(argv[2]) / 5 : cases;
  const int every = std::max(1, cases / std::max(1, exact));
  support::Random random(71);
  Counts touching;
  Counts grazing;
  Counts edges;
  Counts clear;
  Counts nearly;
  for (int i = 0; i < cases; ++i) {
    // Not in step with what the cases go through in turn.
    const bool exactly = i % every == i / every % every;
    const auto judged = [&](const support::TouchCase& c, Counts& counts) {
      judge(c, exactly, random, counts);
    };
    // 0, then 2^-30 m (about 1e-9) to 1 m inside.
    const double depth = i % 32 ? std::ldexp(1, -(i % 32 - 1)) : 0;
    judged(support::touching(random, depth), touching);
    judged(support::under(random, -depth), grazing);
    judged(support::past_edge(random, -depth), edges);
    const auto beside = i % 2 ? support::under : support::past_edge;
    judged(beside(random, std::ldexp(1, -(i % 20))), clear);       // 1.9e-6 m to 1 m clear
    judged(beside(random, std::ldexp(1, -(32 + i % 9))), nearly);  // less than 2.4e-10 m
  }
  print("through or into a face, edge, corner", touching);
  print("grazing from below, 0 to 1 m", grazing);
  print("along a line into an edge, 0 to 1 m", edges);
  print("clear by 1.9e-6 to 1 m", clear);
  print("clear by 1e-12 to 2.3e-10 m", nearly);
  bool sound = true;
  for (const Counts& c : {touching, grazing, edges}) sound = sound && !c.fast && !c.exact;
  const bool tight =
      clear.fast == clear.cases && clear.exact == clear.judged && nearly.exact == nearly.judged;
  return sound && tight && nearly.fast == 0 ? 0 : 1;
}
