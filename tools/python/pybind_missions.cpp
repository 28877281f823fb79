// Drone files, and folders for an authority, that are proved.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/base/usage_error.h"
#include "pybind_arrays.h"
#include "pybind_module.h"
#include "traj/mission/airspace/flight_volumes.h"
#include "traj/mission/export_mission.h"
#include "traj/record/trajectory_record.h"
#include "traj/submit/check_submission.h"

namespace binding {
namespace {

using traj::ExportOptions;
using traj::FileOption;

// One keyword, and what was given for it.
struct Given {
  std::string_view word;
  py::handle value;

  [[noreturn]] void refuse(std::string_view expected) const {
    throw geom::UsageError(fmt::format("{}: expected {}, found {}", word, expected,
                                       std::string(py::str(py::repr(value)))));
  }

  double number(double least, double most) const {
    const double v = value.cast<double>();
    if (!(v >= least && v <= most)) refuse(fmt::format("a number from {} to {}", least, most));
    return v;
  }

  std::string text() const { return value.cast<std::string>(); }

  traj::Uncertainty uncertainty() const {
    const auto v = value.cast<std::array<double, 2>>();
    const auto fits = [](double metres) { return metres >= 0 && metres <= 100; };
    if (!fits(v[0]) || !fits(v[1])) refuse("metres across and up or down, each from 0 to 100");
    return {v[0], v[1]};
  }

  geom::Vec3 point() const {
    const auto v = value.cast<std::array<double, 3>>();
    for (const double x : v) {
      if (!(std::abs(x) <= geom::kLargestCoordinate)) refuse("x, y and z in metres");
    }
    return {v[0], v[1], v[2]};
  }

  geom::GeodeticOrigin origin() const {
    const auto v = value.cast<std::array<double, 3>>();
    if (!(std::abs(v[0]) <= 90 && std::abs(v[1]) <= 180 && std::isfinite(v[2]))) {
      refuse("latitude, longitude and height");
    }
    return {v[0], v[1], v[2]};
  }

  std::vector<traj::Autopilot> autopilots() const {
    auto known = traj::autopilots_of(text());
    if (!known) refuse(traj::autopilot_words());
    return *known;
  }

  traj::DjiAircraft aircraft() const {
    for (const traj::NamedDjiAircraft& known : traj::kDjiAircraft) {
      if (text() == known.name) return known.aircraft;
    }
    refuse("an aircraft such as m3e");
  }

  traj::DjiLostLink lost_link() const {
    const auto known = geom::value_of(traj::kDjiLostLinkWords, text());
    if (!known) refuse(geom::listed(traj::kDjiLostLinkWords));
    return *known;
  }

  std::string wpml_version() const {
    for (const std::string_view version : traj::kWrittenWpmlVersions) {
      if (text() == version) return text();
    }
    refuse("1.0.2 or 1.0.6");
  }
};

// Obeys one keyword. False for one that says nothing of an export.
bool set(FileOption option, const Given& given, ExportOptions& out) {
  traj::Placement& placement = out.placement;
  switch (option) {
    case FileOption::origin:
      return placement.origin = given.origin(), true;
    case FileOption::geoid:
      return placement.geoid = given.number(-200, 200), true;
    case FileOption::ground:
      return placement.ground = given.number(-1e6, 1e6), true;
    case FileOption::takeoff_height:
      return placement.takeoff_height = given.number(0.2, 10), true;
    case FileOption::heading:
      return placement.heading = given.number(-360, 360), true;
    case FileOption::rate:
      return out.rate = given.number(0.1, 1e4), true;
    case FileOption::axes:
      if (given.text() != "enu" && given.text() != "ned") given.refuse("enu or ned");
      return out.ned = given.text() == "ned", true;
    case FileOption::tolerance:
      return out.tolerance = given.number(1e-3, 100), true;
    case FileOption::speed:
      return out.speed = given.number(0.1, 100), true;
    case FileOption::hover:
      return out.lands = !given.value.cast<bool>(), true;
    case FileOption::aircraft:
      return out.dji.aircraft = given.aircraft(), true;
    case FileOption::wpml_version:
      return out.dji.version = given.wpml_version(), true;
    case FileOption::lost_link:
      return out.dji.lost_link = given.lost_link(), true;
    case FileOption::gimbal:
      return out.dji.gimbal = given.number(traj::kDjiGimbalDown, traj::kDjiGimbalUp), true;
    case FileOption::start:
      return out.dji.takeoff = given.point(), true;
    case FileOption::turns:
      return out.turns = given.number(traj::kDjiLeastTurn, 1000), true;
    case FileOption::autopilot:
      return out.flier.autopilots = given.autopilots(), true;
    case FileOption::navigation:
      return out.flier.navigation = given.uncertainty(), true;
    case FileOption::tracking:
      return out.flier.tracking = given.uncertainty(), true;
    case FileOption::volumes:
      return out.volumes = static_cast<std::size_t>(given.number(1, traj::kMostVolumes)), true;
    case FileOption::buffer:
      return out.buffer = given.number(0, 1000), true;
    default:
      return false;
  }
}

// The same, and TypeError for a value of another type.
bool obeyed(FileOption option, const Given& given, ExportOptions& out) {
  try {
    return set(option, given, out);
  } catch (const py::cast_error&) {
    throw py::type_error(fmt::format("{}: found {}, which is of another type", given.word,
                                     std::string(py::str(py::repr(given.value)))));
  }
}

// Which formats take heed of an option.
std::string formats_with(FileOption option) {
  std::vector<std::string_view> words;
  for (const traj::MissionFormat* one : traj::mission_formats()) {
    if (one->writes_with.has(option)) words.push_back(one->format.word);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

ExportOptions options_from(const py::kwargs& asked, const traj::MissionFormat& format) {
  ExportOptions out;
  for (const auto& [key, value] : asked) {
    const auto name = key.cast<std::string>();
    std::string word = name;
    std::replace(word.begin(), word.end(), '_', '-');
    const auto option = geom::value_of(traj::kFileOptionWords, word);
    if (!option || !obeyed(*option, {name, value}, out)) {
      throw py::type_error("export_mission() has no keyword \"" + name + '"');
    }
    if (format.writes_with.has(*option)) continue;
    throw geom::UsageError(
        fmt::format("{} is only for {} files: it would change nothing here, so leave it out", name,
                    formats_with(*option)));
  }
  if (out.speed && format.fastest > 0 && *out.speed > format.fastest) {
    throw geom::UsageError(
        fmt::format("speed: expected {}, found {}", format.fastest_because, *out.speed));
  }
  return out;
}

const traj::MissionFormat& format_from(const std::string& word) {
  const auto words = traj::written_mission_words();
  if (std::find(words.begin(), words.end(), word) == words.end()) {
    throw geom::UsageError(
        fmt::format("format: expected one of {}, found \"{}\"", fmt::join(words, ", "), word));
  }
  return *traj::mission_format_named(word);
}

// A record as what is to be exported, and who it was made for.
struct Exported {
  traj::ExportFlight flight;
  geom::Provenance provenance;
  std::string missing;  // why there is nothing to fly; empty otherwise
};

template <class Record>
Exported exported_record(const Record& record) {
  return {traj::export_flight(record), record.provenance, traj::why_not_flown(record)};
}

Exported exported_from(const py::object& what) {
  return py::isinstance<traj::TrajectoryRecord>(what)
             ? exported_record(what.cast<const traj::TrajectoryRecord&>())
             : exported_record(path_from(what));
}

py::dict refused(const traj::MissionExport& made) {
  py::dict out;
  out["ok"] = false;
  out["message"] = in_python(made.refusal);
  if (made.result.reason == traj::Reason::none) return out;
  out["reason"] = std::string(name(made.result.reason));
  out["place"] = tuple_of(made.result.place);
  return out;
}

py::dict accepted(const traj::MissionExport& made) {
  py::dict out;
  out["ok"] = true;
  out["bytes"] = py::bytes(made.written->text);
  py::list warnings;
  for (const std::string& warning : made.warnings) warnings.append(in_python(warning));
  out["warnings"] = warnings;
  if (!made.written->python.empty()) out["python"] = made.written->python;
  if (!made.written->csv.empty()) out["table"] = made.written->csv;
  return out;
}

traj::MissionExport export_one(const Scene& self, Exported one, const traj::MissionFormat& format,
                               const ExportOptions& options, double spare) {
  const Released released;
  const std::string& id = one.flight.id;
  self.scene.map().require(geom::Verified::contents, on_threads(0));
  agreed_vehicle(one.provenance, self.scene, geom::Differences::refused, id);
  if (!(spare <= self.scene.margin())) {
    throw geom::UsageError(fmt::format("spare: expected at most the margin, {} m, found {}",
                                       self.scene.margin(), spare));
  }
  for (const traj::Segment& s : one.flight.trajectory.segments) {
    require_metres(self.scene.map().spec().frame, s.point, id);
  }
  if (spare == 0) return traj::export_mission(self.scene, one.flight, format, options);
  const geom::CollisionScene smaller(self.scene.map(), self.scene.vehicle(),
                                     self.scene.margin() - spare);
  return traj::export_mission(smaller, one.flight, format, options);
}

// The file as skyway-export writes it.
py::dict export_mission(const Scene& self, const py::object& what, const std::string& format,
                        double spare, const py::kwargs& asked) {
  if (!(spare >= 0))
    throw geom::UsageError(fmt::format("spare: expected metres >= 0, found {}", spare));
  const traj::MissionFormat& to = format_from(format);
  const ExportOptions options = options_from(asked, to);
  Exported one = exported_from(what);
  if (!one.missing.empty()) return refused({{}, one.missing});
  const traj::MissionExport made = export_one(self, std::move(one), to, options, spare);
  return made.written ? accepted(made) : refused(made);
}

// The report of skyway-check as JSON.
std::string check_submission(const std::string& folder, unsigned threads) {
  const Released released;
  traj::SubmissionRun run;
  run.flights = run.pairs = on_threads(threads);
  return traj::to_json_line(traj::check_submission(folder, run));
}

}  // namespace

void bind_missions(py::module_& module) {
  module.def("export_mission", &export_mission, py::arg("scene"), py::arg("what"),
             py::arg("format"), py::kw_only(), py::arg("spare") = 0.0);
  module.def("check_submission", &check_submission, py::arg("folder"), py::kw_only(),
             py::arg("threads") = 0u);
}

}  // namespace binding
