// judge_flights TABLE…: of each flight of the tables how far its track left what is claimed of its
// mission, and of each firmware how many stayed inside, and how wide the claim is at corners.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "flown_track.h"

namespace {

struct Tally {
  std::size_t flown = 0;
  std::size_t inside = 0;
  double furthest = 0;
  std::vector<double> ratios;   // claim over track, at corners
  std::vector<double> heights;  // m of the claim over places above terrain
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void judge(const firmware::Flight& flight, Tally& tally) {
  const firmware::Replay replay = firmware::replay(flight);
  double furthest = 0;
  firmware::Sample where;
  for (const firmware::Sample& sample : replay.samples) {
    const double out = firmware::outside(flight, replay, sample.place);
    if (out > furthest) {
      furthest = out;
      where = sample;
    }
  }
  ++tally.flown;
  tally.inside += furthest == 0;
  tally.furthest = std::max(tally.furthest, furthest);
  for (const firmware::CornerWidth& width : firmware::corner_widths(flight, replay)) {
    if (width.track > 0.1) tally.ratios.push_back(width.claim / width.track);
  }
  if (replay.mission.terrain) {
    const std::size_t step = std::max<std::size_t>(1, replay.samples.size() / 20);
    for (std::size_t i = 0; i < replay.samples.size(); i += step) {
      tally.heights.push_back(firmware::claimed_height(flight, replay, replay.samples[i].place));
    }
  }
  if (furthest > 0) {
    fmt::print("{} {}: {:.2f} m outside at {:.1f} s, {:.1f} {:.1f} {:.1f}\n", flight.autopilot,
               flight.name, furthest, where.time, where.place.x(), where.place.y(),
               where.place.z());
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::map<std::string, Tally> by_autopilot;
  for (int i = 1; i < argc; ++i) {
    for (const firmware::Flight& flight : firmware::read_flights(argv[i])) {
      judge(flight, by_autopilot[flight.autopilot]);
    }
  }
  fmt::print("{:<16} {:>6} {:>7} {:>13} {:>24}\n", "firmware", "flown", "inside", "furthest, m",
             "corner claim/track: median, most");
  bool all = true;
  for (const auto& [name, tally] : by_autopilot) {
    all = all && tally.inside == tally.flown;
    fmt::print(
        "{:<16} {:>6} {:>7} {:>13.2f} {:>12.1f} {:>8.1f}\n", name, tally.flown, tally.inside,
        tally.furthest, median(tally.ratios),
        tally.ratios.empty() ? 0 : *std::max_element(tally.ratios.begin(), tally.ratios.end()));
  }
  for (const auto& [name, tally] : by_autopilot) {
    if (tally.heights.empty()) continue;
    fmt::print("{}, above terrain: the claim is {:.0f} m high in the middle, {:.0f} m at most\n",
               name, median(tally.heights),
               *std::max_element(tally.heights.begin(), tally.heights.end()));
  }
  return all ? 0 : 1;
}
