#pragma once

// Tracks that real autopilots flew, beside what Skyway says of their missions.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "traj/mission/judge/judge.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace firmware {

using geom::Vec3;

// A mission that was flown, and with what settings. Lengths in metres.
struct Flight {
  std::string name;
  std::string track;      // file: seconds, latitude, longitude, altitude
  std::string mission;    // file
  std::string autopilot;  // "px4:1.17"
  std::optional<double> acceptance;
  std::optional<double> return_height;
  double navigation_across = 0;
  double navigation_vertical = 0;
  std::optional<double> drag;  // over the mass, 1/s
  std::string ground;          // file of the ground (terrain.py); empty: flat
  double terrain_error = 0;
  std::string settings;  // the autopilot's parameters, NAME=VALUE with spaces between
};

// A table with a header: track,mission,autopilot,acceptance,return_height,navigation_across,
// navigation_vertical,drag,ground,terrain_error,settings; files beside the table; empty: not set.
std::vector<Flight> read_flights(const std::string& table);

// The autopilot of that word, with the settings of a row and the drag of its airframe.
traj::Autopilot autopilot_of(const std::string& word, std::string settings,
                             std::optional<double> drag, const std::string& source);

struct Sample {
  double time = 0;  // s
  Vec3 place;       // east, north, up of the mission's home
};

// What a flight was, and where it may have been.
struct Replay {
  traj::FlownMavlink mission;
  std::vector<Sample> samples;
  std::shared_ptr<const geom::GroundModel> ground;  // of a mission above terrain
};
Replay replay(const Flight& flight);
// By these rules, whatever the flight's autopilot and settings.
Replay replay(const Flight& flight, const traj::MissionRules& rules);

// Metres that a place is outside of the claim, along the worst axis; 0 inside, at most `most`.
double outside(const Flight& flight, const Replay& replay, const Vec3& place, double most = 30);

// Of each waypoint that is passed without a rest: how far from the way the claim reaches near it,
// and how far the track was.
struct CornerWidth {
  std::size_t item = 0;
  double claim = 0;  // m
  double track = 0;  // m
};
std::vector<CornerWidth> corner_widths(const Flight& flight, const Replay& replay);

// Over a place: from the lowest to the highest of what is claimed, metres.
double claimed_height(const Flight& flight, const Replay& replay, const Vec3& place);

// What judge() takes.
traj::Flown flown(const Flight& flight, const Replay& replay);

}  // namespace firmware
