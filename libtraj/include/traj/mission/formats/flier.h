#pragma once

// What flies a file, and how well.
//
// Example:
//   traj::Flier flier;
//   flier.autopilots = {traj::px4("1.17")};
//   flier.navigation = traj::Uncertainty{0.5, 1};  // metres that it may be wrong about its place

#include <optional>
#include <string>
#include <vector>

#include "traj/mission/mavlink/mission_flight.h"

namespace traj {

// Metres that a vehicle may be from where it takes itself to be, or ought to be: in each horizontal
// direction, and up or down.
struct Uncertainty {
  double across = 0;
  double vertical = 0;
};

struct Flier {
  std::vector<Autopilot> autopilots{px4(), ardupilot()};  // any of which may fly; not empty
  std::optional<Autopilot> exactly = {};                  // the one whose parameters are known
  std::optional<double> returns_at = {};  // m above home, where these parameters say it themselves
  std::vector<std::string> assumed = {};  // parameters of it that are the firmware's
  std::optional<Uncertainty> navigation = {};  // how wrong it may be about its place
  std::optional<Uncertainty> tracking = {};    // how far it may stray; missions have a model

  // The height of a return, m above home: `asked`, else that of the autopilot that is known
  // exactly. Throws UsageError where its parameters say another one, for it returns at theirs.
  std::optional<double> return_height(const std::optional<double>& asked) const;

  // The rules with what is known of the autopilot; what the rules say already goes before it, but
  // for the height of a return.
  MissionRules rules(MissionRules rules) const;

  // Metres along each axis that the vehicle's box is larger by: navigation, and with `tracks` what
  // is allowed for tracking.
  Vec3 allowance(bool tracks) const;
};

// Which autopilots may fly, as options and records say it.
struct AutopilotChoice {
  std::string word = "any";                    // as autopilots_of() knows them
  std::optional<std::string> parameters = {};  // the text of a file of the autopilot
  std::string parameters_name = {};            // its name, for messages
  std::optional<double> drag = {};             // 1/s, over the airframe's mass; else the usual one
};

// The flier with these autopilots. Throws UsageError for a word that nobody knows, and InputError
// as read_autopilot_settings() and set_autopilot() do.
Flier with_autopilots(Flier flier, const AutopilotChoice& choice);

}  // namespace traj
