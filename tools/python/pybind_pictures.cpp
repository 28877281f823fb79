// Pictures and the page, as text.

#include "cli/content/contents.h"
#include "geom/figure/plan_view.h"
#include "plot/tracks.h"
#include "pybind_arrays.h"
#include "pybind_module.h"
#include "traj/curve/to_enu.h"
#include "traj/figure/clearance.h"
#include "traj/figure/motion_profile.h"
#include "traj/figure/tracking.h"
#include "view/layers.h"
#include "view/page.h"

namespace binding {
namespace {

using geom::BoxMap;

template <class Record>
bool added(const py::handle& object, std::vector<cli::Read<Record>>& list) {
  if (!py::isinstance<Record>(object)) return false;
  list.push_back({object.cast<Record>(), "records", list.size() + 1});
  return true;
}

void require_metres(const geom::Frame& frame, const cli::Contents& contents) {
  for (const auto& [path, source, line] : contents.paths) {
    if (!path.points.empty()) binding::require_metres(frame, path.points, path.id);
  }
  for (const auto& [record, source, line] : contents.trajectories) {
    for (const traj::Segment& s : record.trajectory.segments) {
      binding::require_metres(frame, s.point, record.id);
    }
  }
}

void warn_of_unsaid_maps(const cli::Contents& contents) {
  const bool said = std::none_of(contents.flights.begin(), contents.flights.end(),
                                 [](const auto& read) { return read.record.map.empty(); });
  const char* words = "a flight log does not say its map: it is drawn as if it were of this one";
  if (!said && PyErr_WarnEx(PyExc_UserWarning, words, 1) < 0) throw py::error_already_set();
}

// What a file with the records would hold, all of it for `map` where there is one.
cli::Contents contents_of(const BoxMap* map, const py::list& records) {
  cli::Contents out;
  for (const py::handle& record : records) {
    added(record, out.paths) || added(record, out.trajectories) || added(record, out.flights) ||
        added(record, out.lattices);
  }
  if (map) {
    out.map = cli::Read<BoxMap>{*map, "map", 0};
    require_metres(map->spec().frame, out);
  }
  cli::require_same_map(out, map);
  if (map) warn_of_unsaid_maps(out);
  return out;
}

std::string plan_svg(const BoxMap* map, const py::list& records) {
  cli::Contents contents = contents_of(map, records);
  cli::drop_failed(contents);
  const auto own = plot::provenance_of(contents).frame;
  const geom::Axes axes = map ? map->spec().frame.axes : own.value_or(geom::Axes::enu);
  const auto lines = plot::plan_lines(contents, axes);
  if (map) return geom::figure::plan_view(*map, {}, lines);
  if (lines.empty()) throw py::value_error("records: expected something to draw, found none");
  return geom::figure::plan_view(lines);
}

std::string profile_svg(const traj::TrajectoryRecord& record) {
  if (record.status == traj::TrajectoryStatus::solved) return traj::figure::motion_profile(record);
  throw py::value_error("trajectory: expected a solved one, found \"" +
                        std::string(name(record.status)) + '"');
}

std::string clearance_svg(const Scene& scene, const py::list& records) {
  const BoxMap& map = scene.scene.map();
  if (map.size() == 0) throw py::value_error("scene: expected obstacles on its map, found none");
  cli::Contents contents = contents_of(&map, records);
  cli::drop_failed(contents);
  const plot::Tracks tracks = plot::tracks_of(contents, scene.scene);
  if (!tracks.list.empty())
    return traj::figure::clearance(scene.scene, tracks.list, tracks.x_label);
  throw py::value_error(
      "records: expected a path, a trajectory or a flight of some length, found none");
}

std::string tracking_svg(const traj::FlightLog& flight, const traj::TrajectoryRecord* planned) {
  if (!planned) return traj::figure::tracking(flight);
  const traj::Trajectory enu =
      traj::to_enu(planned->provenance.frame.value_or(geom::Axes::enu), planned->trajectory);
  return traj::figure::tracking(flight, "", &enu);
}

std::string page_html(const BoxMap* map, const py::list& records, const py::list& reports,
                      const std::string& title, unsigned threads) {
  cli::Contents contents = contents_of(map, records);
  const py::object dumps = py::module_::import("json").attr("dumps");
  for (const py::handle& report : reports) {
    const std::size_t number = contents.reports.size() + 1;
    contents.reports.push_back(
        {traj::parse_report_record(dumps(report).cast<std::string>(), "reports", number), "reports",
         number});
  }
  cli::require_same_map(contents, map);
  const Released released;
  view::Bundle bundle;
  const view::Json meta = view::describe(contents, {}, {}, on_threads(threads), bundle);
  return view::page(title, meta, bundle);
}

}  // namespace

void bind_pictures(py::module_& module) {
  module.def("plan_svg", &plan_svg);
  module.def("profile_svg", &profile_svg);
  module.def("clearance_svg", &clearance_svg);
  module.def("tracking_svg", &tracking_svg);
  module.def("page_html", &page_html);
}

}  // namespace binding
