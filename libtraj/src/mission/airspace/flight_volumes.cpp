#include "traj/mission/airspace/flight_volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "geom/base/error.h"
#include "geom/shape/convex_outline.h"
#include "geom/text/instant.h"
#include "traj/mission/airspace/volume_around.h"
#include "window.h"

namespace traj {
namespace {

using geom::Vec2;

constexpr double kLeastArea = 1e-300;  // so that no volume costs nothing

// What a flight is in for a while, in metres.
struct Prism {
  std::vector<Vec2> outline;  // convex, counterclockwise
  double low = kInfinity;
  double high = -kInfinity;

  void add(const Prism& other) {
    outline.insert(outline.end(), other.outline.begin(), other.outline.end());
    outline = geom::convex_outline(std::move(outline));
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }

  double volume() const {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2& a = outline[i];
      const Vec2& b = outline[(i + 1) % outline.size()];
      twice +=
          (a - outline[0]).x() * (b - outline[0]).y() - (a - outline[0]).y() * (b - outline[0]).x();
    }
    return std::max(kLeastArea, 0.5 * twice * (high - low));
  }
};

// Instants in whole milliseconds, in order, the flight between the first and the last.
std::vector<std::string> instants_of(const FlightOnEarth& flight, double end,
                                     std::string_view source) {
  const double begin = flight.flight.start;
  const auto require = [&](const std::optional<std::string>& instant) {
    if (instant) return *instant;
    throw geom::InputError(
        source, {.expected = "a flight within the years 0 to 9999",
                 .found = fmt::format("one from {} s to {} s after {}", begin, end, flight.epoch)});
  };
  std::vector<std::string> out{require(geom::instant_not_after(flight.epoch, begin))};
  const std::string last = require(geom::instant_not_before(flight.epoch, end));
  for (std::size_t i = 1; i < kMostVolumes; ++i) {
    const double at = begin + (end - begin) * (static_cast<double>(i) / kMostVolumes);
    const std::string instant = require(geom::instant_not_after(flight.epoch, at));
    const bool between = geom::seconds_between(out.back(), instant).least > 0 &&
                         geom::seconds_between(instant, last).least > 0;
    if (between) out.push_back(instant);
  }
  out.push_back(last);
  return out;
}

class Volumes {
 public:
  Volumes(const FlightOnEarth& flight, std::string_view source)
      : flight_(flight), source_(source), line_(flight.flight) {
    instants_ = instants_of(flight, seconds_not_below(line_.joint.back()), source);
    for (const std::string& instant : instants_) {
      times_.push_back(geom::seconds_between(flight.epoch, instant));
    }
    for (std::size_t i = 0; i + 1 < instants_.size(); ++i) parts_.push_back(part(i));
  }

  std::vector<geom::Volume4d> cut(std::size_t most) const {
    std::vector<geom::Volume4d> out;
    const std::vector<std::size_t> ends = cheapest(most);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) out.push_back(volume(ends[i], ends[i + 1]));
    return out;
  }

 private:
  // The hull of the control points from one instant to the next.
  Prism part(std::size_t i) const {
    const Window window = window_of(line_, times_[i].least, times_[i + 1].most);
    const Vec3& room = flight_.flight.room;
    Prism out;
    for (const Window::Stretch& stretch : window.stretches) {
      for (const Vec3& q : stretch.curve.q) {
        const Vec3 p = window.from + q;
        for (const double x : {-room.x(), room.x()}) {
          for (const double y : {-room.y(), room.y()})
            out.outline.push_back({p.x() + x, p.y() + y});
        }
        out.low = std::min(out.low, p.z() - room.z());
        out.high = std::max(out.high, p.z() + room.z());
      }
    }
    out.outline = geom::convex_outline(std::move(out.outline));
    return out;
  }

  double seconds(std::size_t from, std::size_t to) const {
    return times_[to].most - times_[from].least;
  }

  // Where to cut, the first instant and the last included: shortest ways over the instants with one
  // edge more each round.
  std::vector<std::size_t> cheapest(std::size_t most) const {
    const std::size_t n = parts_.size();
    std::vector<std::vector<double>> cost(n, std::vector<double>(n + 1, kInfinity));
    for (std::size_t i = 0; i < n; ++i) {
      Prism prism = parts_[i];
      for (std::size_t j = i + 1; j <= n; ++j) {
        cost[i][j] = prism.volume() * seconds(i, j);
        if (j < n) prism.add(parts_[j]);
      }
    }
    std::vector<std::vector<std::size_t>> before;  // of a round and an instant
    std::vector<double> least(n + 1, kInfinity);
    least[0] = 0;
    std::size_t rounds = 0;
    double best = kInfinity;
    for (std::size_t round = 1; round <= std::min(most, n); ++round) {
      std::vector<double> next(n + 1, kInfinity);
      before.emplace_back(n + 1, 0);
      for (std::size_t j = 1; j <= n; ++j) {
        for (std::size_t i = 0; i < j; ++i) {
          if (!(least[i] + cost[i][j] < next[j])) continue;
          next[j] = least[i] + cost[i][j];
          before.back()[j] = i;
        }
      }
      least = std::move(next);
      if (!(least[n] < best)) continue;
      best = least[n];
      rounds = round;
    }
    std::vector<std::size_t> ends{n};
    for (std::size_t round = rounds; round > 0; --round) {
      ends.push_back(before[round - 1][ends.back()]);
    }
    std::reverse(ends.begin(), ends.end());
    return ends;
  }

  geom::Volume4d volume(std::size_t from, std::size_t to) const {
    Prism prism = parts_[from];
    for (std::size_t i = from + 1; i < to; ++i) prism.add(parts_[i]);
    geom::Volume4d out =
        volume_around({prism.outline, prism.low, prism.high}, flight_.origin, source_);
    out.start = instants_[from];
    out.end = instants_[to];
    return out;
  }

  const FlightOnEarth& flight_;
  std::string_view source_;
  Timeline line_;
  std::vector<std::string> instants_;
  std::vector<geom::SecondsBetween> times_;
  std::vector<Prism> parts_;
};

}  // namespace

std::vector<geom::Volume4d> flight_volumes(const FlightOnEarth& flight, std::size_t most,
                                           std::string_view source) {
  assert(most >= 1 && most <= kMostVolumes);
  return Volumes(flight, source).cut(most);
}

}  // namespace traj
