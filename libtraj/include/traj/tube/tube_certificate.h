#pragma once

// The certificate of a proved tube: what a script needs to follow the proof by itself.
//
// Example:
//   const auto quad = traj::vehicle_named("quad2kg");
//   traj::FlightOptions options{.quadrotor = *traj::quadrotor_of(quad->airframe)};
//   options.gains = *quad->airframe.gains;
//   options.law = traj::ControlLaw::geometric;
//   const traj::Disturbances gusty{.gust_most = 0.5};
//   const traj::ReferenceTrack track(trajectory);
//   const auto tube = traj::with_room(prove_tube(track, options, gusty, {}, {.by_spans = true}));
//   if (!tube.trouble) {
//     std::cout << traj::tube_certificate_line("q1", geom::Axes::enu, {options, gusty}, tube);
//   }

#include <string>

#include "geom/map/frame.h"
#include "traj/tube/prove_tube.h"

namespace traj {

// The tube with radii and tilt made larger by 1.5 %, and bounds rounded up to four digits. A
// checker that sums otherwise finds slightly larger radii, and these have room for them.
ProvedTube with_room(ProvedTube tube);

// What a tube was proved for.
struct TubeConditions {
  const FlightOptions& options;
  const Disturbances& disturbances;
};

// One JSON object, "type":"tube_certificate", with a newline: docs/formats.md. `axes`: those of the
// trajectory's record. Precondition: the tube has a proof, by spans.
std::string tube_certificate_line(const std::string& id, geom::Axes axes,
                                  const TubeConditions& proved_for, const ProvedTube& tube);

}  // namespace traj
