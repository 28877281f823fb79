#pragma once

// Volumes of airspace with altitudes and times: the Volume4D of ASTM F3548-21.
//
// Example:
//   geom::Volume4d volume{.lower = 400, .upper = 520};
//   volume.outline.centre = {47.4, 8.5, 0};
//   volume.outline.radius = 100;
//   volume.start = "2026-05-04T06:30:00Z";
//   volume.end = "2026-05-04T07:00:00Z";
//   std::istringstream in(geom::operational_intent_details({{volume}}, 0));
//   assert(geom::read_volumes_4d(in, "intent.json")[0].upper == 520);
//
// By them operators tell each other where they will fly, and authorities where nobody may.

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/geodetic_outline.h"

namespace geom {

// Closed in space and time.
struct Volume4d {
  GeodeticOutline outline;
  std::optional<double> lower;  // metres above the ellipsoid of WGS 84; absent: open below
  std::optional<double> upper;  // > lower; absent: open above
  std::optional<std::string>
      start;  // as epoch_from() writes it (geom/text/instant.h); absent: since ever
  std::optional<std::string> end;  // > start; absent: for ever
};

// All volumes of a file, at least one, in order: one Volume4D, a list of them, the details of an
// operational intent or of a constraint (`volumes`, then `off_nominal_volumes`), these with their
// `reference`, or the answer to a question for one (`operational_intent`, `constraint`).
//
// Throws InputError(source, …) for whatever else stands there: a member that is not known, both
// outlines or none, altitudes above anything but the ellipsoid (W84) or in other units than metres
// (M), a unit, reference or format that is not said, times in another form than RFC 3339 in UTC,
// ends that are not after (above) begins, places that are not on Earth, vertices that come twice in
// a row, and a ring whose last is its first. A member that is null is absent.
std::vector<Volume4d> read_volumes_4d(std::istream& in, std::string_view source);

// What an operational intent says of space and time: where the flight will be, and where it may be
// if something goes wrong.
struct IntentVolumes {
  std::vector<Volume4d> nominal;
  std::vector<Volume4d> off_nominal;
};

// Reads the two lists apart. If the file has no such lists, all its volumes are nominal.
IntentVolumes read_intent_volumes(std::istream& in, std::string_view source);

// The details of an operational intent: JSON, a volume a line. Numbers come back as they are.
std::string operational_intent_details(std::span<const Volume4d> volumes,
                                       std::optional<int> priority,
                                       std::span<const Volume4d> off_nominal = {});

}  // namespace geom
