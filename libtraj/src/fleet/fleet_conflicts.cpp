#include "traj/fleet/fleet_conflicts.h"

#include <algorithm>
#include <cmath>

#include "fleet/forbidden_between.h"
#include "geom/base/parallel.h"
#include "geom/base/rounding.h"
#include "together/box_tree.h"

namespace traj {
namespace {

constexpr double kStep = 100;       // metres: how long a box is at most
constexpr std::size_t kBlock = 64;  // pairs that a thread takes at once
constexpr double kWhole = 1 << 20;  // boxes of a piece at most

// Boxes around the pieces of a course, each with all times at which the flight may be there.
class Boxes {
 public:
  Boxes(const FleetFlight& flight, std::uint32_t index, const Spacing& spacing)
      : flight_(flight), index_(index), reach_(reach_of(spacing, flight.room)) {}

  std::vector<TimedBox> all(const Course& course) {
    for (const StraightPiece& piece : course.pieces) {
      const double parts =
          std::clamp(std::ceil(piece.way.cwiseAbs().maxCoeff() / kStep), 1.0, kWhole);
      for (double i = 0; i < parts; ++i) add(piece, i / parts, (i + 1) / parts, course.blur);
    }
    return std::move(out_);
  }

 private:
  void add(const StraightPiece& piece, double from, double until, double blur) {
    const Vec3 a = piece.from + from * piece.way;
    const Vec3 b = piece.from + until * piece.way;
    const Vec3 off(piece.off.across, piece.off.across, piece.off.up);
    TimedBox box;
    box.flight = index_;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double size = std::abs(a[axis]) + std::abs(b[axis]) + off[axis] + reach_[axis];
      const double pad = off[axis] + reach_[axis] + 1e-12 * size + 1e-9;
      box.low[i] = std::min(a[axis], b[axis]) - pad;
      box.high[i] = std::max(a[axis], b[axis]) + pad;
    }
    const bool for_ever = !std::isfinite(piece.begin) || !std::isfinite(piece.end);
    const double length = for_ever ? 0 : piece.end - piece.begin;
    const double begin = for_ever ? piece.begin : piece.begin + from * length;
    const double end = for_ever ? piece.end : piece.begin + until * length;
    box.low[3] = begin + flight_.earliest - pad_of(begin, flight_.earliest) - blur;
    box.high[3] = end + flight_.latest + pad_of(end, flight_.latest) + blur;
    add_or_join(box);
  }

  // Pieces that follow each other share a box as long as it stays small.
  void add_or_join(const TimedBox& box) {
    if (!out_.empty()) {
      TimedBox both = out_.back();
      bool small = std::isfinite(both.low[3]) && std::isfinite(box.high[3]);
      for (std::size_t i = 0; i < 4; ++i) {
        both.low[i] = std::min(both.low[i], box.low[i]);
        both.high[i] = std::max(both.high[i], box.high[i]);
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const double reach = 2 * reach_[static_cast<int>(i)];
        small = small && both.high[i] - both.low[i] <= kStep + reach;
      }
      if (small) {
        out_.back() = both;
        return;
      }
    }
    out_.push_back(box);
  }

  static double pad_of(double time, double departure) {
    return 1e-6 + (std::isfinite(time) ? 1e-12 * (std::abs(time) + std::abs(departure)) : 0);
  }

  const FleetFlight& flight_;
  std::uint32_t index_;
  Vec3 reach_;
  std::vector<TimedBox> out_;
};

// The least zone that any pair of the fleet has, for how straight a piece must be.
Bend bend_of(std::span<const FleetFlight> flights, const Spacing& spacing) {
  Vec3 least = flights.front().room;
  for (const FleetFlight& flight : flights) least = least.cwiseMin(flight.room);
  return bend_for(zones_between(spacing, least, least));
}

class Fleet {
 public:
  Fleet(std::span<const FleetFlight> flights, const Spacing& spacing, Parked parked,
        const geom::Execution& run)
      : flights_(flights), spacing_(spacing), courses_(flights.size()) {
    const Bend bend = bend_of(flights, spacing);
    geom::parallel_for(flights.size(), {run.threads, {}}, [&](std::size_t i) {
      courses_[i] = course_of(*flights[i].trajectory, parked, bend);
    });
  }

  std::vector<FlightPair> near(const geom::Execution& run) const {
    std::vector<std::vector<TimedBox>> of(flights_.size());
    geom::parallel_for(flights_.size(), {run.threads, {}}, [&](std::size_t i) {
      of[i] = Boxes(flights_[i], static_cast<std::uint32_t>(i), spacing_).all(courses_[i]);
    });
    std::vector<TimedBox> boxes;
    for (auto& part : of) {
      boxes.insert(boxes.end(), part.begin(), part.end());
      part = {};
    }
    std::vector<FlightPair> pairs = meeting_flights(std::move(boxes), {run.threads, {}});
    std::erase_if(pairs, [&](const FlightPair& pair) {
      const FleetFlight& a = flights_[pair.first];
      const FleetFlight& b = flights_[pair.second];
      return a.number == b.number || (a.settled && b.settled);
    });
    return pairs;
  }

  std::vector<DepartureSpan> forbidden(const FlightPair& pair) const {
    const FleetFlight& a = flights_[pair.first];
    const FleetFlight& b = flights_[pair.second];
    const DepartureSpan window{geom::next_down(b.earliest - a.latest),
                               geom::next_up(b.latest - a.earliest)};
    return forbidden_between(courses_[pair.first], courses_[pair.second],
                             zones_between(spacing_, a.room, b.room), window);
  }

 private:
  std::span<const FleetFlight> flights_;
  const Spacing& spacing_;
  std::vector<Course> courses_;
};

void append(const FleetConflicts& part, FleetConflicts& out) {
  const std::uint64_t begin = out.forbidden.size();
  out.looked_at += part.looked_at;
  out.pairs.insert(out.pairs.end(), part.pairs.begin(), part.pairs.end());
  for (const std::uint64_t end : part.ends) out.ends.push_back(begin + end);
  out.forbidden.insert(out.forbidden.end(), part.forbidden.begin(), part.forbidden.end());
}

}  // namespace

FleetConflicts fleet_conflicts(std::span<const FleetFlight> flights, const Spacing& spacing,
                               Parked parked, const geom::Execution& run) {
  if (flights.empty()) return {};
  const Fleet fleet(flights, spacing, parked, run);
  const std::vector<FlightPair> near = fleet.near(run);
  std::vector<FleetConflicts> blocks((near.size() + kBlock - 1) / kBlock);
  geom::parallel_for(blocks.size(), run, [&](std::size_t i) {
    const std::size_t end = std::min(near.size(), (i + 1) * kBlock);
    for (std::size_t k = i * kBlock; k < end; ++k) {
      const FlightPair& pair = near[k];
      const auto spans = fleet.forbidden(pair);
      ++blocks[i].looked_at;
      if (spans.empty()) continue;
      blocks[i].pairs.push_back(pair);
      blocks[i].forbidden.insert(blocks[i].forbidden.end(), spans.begin(), spans.end());
      blocks[i].ends.push_back(blocks[i].forbidden.size());
    }
  });
  FleetConflicts out;
  for (const FleetConflicts& block : blocks) append(block, out);
  return out;
}

}  // namespace traj
