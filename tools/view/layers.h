#pragma once

// What the page shows of each kind of artefact: its numbers in JSON, its arrays in a bundle.

#include "bundle.h"
#include "cli/content/contents.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "fleet.h"
#include "frames.h"
#include "local_frame.h"

namespace view {

// The axes that a record is in: its own word, else the map's, else ENU.
geom::Axes axes_of(const cli::Contents& contents, const geom::Provenance& provenance);

// The middle of everything there is, and how far it reaches.
struct Extent {
  LocalFrame frame;
  geom::Aabb bounds;  // ENU, metres; of the map where there is one, else of all points
};
// Throws geom::InputError where there is nothing that has a place.
Extent extent_of(const cli::Contents& contents);

// Everything the page holds: the value of its <script id="skyway-meta">.
Json describe(const cli::Contents& contents, const std::optional<Frames>& frames,
              const cli::VehicleOptions& vehicle, const geom::Execution& run, Bundle& bundle);

// The obstacles that the vehicle's distance is taken from.
class Clearance {
 public:
  Clearance(const cli::Contents& contents, const cli::VehicleOptions& vehicle);

  // Null without a map or vehicle.
  const geom::CollisionScene* scene_for(const geom::Provenance& made_for, const std::string& source,
                                        std::size_t line);

  // The vehicle that this record or the options name.
  std::optional<geom::Vehicle> vehicle(const geom::Provenance& made_for) const;

 private:
  std::optional<geom::Vehicle> asked_;
  std::optional<cli::Scenes> scenes_;
};

// The frame of each layer but the map's has the axes of what is shown.

// The map's boxes: corners, ids, labels and buildings; of many boxes in tiles, with blocks for
// afar.
Json box_layer(const geom::BoxMap& map, const LocalFrame& frame, Bundle& bundle);
Json map_layer(const geom::BoxMap& map, const LocalFrame& frame, Bundle& bundle);
// Throws geom::InputError for more nodes than a browser can show.
Json lattice_layer(const cli::Read<plan::Lattice>& lattice, const LocalFrame& frame,
                   Bundle& bundle);
Json tree_layer(const plan::SearchTreeRecord& tree, const LocalFrame& frame, Bundle& bundle);
Json path_layer(const geom::PathRecord& path, const LocalFrame& frame, Bundle& bundle);
Json corridor_layer(const traj::CorridorShape& corridor, const LocalFrame& frame, Bundle& bundle);
Json report_layer(const traj::ReportSummary& report, const LocalFrame& frame);
Json return_layer(const traj::ReturnSummary& returns, const LocalFrame& frame);
// The way of a mission in the times that a report gives it: a motion without derivatives.
Json timeline_layer(const traj::ReportSummary& report, const LocalFrame& frame, Bundle& bundle);
Json contingency_layer(const traj::ContingencyRecord& way, const LocalFrame& frame, Bundle& bundle);

// How a trajectory stands in the page: at `count` instants, evenly spaced, or at its joints, at
// most so many (>= 2).
struct Sampling {
  std::size_t count = 2;
  bool joints = false;
};
// The trajectory is not empty.
Json trajectory_layer(const cli::Read<traj::TrajectoryRecord>& trajectory, const Sampling& sampling,
                      const LocalFrame& frame, Clearance& clearance, Bundle& bundle);
// The tube of a trajectory that is of a file of reports; nothing where none of them is of it.
std::optional<Json> tube_layer(const cli::Contents& contents, const traj::TrajectoryRecord& record,
                               Bundle& bundle);
// At most `samples` rows of the log, the first and the last among them. `made_for` says for which
// vehicle and in which axes the obstacles are.
Json flight_layer(const cli::Read<traj::FlightLog>& flight, std::size_t samples,
                  const geom::Provenance& made_for, const LocalFrame& frame, Clearance& clearance,
                  Bundle& bundle);

// Which of the page's motions (solved trajectories, then flights) the frames were taken along: the
// one that their poses keep nearest to. Throws geom::InputError where they follow none.
Json frames_layer(const Frames& frames, const cli::Contents& contents, Bundle& bundle);

Json as_json(const traj::Limits& limits);
Json as_json(const geom::Vec3& v);  // [x,y,z]

}  // namespace view
