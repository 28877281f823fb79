#include "traj/mission/read_mission.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "support/cases.h"
#include "support/reading.h"
#include "traj/mission/formats/crazyflie.h"
#include "traj/mission/formats/mission_formats.h"
#include "traj/mission/formats/qgc_plan.h"
#include "traj/mission/formats/setpoints.h"
#include "traj/mission/formats/tello.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/judge/judge.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using geom::Vec3;
using testing::Random;

const geom::GeodeticOrigin kOrigin{47, 8, 400};
constexpr const char* kFormats[] = {"kml",       "geojson", "gltf",     "paths-csv", "setpoints",
                                    "crazyflie", "wpl",     "qgc-plan", "tello"};

// A tower, and room around it.
geom::CollisionScene tower() {
  return testing::scene_of({{{-5, -5, 0}, {5, 5, 60}}}, {Vec3(-500, -500, 0), Vec3(500, 500, 200)});
}

MissionReading reading() {
  MissionReading how;
  how.placement.origin = kOrigin;
  how.placement.heading = 0;
  how.start = Vec3(0, -100, 0);
  return how;
}

std::vector<FileFlight> read(const std::string& format, const std::string& text) {
  return read_mission(text, "file", *mission_format_named(format), reading(), {});
}

// Whether every flight of the file is found clear; a refusal is none.
bool accepted(const geom::CollisionScene& scene, const std::string& format,
              const std::string& text) {
  try {
    for (const FileFlight& one : read(format, text)) {
      if (!judge(scene, one.flown, {}).ok) return false;
    }
    return true;
  } catch (const geom::InputError&) {
    return false;
  }
}

// A map's origin of height 0 does not say how high its z = 0 is; --origin does, whatever it says.
TEST(ReadMission, ATelloLandsBelowItsScriptWithoutLandToo) {
  for (const char* end : {"", "land\n"}) {
    const std::string text = std::string("command\ntakeoff\ngo 0 0 100 50\n") + end;
    const auto flights = read_mission(text, "t.txt", kTello, reading(), {});
    EXPECT_TRUE(legs_of(flights.at(0).flown)->lands_below) << end;
    EXPECT_EQ(flights.at(0).notes.size(), *end ? 0u : 1u);
  }
}

TEST(DroneFiles, LinesAboveTheSeaNeedAMapWhoseHeightIsKnown) {
  const std::string kml =
      "<kml><LineString><altitudeMode>absolute</altitudeMode><coordinates>8,47,12 8.001,47,12"
      "</coordinates></LineString></kml>";
  const std::string geojson = R"({"type":"LineString","coordinates":[[8,47,12],[8.001,47,12]]})";
  geom::Frame frame;
  frame.origin = geom::GeodeticOrigin{47, 8, 0};
  for (const std::string& text : {kml, geojson}) {
    MissionReading options;
    const MissionFormat& format = recognised_mission_format(text);
    EXPECT_EQ(support::refusal_of([&] { read_mission(text, "f", format, options, frame); }),
              "f: its heights are above the sea or the ellipsoid, and the map does not say how "
              "high its z = 0 is: give --origin latitude,longitude,height");
    options.placement.origin = frame.origin;
    EXPECT_EQ(legs_of(read_mission(text, "f", format, options, frame).at(0).flown)->path[1].z(),
              12);
  }
}

// --- random files of several lines ----------------------------------------------------------

using Lines = std::vector<geom::Polyline>;

geom::Polyline free_line(Random& random) {
  geom::Polyline line;
  const int count = static_cast<int>(random.number(2, 5));
  for (int i = 0; i < count; ++i) {
    line.push_back({random.number(-45, 45), random.number(10, 60), random.number(5, 55)});
  }
  return line;
}

geom::Polyline hit_line(Random& random) {
  const double y = random.number(-4.9, 4.9);
  const double side = random.number(0, 1) < 0.5 ? -1 : 1;
  return {{side * random.number(6, 40), y, random.number(1, 55)},
          {-side * random.number(6, 40), y, random.number(1, 55)}};
}

std::string numbers(const Vec3& p) {
  static const geom::GeographicFrame earth(kOrigin);
  const geom::GeodeticPlace at = earth.place(p);
  std::ostringstream out;
  out.precision(12);
  out << at.longitude << ',' << at.latitude << ',' << at.height;
  return out.str();
}

std::string kml_of(Random& random, const Lines& lines) {
  std::string text = "<?xml version=\"1.0\"?><kml><Document>";
  bool open = false;
  for (const geom::Polyline& line : lines) {
    if (!open && random.number(0, 1) < 0.5) {
      text += "<Folder><Placemark><MultiGeometry>";
      open = true;
    }
    if (!open) text += "<Placemark>";
    text += "<LineString><altitudeMode>absolute</altitudeMode><coordinates>";
    for (const Vec3& p : line) text += numbers(p) + '\n';
    text += "</coordinates></LineString>";
    if (!open) text += "</Placemark>";
    if (open && random.number(0, 1) < 0.5) {
      text += "</MultiGeometry></Placemark></Folder>";
      open = false;
    }
  }
  if (open) text += "</MultiGeometry></Placemark></Folder>";
  return text + "</Document></kml>";
}

std::string coordinates_of(const geom::Polyline& line) {
  std::string text;
  for (const Vec3& p : line) text += (text.empty() ? "[" : ",[") + numbers(p) + "]";
  return "[" + text + "]";
}

std::string geojson_of(Random& random, const Lines& lines) {
  std::string parts;
  for (std::size_t i = 0; i < lines.size();) {
    const auto most = static_cast<double>(lines.size() - i);
    const auto end = i + 1 + static_cast<std::size_t>(random.number(0, most));
    const bool multi = random.number(0, 1) < 0.5;
    std::string inner;
    for (; i < end && i < lines.size(); ++i) {
      inner += inner.empty() ? "" : ",";
      inner += multi ? coordinates_of(lines[i])
                     : R"({"type":"LineString","coordinates":)" + coordinates_of(lines[i]) + "}";
    }
    const std::string geometry =
        multi ? R"({"type":"MultiLineString","coordinates":[)" + inner + "]}"
              : R"({"type":"GeometryCollection","geometries":[)" + inner + "]}";
    parts += parts.empty() ? "" : ",";
    parts += R"({"type":"Feature","properties":null,"geometry":)" + geometry + "}";
  }
  return R"({"type":"FeatureCollection","features":[)" + parts + "]}";
}

std::string gltf_of(const Lines& lines) {
  std::string bin;
  std::string nodes, meshes, accessors, views, shown;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string n = std::to_string(i);
    const std::string comma = i ? "," : "";
    shown += comma + n;
    nodes += comma + R"({"mesh":)" + n + "}";
    meshes += comma + R"({"primitives":[{"mode":3,"attributes":{"POSITION":)" + n + "}}]}";
    accessors += comma + R"({"bufferView":)" + n +
                 R"(,"componentType":5126,"type":"VEC3","count":)" +
                 std::to_string(lines[i].size()) + "}";
    views += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(bin.size()) +
             R"(,"byteLength":)" + std::to_string(12 * lines[i].size()) + "}";
    for (const Vec3& p : lines[i]) {
      const float v[3] = {static_cast<float>(p.x()), static_cast<float>(p.z()),
                          static_cast<float>(-p.y())};
      bin.append(reinterpret_cast<const char*>(v), sizeof v);
    }
  }
  std::string json = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)" + shown +
                     R"(]}],"nodes":[)" + nodes + R"(],"meshes":[)" + meshes +
                     R"(],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views +
                     R"(],"buffers":[{"byteLength":)" + std::to_string(bin.size()) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto word = [](std::size_t v) {
    const auto value = static_cast<std::uint32_t>(v);
    return std::string(reinterpret_cast<const char*>(&value), 4);
  };
  return "glTF" + word(2) + word(28 + json.size() + bin.size()) + word(json.size()) + "JSON" +
         json + word(bin.size()) + std::string("BIN\0", 4) + bin;
}

std::string setpoints_of(const geom::Polyline& points) {
  std::vector<Setpoint> rows;
  for (const Vec3& p : points) rows.push_back({10.0 * static_cast<double>(rows.size()), {p}, 0, 0});
  std::ostringstream out;
  write_setpoints(out, rows, SetpointAxes::enu);
  return out.str();
}

std::string crazyflie_of(const geom::Polyline& points) {
  Trajectory trajectory;
  constexpr int kParts = 2;  // of a leg: short ones meet within the millimetre that a file may miss
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3 part = (points[i] - points[i - 1]) / kParts;
    for (int k = 0; k < kParts; ++k) {
      const Vec3 from = points[i - 1] + k * part;
      trajectory.segments.push_back(hermite({from}, {Vec3(from + part)}, 30));
    }
  }
  std::ostringstream out;
  write_crazyflie(out, trajectory);
  return out.str();
}

std::string mission_of(const std::string& format, const geom::Polyline& points) {
  const Mission mission = make_mission(points, {kOrigin, 0}, {});
  std::ostringstream out;
  format == "wpl" ? write_wpl(out, mission) : write_qgc_plan(out, mission, "test");
  return out.str();
}

// From (0, -100, 1) away, then along x, and at the end perhaps back through the tower.
std::string tello_of(Random& random, bool hits) {
  TelloFlight flight;
  const int side = random.number(0, 1) < 0.5 ? -1 : 1;
  for (int i = static_cast<int>(random.number(1, 8)); i > 0; --i) {
    flight.legs.push_back({-100, side * static_cast<int>(random.number(21, 400)), 50, 50});
    flight.legs.push_back({100, -flight.legs.back().y, 0, 50});
  }
  if (hits) flight.legs.resize(flight.legs.size() + 25, {500, 0, 0, 100});
  std::ostringstream out;
  write_tello(out, flight);
  return out.str();
}

std::string table_of(const Lines& lines) {
  std::ostringstream out;
  out.precision(17);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const Vec3& p : lines[i]) {
      out << 'p' << i << ',' << p.x() << ',' << p.y() << ',' << p.z() << '\n';
    }
  }
  return out.str();
}

std::string file_of(const std::string& format, Random& random, const Lines& lines) {
  if (format == "kml") return kml_of(random, lines);
  if (format == "geojson") return geojson_of(random, lines);
  if (format == "gltf") return gltf_of(lines);
  if (format == "paths-csv") return table_of(lines);
  geom::Polyline points;
  for (const geom::Polyline& line : lines) points.insert(points.end(), line.begin(), line.end());
  if (format == "setpoints") return setpoints_of(points);
  if (format == "crazyflie") return crazyflie_of(points);
  return mission_of(format, points);
}

TEST(DroneFile, IsNotAcceptedWhereOnlyALaterPartHits) {
  const geom::CollisionScene scene = tower();
  Random random(2);
  for (int i = 0; i < support::cases(12000); ++i) {
    const std::string format = kFormats[i % std::size(kFormats)];
    Lines lines;
    for (int k = static_cast<int>(random.number(1, 6)); k > 0; --k) {
      lines.push_back(free_line(random));
    }
    const bool tello = format == "tello";
    if (i < 900) {
      const std::string good = tello ? tello_of(random, false) : file_of(format, random, lines);
      ASSERT_TRUE(accepted(scene, format, good)) << format << " case " << i;
    }
    const auto at =
        1 + static_cast<std::ptrdiff_t>(random.number(0, static_cast<double>(lines.size()) - 1e-9));
    lines.insert(lines.begin() + at, hit_line(random));
    const std::string bad = tello ? tello_of(random, true) : file_of(format, random, lines);
    ASSERT_FALSE(accepted(scene, format, bad)) << format << " case " << i;
  }
}

// --- files that were cut --------------------------------------------------------------------

geom::Polyline points_of(const FileFlight& file) {
  if (const FlownLegs* legs = legs_of(file.flown)) return legs->path;
  geom::Polyline points;
  if (const auto* flown = std::get_if<FlownSetpoints>(&file.flown.way)) {
    for (const Setpoint& s : flown->setpoints) points.push_back(s.state.position);
    return points;
  }
  for (const Segment& s : trajectory_of(file.flown).segments) {
    points.insert(points.end(), s.point.begin(), s.point.end());
  }
  return points;
}

bool begins_with(const geom::Polyline& whole, const geom::Polyline& part) {
  return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

TEST(DroneFile, ThatWasCutIsRefusedOrALineTableOfFewerLines) {
  Random random(3);
  const Lines lines = {free_line(random), free_line(random)};
  for (const std::string format : kFormats) {
    const std::string text =
        format == "tello" ? tello_of(random, false) : file_of(format, random, lines);
    const std::vector<FileFlight> whole = read(format, text);
    const bool lined =
        format != "kml" && format != "geojson" && format != "gltf" && format != "qgc-plan";
    for (std::size_t size = 0; size < text.size(); ++size) {
      const std::string part = text.substr(0, size);
      std::vector<FileFlight> cut;
      try {
        cut = read(format, part);
      } catch (const geom::InputError&) {
        continue;
      }
      const std::string where = format + " cut at " + std::to_string(size);
      ASSERT_LE(cut.size(), whole.size()) << where;
      bool same = cut.size() == whole.size();
      for (std::size_t i = 0; i < cut.size(); ++i) {
        const geom::Polyline found = points_of(cut[i]);
        const geom::Polyline wanted = points_of(whole[i]);
        ASSERT_TRUE(begins_with(wanted, found)) << where << ": a point that is not in the file";
        same = same && found.size() == wanted.size();
      }
      const bool line_ends = part.ends_with('\n') || text[size] == '\n';
      EXPECT_TRUE(same || (lined && line_ends)) << where;
      const bool has_end = format == "wpl" || format == "tello";
      if (has_end && !same) {
        EXPECT_FALSE(cut[0].notes.empty()) << where << ": nobody is told";
      }
    }
  }
}

TEST(DroneFile, SaysAllFlightsUnderNamesOfTheirOwn) {
  Random random(4);
  const auto files = read("kml", kml_of(random, {free_line(random), free_line(random)}));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].id, "file-1");
  EXPECT_EQ(files[1].id, "file-2");
  EXPECT_EQ(read("kml", kml_of(random, {free_line(random)}))[0].id, "file");
}

TEST(DroneFile, PlacesThatAreNotNearTheOriginAreRefused) {
  Random random(5);
  MissionReading options = reading();
  options.placement.origin = geom::GeodeticOrigin{8, 47, 400};
  EXPECT_THROW(read_mission(kml_of(random, {free_line(random)}), "file", kKml, options, {}),
               geom::InputError);
}

}  // namespace
}  // namespace traj
