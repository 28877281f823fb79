#include "traj/schedule/timed_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/record/named_map.h"
#include "geom/record/scenes.h"
#include "geom/record/start_on_map.h"
#include "traj/fleet/forbidden_by_map.h"
#include "traj/proof/check.h"

namespace traj {
namespace {

// By what a scene is made for: the limits of its vehicle hold for all that is checked in it.
bool comes_before(const geom::Provenance& a, const geom::Provenance& b) {
  const auto key = [](const geom::Provenance& p) {
    const geom::Vehicle vehicle = p.vehicle.value_or(geom::Vehicle{"", {-1, -1, -1}});
    return std::tuple(vehicle.half[0], vehicle.half[1], vehicle.half[2], vehicle.name,
                      vehicle.limits.values, p.margin.value_or(0));
  };
  return key(a) < key(b);
}

[[noreturn]] void refuse(const std::string& id, const geom::BoxMap& map, const CheckResult& result,
                         double start) {
  const std::string what =
      fmt::format("{} ({:.6g} s after its begin)", name(result.reason), result.time);
  const bool by_time = result.box && !map.time(*result.box).always();
  if (!by_time) {
    throw geom::InputError(
        id, {.expected = "a flight that is proved on the map of --map but for its boxes with times",
             .found = what,
             .advice = "skyway-check says more"});
  }
  throw std::runtime_error(
      fmt::format("the departure {} of {} could not be proved on the map: {}; nothing was written",
                  start, id, what));
}

}  // namespace

template <class F>
void TimedMap::each(const FleetStream& stream, std::vector<std::size_t> ways, const F& f) const {
  const auto made_for = [&](std::size_t way) -> const geom::Provenance& {
    return stream.record(way).provenance;
  };
  std::stable_sort(ways.begin(), ways.end(), [&](std::size_t a, std::size_t b) {
    return comes_before(made_for(a), made_for(b));
  });
  geom::Scenes scenes(map_, asked_, geom::Differences::refused, budget_);
  for (auto first = ways.begin(); first != ways.end();) {
    const auto last = std::find_if(first, ways.end(), [&](std::size_t way) {
      return comes_before(made_for(*first), made_for(way));
    });
    for (auto way = first; way != last; ++way) {
      scenes.scene_for(made_for(*way), stream.record(*way).id, 0);
    }
    const geom::CollisionScene& scene = scenes.scene_for(made_for(*first), name_, 0);
    const std::span<const std::size_t> group(first, last);
    geom::parallel_for(group.size(), run_, [&](std::size_t k) { f(scene, group[k]); });
    first = last;
  }
}

void TimedMap::close(const FleetStream& stream, Parked parked, const LookAt& look_at,
                     std::vector<FleetFlight>& flights) const {
  std::vector<std::size_t> ways;
  geom::NamedMap named(map_);
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const TrajectoryRecord& record = stream.record(i);
    named.require(record.provenance, record.id, 0);
    look_at(record.trajectory, record.id);
    geom::start_on(map_, {.epoch = record.time.epoch, .start = 0.0}, record.id, 0);
    if (!flights[i].settled) ways.push_back(i);
  }
  each(stream, std::move(ways), [&](const geom::CollisionScene& scene, std::size_t way) {
    flights[way].forbidden = forbidden_by_map(scene, *flights[way].trajectory, parked);
  });
}

void TimedMap::prove(const FleetStream& stream, std::span<const FleetFlight> flights,
                     const Departures& departures, Parked parked) const {
  std::vector<std::size_t> ways;
  std::vector<double> start(flights.size());
  for (const Departure& departure : departures.of) {
    if (!departure.start || flights[departure.flight].settled) continue;
    ways.push_back(departure.flight);
    start[departure.flight] = *departure.start;
  }
  each(stream, std::move(ways), [&](const geom::CollisionScene& scene, std::size_t way) {
    const TrajectoryRecord& record = stream.record(way);
    CheckOptions options;
    options.limits = geom::limits_that_hold({{}, record.limits, scene.vehicle().limits});
    options.clearance = Clearance::left_out;
    options.start = start[way];
    options.stands = parked == Parked::pad;
    const CheckResult result = check(scene, record.trajectory, options);
    if (!result.ok) refuse(record.id, map_, result, start[way]);
  });
}

}  // namespace traj
