#pragma once

// Zones of airspace as boxes of a map that are there at the zone's times.
//
// Example:
//   geom::ZoneFile file;
//   geom::Zone& zone = file.zones.emplace_back();
//   zone.identifier = "CH-1";
//   geom::ZoneVolume& volume = zone.volumes.emplace_back();
//   volume.outline.centre = {47.4, 8.5, 0};
//   volume.outline.radius = 20;
//   geom::BoxMapSpec spec{.bounds = {{-50, -50, 0}, {50, 50, 100}}};
//   spec.frame.origin = geom::GeodeticOrigin{47.4, 8.5, 0};
//   const geom::ZoneBoxes boxes = geom::zone_boxes(file, "zones.json", {.spec = spec});
//   assert(boxes.near.size() == 1 && !boxes.table.boxes.empty());

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geom/map/box_map.h"
#include "geom/map/ground_model.h"
#include "geom/zone/zone.h"
#include "geom/zone/zone_times.h"

namespace geom {

// By how much the map's z of a place may be above its height from another zero: z lies between
// height + least and height + most.
struct ZeroOffset {
  double least = 0;
  double most = 0;
};

// The map in which zones are closed, and the heights of its ground and sea if they are known.
struct ZoneRoom {
  const BoxMapSpec& spec;
  const GroundModel* ground = nullptr;  // null: nobody knows the ground
  std::optional<ZeroOffset> sea;        // of heights above the sea; absent: nobody knows
  std::optional<ZeroOffset> ellipsoid;  // of heights above the ellipsoid
  double slack = 0.5;                   // metres that boxes may reach sideways outside a zone
  double step = 2;  // metres that they may reach below or above a limit over sloping ground
  std::set<ZoneType> types = {ZoneType::prohibited, ZoneType::authorization, ZoneType::conditional,
                              ZoneType::u_space};  // that become boxes
  ZoneClock clock = {};
};

// A zone over or under the bounds of the map.
struct NearZone {
  std::size_t index = 0;        // in the file
  std::size_t boxes = 0;        // that it became
  std::vector<TimeSpan> times;  // when it is there, rounded outward
  // Whether a limit was not known in the map's z, so that it was left open.
  bool open_for_zero = false;
  bool open_for_hole = false;  // where the height model has no ground
};

struct ZoneBoxes {
  BoxTable table;              // ids are indices of zones
  std::vector<NearZone> near;  // all that lie over or under the bounds, also those of other types
};

// Boxes within the map's bounds that hold all that the zones of the chosen types hold there, at
// their times: outward in space by no more than slack and step (and the error of the ground and of
// zeros, and by how edges may be read), and in time as zone_times() says. What lies outside the
// bounds is left out. A limit whose zero or ground is not known counts as open. Throws
// InputError(source, …) for a map without origin on Earth, for a zone over the bounds that reaches
// more than 10 degrees of latitude or 20 of longitude from it, and where more than 2,000,000 boxes
// would be needed.
ZoneBoxes zone_boxes(const ZoneFile& file, const std::string& source, const ZoneRoom& room);

// The area of the map's bounds on Earth, a little larger. Precondition: the map counts from its
// origin.
SunArea area_of(const BoxMapSpec& spec);

// "zone CH-1 PROHIBITED: Airport": what its boxes are labelled with.
std::string label_of(const Zone& zone);

}  // namespace geom
