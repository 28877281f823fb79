#pragma once

// Where on a map a mission's items are.

#include <optional>
#include <string>
#include <string_view>

#include "traj/mission/mavlink/mission_flight.h"

namespace traj {

// Each function throws geom::InputError(source, line, …) at the item for a height or a place that
// cannot be told. All arguments must outlive this.
class MissionPlaces {
 public:
  MissionPlaces(const Mission& mission, const MissionFrame& frame, const MissionRules& rules,
                std::string_view source);

  std::optional<double> home() const { return home_; }  // its z
  double above_home(const MissionItem& item, double height) const;
  double height(const MissionItem& item) const;  // its z
  // Whether a height of it is above the sea, so that it depends on where the sea level is.
  bool counts_from_sea() const;

  // Whether its place is 0, 0 or null: where the vehicle is. An altitude of 0 likewise. Both as
  // autopilots keep them: whole 1e-7 degrees and centimetres, cut.
  static bool is_here(const MissionItem& item);
  static bool is_there(const MissionItem& item);  // whether it is flown to a place that it says
  static bool keeps_height(const MissionItem& item);
  // The place that it says; `here` is the one before it, which ArduPilot takes what is 0 from.
  Vec3 place(const MissionItem& item, const std::optional<Vec3>& here) const;
  Vec3 on_map(const MissionItem& item, const geom::GeodeticPlace& at, double z) const;

 private:
  double above_sea(const geom::GeodeticPlace& place) const;  // its z
  double height_or(const MissionItem& item, const std::optional<Vec3>& here) const;

  const Mission& mission_;
  const MissionFrame& frame_;
  const MissionRules& rules_;
  geom::GeographicFrame earth_;
  std::optional<double> home_;
  std::string source_;
};

}  // namespace traj
