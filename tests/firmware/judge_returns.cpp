// judge_returns TABLE…: of each return of the tables how far its track left what is claimed of it,
// and of each firmware and action how many stayed inside.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "flown_return.h"

namespace {

struct Tally {
  std::size_t flown = 0;
  std::size_t inside = 0;
  double furthest = 0;  // m
};

void print(const firmware::FlownReturn& flown, const firmware::ReturnClaim& claim,
           const firmware::Exit& exit, const firmware::Sample& where) {
  fmt::print(
      "{} {} {}: {:.2f} m outside ({}) at {:.1f} s, {:.1f} {:.1f} {:.1f}; ordered at {:.1f} s, "
      "{:.1f} {:.1f} {:.1f}\n",
      flown.flight.autopilot, flown.flight.name, name(flown.action), exit.outside, name(exit.phase),
      where.time, where.place.x(), where.place.y(), where.place.z(), flown.ordered,
      claim.ordered_at.x(), claim.ordered_at.y(), claim.ordered_at.z());
}

void judge(const firmware::FlownReturn& flown, Tally& tally) {
  const firmware::ReturnClaim claim = firmware::claim_of(flown);
  const auto ways = firmware::ways_of(flown, claim, firmware::stages_there(claim));
  firmware::Exit worst;
  firmware::Sample where;
  for (const firmware::Sample& sample : firmware::samples_after(flown, claim)) {
    const firmware::Exit exit = firmware::exit_of(claim, ways, sample.place);
    if (exit.outside <= worst.outside) continue;
    worst = exit;
    where = sample;
  }
  ++tally.flown;
  tally.inside += worst.outside == 0;
  tally.furthest = std::max(tally.furthest, worst.outside);
  if (worst.outside > 0) print(flown, claim, worst, where);
}

}  // namespace

int main(int argc, char** argv) {
  std::map<std::string, Tally> tallies;
  for (int i = 1; i < argc; ++i) {
    for (const firmware::FlownReturn& flown : firmware::read_returns(argv[i])) {
      judge(flown, tallies[fmt::format("{} {}", flown.flight.autopilot, name(flown.action))]);
    }
  }
  fmt::print("{:<24} {:>6} {:>7} {:>13}\n", "firmware, action", "flown", "inside", "furthest, m");
  bool all = true;
  for (const auto& [name, tally] : tallies) {
    all = all && tally.inside == tally.flown;
    fmt::print("{:<24} {:>6} {:>7} {:>13.2f}\n", name, tally.flown, tally.inside, tally.furthest);
  }
  return all ? 0 : 1;
}
