#pragma once

// Obstacles that move, as JSON Lines records, and what the check against them found.
//
// Example:
//   const std::string line =
//       R"({"type":"moving","id":"crane","epoch":"2026-05-04T06:30:00Z","from":0,"until":60,)"
//       R"("min":[0,0,0],"max":[2,2,9],"velocity":[0.1,0,0],"growth":[0,0,0]})";
//   const traj::MovingRecord crane = traj::parse_moving_record(line, "moving.jsonl", 1);
//   assert(crane.box.velocity.x() == 0.1);

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/frame.h"
#include "geom/text/json_fields.h"
#include "traj/together/exact/exact_moving.h"
#include "traj/together/moving_box.h"

namespace traj {

// {"type":"moving","id":…,"epoch":…,"from":…,"until":…,"min":[x,y,z],"max":[x,y,z],
//  "velocity":[x,y,z],"growth":[x,y,z]}, and the frame and map that it is for, where it says so.
struct MovingRecord {
  std::string id;
  std::optional<std::string> epoch;
  std::optional<geom::Axes> frame;
  std::optional<std::string> map;  // its hash
  MovingBox box;
};

// Throws InputError(source, line, …) for a key that is missing or not known, and for a box that
// cannot be judged (moving_box_fault).
MovingRecord parse_moving_record(std::string_view json, std::string_view source, std::size_t line);

// A flight that is not clear of an obstacle.
struct MovingConflict {
  std::string flight;
  std::string obstacle;
  MovingResult result;  // clear where the exact check alone refuses
};

// A flight that is clear of an obstacle, and why.
struct ProvedMoving {
  std::string flight;
  std::string obstacle;
  ExactMoving proof;  // clear
};

// The result of the check against all obstacles.
struct MovingSummary {
  std::size_t flights = 0;
  std::size_t left_out = 0;  // without a trajectory; then the whole is refused
  std::size_t obstacles = 0;
  std::size_t pieces = 0;
  std::size_t refused = 0;
  Parked parked = Parked::pad;
  std::optional<std::string> epoch;

  bool ok() const { return refused == 0 && left_out == 0; }
};

// What a certificate claims: each of the flights is clear of each of the obstacles.
struct MovingClaim {
  std::vector<std::string> flights;  // ids, in order
  std::vector<Vec3> rooms;           // of the flights
  std::vector<std::string> obstacles;
  Parked parked = Parked::pad;
  std::optional<std::string> map;  // its hash
  std::optional<std::string> epoch;
};

// Each ends with a newline.
std::string to_json_line(const MovingConflict& conflict, const std::optional<std::string>& epoch);
std::string to_json_line(const MovingSummary& summary);

// Why a flight is clear of an obstacle, and what is claimed of all; each ends with a newline.
// docs/certificates.md has the conditions for them.
std::string certificate_line(const ProvedMoving& proved);
std::string certificate_line(const MovingClaim& claim);

// The refusal as a word, and in a sentence.
std::string_view reason_of(const MovingConflict& conflict);
std::string in_words(const MovingConflict& conflict);

}  // namespace traj
