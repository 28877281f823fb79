#include <algorithm>
#include <cmath>
#include <set>

#include "geom/base/error.h"
#include "layers.h"

namespace view {
namespace {

using geom::Vec3;

constexpr std::size_t kMostSamples = 2000;   // of one motion: two a pixel of a wide plot
constexpr std::size_t kAllSamples = 60000;   // of all together
constexpr std::size_t kFewestSamples = 100;  // of one, however many there are
constexpr double kSamplesPerSecond = 50;
constexpr std::size_t kAllKnots = 500000;  // of all trajectories together: 26 MB

class Reach {
 public:
  void add(geom::Axes axes, const Vec3& p) {
    const Vec3 enu = geom::to_enu(axes, p);
    low_ = low_.cwiseMin(enu);
    high_ = high_.cwiseMax(enu);
  }
  bool empty() const { return low_.x() > high_.x(); }
  geom::Aabb box() const { return {low_, high_}; }

 private:
  Vec3 low_ = Vec3::Constant(1e300);
  Vec3 high_ = -low_;
};

Reach reach_of(const cli::Contents& contents) {
  Reach reach;
  if (contents.map) {
    const auto& spec = contents.map->record.spec();
    reach.add(spec.frame.axes, spec.bounds.min);
    reach.add(spec.frame.axes, spec.bounds.max);
    return reach;
  }
  const auto add = [&](const geom::Provenance& made_for, const auto& points) {
    for (const Vec3& p : points) reach.add(axes_of(contents, made_for), p);
  };
  for (const auto& [lattice, source, line] : contents.lattices) {
    const plan::Index3& d = lattice.dims();
    const plan::LatticeGrid& grid = lattice.grid();
    add(lattice.made_for(),
        std::vector<Vec3>{grid.position({0, 0, 0}), grid.position({d[0] - 1, d[1] - 1, d[2] - 1})});
  }
  for (const auto& [tree, source, line] : contents.trees) add(tree.provenance, tree.tree.points);
  for (const auto& [path, source, line] : contents.paths) add(path.provenance, path.points);
  for (const auto& [record, source, line] : contents.trajectories) {
    for (const auto& segment : record.trajectory.segments) add(record.provenance, segment.point);
  }
  for (const auto& [corridor, source, line] : contents.corridors) {
    for (const auto& piece : corridor.pieces) add(corridor.provenance, piece.vertices);
  }
  for (const auto& [flight, source, line] : contents.flights) {
    for (const auto& s : flight.samples) reach.add(geom::Axes::enu, s.position);
  }
  for (const auto& [way, source, line] : contents.contingencies) add(way.provenance, way.points);
  for (const auto& [report, source, line] : contents.reports) {
    if (report.place) add(report.provenance, std::vector<Vec3>{*report.place});
    if (!report.returns) continue;
    for (const traj::TimedPlace& one : report.returns->timeline)
      add(report.provenance, std::vector<Vec3>{one.place});
  }
  return reach;
}

// How many samples each of `motions` gets that lasts `seconds`.
std::size_t samples_of(double seconds, std::size_t motions) {
  const std::size_t most = std::clamp(kAllSamples / motions, kFewestSamples, kMostSamples);
  const double wanted = std::ceil(seconds * kSamplesPerSecond) + 1;
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::min<double>(wanted, most)));
}

// A few trajectories are sampled; many have their joints.
Sampling sampling_of(double seconds, std::size_t trajectories, std::size_t motions) {
  if (trajectories <= kMostAlone) return {samples_of(seconds, motions), false};
  return {std::max<std::size_t>(2, kAllKnots / trajectories), true};
}

// What a flight was for: the trajectory of its id, else the only one, else nothing is known.
geom::Provenance made_for(const cli::Contents& contents, const traj::FlightLog& flight) {
  for (const auto& [record, source, line] : contents.trajectories) {
    if (record.id == flight.id) return record.provenance;
  }
  if (contents.trajectories.size() == 1) return contents.trajectories.front().record.provenance;
  return {};
}

// The first report of each mission that has a timeline, if neither a trajectory nor a flight log of
// that mission is there.
std::vector<const cli::Read<traj::ReportSummary>*> timelines(const cli::Contents& contents) {
  std::set<std::string> known;
  for (const auto& read : contents.trajectories) known.insert(read.record.id);
  for (const auto& read : contents.flights) known.insert(read.record.id);
  std::vector<const cli::Read<traj::ReportSummary>*> out;
  for (const auto& read : contents.reports) {
    const auto& returns = read.record.returns;
    if (!returns || returns->timeline.size() < 2) continue;
    if (known.insert(read.record.id).second) out.push_back(&read);
  }
  return out;
}

Json motions(const cli::Contents& contents, const LocalFrame& frame, const Fleet& fleet,
             Clearance& clearance, Bundle& bundle) {
  Json out = Json::array();
  const std::size_t trajectories = contents.trajectories.size();
  const std::size_t count = trajectories + contents.flights.size();
  for (const auto& read : contents.trajectories) {
    const traj::TrajectoryRecord& record = read.record;
    if (record.status != traj::TrajectoryStatus::solved) continue;
    const Sampling sampling = sampling_of(traj::duration(record.trajectory), trajectories, count);
    out.push_back(trajectory_layer(read, sampling, frame.of(axes_of(contents, record.provenance)),
                                   clearance, bundle));
    if (auto tube = tube_layer(contents, record, bundle)) out.back()["tube"] = *std::move(tube);
    fleet.add_times(record, out.back());
  }
  for (const auto& read : contents.flights) {
    const auto& log = read.record;
    const geom::Provenance provenance = made_for(contents, log);
    const double seconds = log.samples.back().time - log.samples.front().time;
    out.push_back(flight_layer(read, samples_of(seconds, count), provenance,
                               frame.of(axes_of(contents, provenance)), clearance, bundle));
  }
  for (const auto* read : timelines(contents)) {
    out.push_back(
        timeline_layer(read->record, frame.of(axes_of(contents, read->record.provenance)), bundle));
  }
  return out;
}

Json unsolved(const cli::Contents& contents) {
  Json out = Json::array();
  for (const auto& [record, source, line] : contents.trajectories) {
    if (record.status == traj::TrajectoryStatus::solved) continue;
    out.push_back(
        {{"id", record.id}, {"status", name(record.status)}, {"message", record.message}});
  }
  return out;
}

}  // namespace

Json as_json(const traj::Limits& limits) {
  Json out = Json::object();
  for (const traj::LimitKind& kind : traj::kLimitKinds) {
    if (const auto& limit = limits[kind.limit]) out[kind.name] = *limit;
  }
  return out;
}

Json as_json(const Vec3& v) { return {v[0], v[1], v[2]}; }

geom::Axes axes_of(const cli::Contents& contents, const geom::Provenance& provenance) {
  if (provenance.frame) return *provenance.frame;
  return contents.map ? contents.map->record.spec().frame.axes : geom::Axes::enu;
}

Extent extent_of(const cli::Contents& contents) {
  const Reach reach = reach_of(contents);
  if (reach.empty())
    throw geom::InputError(
        "inputs", {.expected = "a map, a path, a trajectory or a flight to show", .found = "none"});
  const geom::Aabb box = reach.box();
  const Vec3 middle = 0.5 * (box.min + box.max);
  return {{Vec3(std::round(middle.x()), std::round(middle.y()), 0)}, box};
}

Json describe(const cli::Contents& contents, const std::optional<Frames>& frames,
              const cli::VehicleOptions& vehicle, const geom::Execution& run, Bundle& bundle) {
  const Extent extent = extent_of(contents);
  const LocalFrame& frame = extent.frame;
  Clearance clearance(contents, vehicle);
  Json out = {{"origin", as_json(frame.origin)},
              {"min", as_json(extent.bounds.min)},
              {"max", as_json(extent.bounds.max)}};
  if (contents.map) out["map"] = map_layer(contents.map->record, frame, bundle);
  const auto frame_of = [&](const geom::Provenance& made_for) {
    return frame.of(axes_of(contents, made_for));
  };
  const auto each = [&](const char* key, const auto& list, const auto& layer) {
    Json layers = Json::array();
    for (const auto& read : list) layers.push_back(layer(read));
    out[key] = std::move(layers);
  };
  each("lattices", contents.lattices,
       [&](const auto& r) { return lattice_layer(r, frame_of(r.record.made_for()), bundle); });
  each("trees", contents.trees,
       [&](const auto& r) { return tree_layer(r.record, frame_of(r.record.provenance), bundle); });
  each("paths", contents.paths, [&](const auto& r) {
    Json path = path_layer(r.record, frame_of(r.record.provenance), bundle);
    if (r.line == 0) path["mission"] = true;  // of a drone file
    return path;
  });
  each("corridors", contents.corridors, [&](const auto& r) {
    return corridor_layer(r.record, frame_of(r.record.provenance), bundle);
  });
  const Fleet fleet(contents, run);
  out["motions"] = motions(contents, frame, fleet, clearance, bundle);
  if (fleet.together()) out["fleet"] = fleet.json(bundle);
  if (frames) out["frames"] = frames_layer(*frames, contents, bundle);
  out["unsolved"] = unsolved(contents);
  if (!contents.contingencies.empty()) {
    each("contingencies", contents.contingencies, [&](const auto& r) {
      return contingency_layer(r.record, frame_of(r.record.provenance), bundle);
    });
  }
  each("reports", contents.reports,
       [&](const auto& r) { return report_layer(r.record, frame_of(r.record.provenance)); });
  return out;
}

}  // namespace view
