#pragma once

// The exact check of a trajectory or path, with its reasons.
//
// Example:
//   const traj::ExactTask task{.map = map, .vehicle = vehicle, .margin = 0.2, .limits = limits};
//   const traj::ExactResult result = traj::check_exactly(task, trajectory);
//   assert(result.ok && result.segments.size() == trajectory.segments.size());
//
// It is the proof over again in exact numbers, with reasons that anyone can follow.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/map/box_map.h"
#include "geom/vehicle/vehicle.h"
#include "traj/curve/trajectory.h"
#include "traj/proof/reason.h"

namespace traj {

// What is judged, taken as exact numbers: obstacles are the closed boxes
// [min - (half + margin), max + (half + margin)] of every box of the map, and the reference point
// stays in the closed bounds shrunk as much. Those of the fast check reach at least 5e-10 m
// further.
struct ExactTask {
  const geom::BoxMap& map;
  geom::Vehicle vehicle;
  double margin = 0;  // metres, >= 0
  Limits limits;
  // As in CheckOptions: when the trajectory begins, and whether it stands before and after.
  std::optional<double> start = {};
  bool stands = false;
};

// Why a piece misses an obstacle. By time (`axis` is kTimeAxis): the obstacle is there only after
// the piece has ended (`towards`), or only before it begins. By place: a plane through no control
// point of a piece, with all of them on one side and the obstacle on the other. Its normal is the
// unit vector of `axis` times (cross product) the way from the piece's first control point to its
// last; the obstacle is on the side it points to, or on the other.
inline constexpr int kTimeAxis = 3;
struct PieceAndPlane {
  std::size_t piece = 0;  // of the cover it belongs to
  std::size_t box = 0;    // index into BoxMap::boxes()
  int axis = 0;
  bool towards = true;
};

// A curve cut by halving: the pieces in order, each by how often it was halved. Their lengths, two
// to the power of minus that, sum to one.
using Cover = std::vector<std::uint8_t>;

// Each obstacle that the bounding box of a piece's control points meets has one of these.
struct ClearCover {
  Cover pieces;
  std::vector<PieceAndPlane> planes;
};

// Covers of one segment or leg. On each piece the Bernstein coefficients of the limit squared less
// the norm squared are >= 0 (tilt: those of the cone; thrust: of a + g; body_rate: of
// docs/certificates.md); empty where there is no limit.
struct SegmentProof {
  ClearCover clear;
  Cover bounds;  // the control points are inside
  PerLimit<Cover> limits;
  std::optional<ClearCover> gap;  // the straight step to the next segment, where there is one
};

struct ExactResult {
  bool ok = false;
  Reason reason = Reason::none;  // as CheckResult's, or vehicle: half sizes or a margin not within
                                 // 0 and geom::kLargestCoordinate
  bool undecided = false;        // the reason could not be ruled out in pieces of 2^-60
  double time = 0;               // of the first such place, as in CheckResult; rounded
  Vec3 place = Vec3::Zero();     // rounded
  std::optional<std::size_t> box;  // the obstacle

  // The largest step of a coordinate at any joint, of position and its first three derivatives: an
  // exact fraction, "0" where there is none. Trajectories only.
  std::array<std::string, 4> joints{"0", "0", "0", "0"};
  std::vector<SegmentProof> segments;  // as far as it came
};

// Decides in whole numbers by halving each segment. Shares no code with check() and agrees with it
// but on the side of caution: what check() accepts is accepted here. Joints may miss each other by
// as much as there and a thousandth part of it, as the fast check compares rounded numbers. Throws
// InputError for a start that is not within geom::kLargestTime.
ExactResult check_exactly(const ExactTask& task, const Trajectory& trajectory);

// The same for a path. `time` is the index of the leg and the part of it.
ExactResult check_exactly(const ExactTask& task, std::span<const Vec3> points);

}  // namespace traj
