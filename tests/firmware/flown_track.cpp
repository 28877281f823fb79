#include "flown_track.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "geom/map/geographic_frame.h"
#include "geom/map/ground_model.h"
#include "geom/shape/aabb.h"
#include "geom/shape/hull.h"
#include "geom/text/text_table.h"
#include "traj/mission/firmware/autopilot_settings.h"
#include "traj/mission/formats/qgc_plan.h"
#include "traj/mission/formats/wpl.h"

namespace firmware {
namespace {

traj::Mission read_mission(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("no mission " + path);
  return path.ends_with(".plan") ? traj::read_qgc_plan(in, path) : traj::read_wpl(in, path);
}

Vec3 around(const Flight& flight, const traj::Drift& drift) {
  return drift.around + traj::kMissionStray +
         Vec3(flight.navigation_across, flight.navigation_across, flight.navigation_vertical);
}

double distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double square = way.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(way) / square, 0.0, 1.0) : 0;
  return (a + t * way - p).norm();
}

double from_way(const traj::FlownMission& mission, const Vec3& p) {
  double least = (mission.path.front() - p).norm();
  for (std::size_t i = 1; i < mission.path.size(); ++i) {
    least = std::min(least, distance(p, mission.path[i - 1], mission.path[i]));
  }
  return least;
}

// Whether a box of these half sides around the place is apart from the hull's bounds.
bool away(const std::vector<Vec3>& hull, const Vec3& place, const Vec3& half) {
  const geom::Aabb box = *geom::bounds(hull);
  return ((place + half).array() < box.min.array()).any() ||
         ((place - half).array() > box.max.array()).any();
}

// A simulator's ground is flat, or as high as the autopilot's terrain: what lands elsewhere sinks
// on through the ground of the claim.
bool is_below_roof(const traj::FlownMission& mission, const Vec3& p) {
  if (!mission.ends.landing_on) return false;
  if (!mission.terrain && *mission.ends.landing_on < 1) return false;
  return p.z() < *mission.ends.landing_on && (p - mission.path.back()).head<2>().norm() < 1;
}

// The ground of a file of terrain.py, above that at home: 0, 0.
std::shared_ptr<const geom::GroundModel> read_grid(const std::string& path) {
  std::ifstream in(path);
  std::string word;
  std::size_t columns = 0;
  std::size_t rows = 0;
  geom::GroundGridSpec spec;
  in >> word >> columns >> word >> rows >> word >> spec.corner.x() >> word >> spec.corner.y() >>
      word >> spec.cell;
  std::vector<double> heights(columns * rows);
  for (std::size_t j = rows; j-- > 0;) {
    for (std::size_t i = 0; i < columns; ++i) in >> heights[j * columns + i];
  }
  if (!in || columns < 2 || rows < 2) throw std::runtime_error("no ground " + path);
  const auto at = [&](std::size_t i, std::size_t j) { return heights[j * columns + i]; };
  const Vec3 home(-spec.corner.x() / spec.cell, -spec.corner.y() / spec.cell, 0);
  if (home.x() != std::floor(home.x()) || home.y() != std::floor(home.y())) {
    throw std::runtime_error("home is no point of the ground " + path);
  }
  const double zero = at(static_cast<std::size_t>(home.x()), static_cast<std::size_t>(home.y()));
  spec.columns = columns - 1;
  spec.rows = rows - 1;
  spec.hash = path;
  std::vector<double> low;
  std::vector<double> high;
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const auto [least, most] =
          std::minmax({at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
      low.push_back(least - zero);
      high.push_back(most - zero);
    }
  }
  return std::make_shared<geom::GroundModel>(spec, std::move(low), std::move(high));
}

}  // namespace

traj::Autopilot autopilot_of(const std::string& word, std::string settings,
                             std::optional<double> drag, const std::string& source) {
  std::vector<traj::Autopilot> asked = traj::autopilots_of(word).value();
  std::replace(settings.begin(), settings.end(), ' ', '\n');
  std::replace(settings.begin(), settings.end(), '=', ' ');
  traj::Autopilot out = asked.front();
  if (!settings.empty()) {
    std::istringstream in(settings);
    out = traj::set_autopilot(traj::read_autopilot_settings(in, source), asked, source).autopilot;
  }
  if (drag) traj::set_drag(out, *drag);
  return out;
}

std::vector<Flight> read_flights(const std::string& table) {
  std::ifstream in(table);
  if (!in) throw std::runtime_error("no table " + table);
  const std::filesystem::path folder = std::filesystem::path(table).parent_path();
  const auto number = [](const std::string& field) { return geom::parse_number(field); };
  std::vector<Flight> out;
  geom::TextLines lines(in, table);
  for (lines.next(); lines.next();) {
    const std::vector<std::string> f = geom::split_fields(lines.line());
    if (f.size() != 11) lines.refuse({.expected = "11 fields"});
    out.push_back({std::filesystem::path(f[0]).stem().string(), (folder / f[0]).string(),
                   (folder / f[1]).string(), f[2], number(f[3]), number(f[4]),
                   number(f[5]).value_or(0), number(f[6]).value_or(0), number(f[7]),
                   f[8].empty() ? "" : (folder / f[8]).string(), number(f[9]).value_or(0), f[10]});
  }
  return out;
}

Replay replay(const Flight& flight) {
  traj::MissionRules rules;
  rules.autopilots = traj::autopilots_of(flight.autopilot).value();
  for (traj::Autopilot& one : rules.autopilots) {
    if (flight.drag) traj::set_drag(one, *flight.drag);
  }
  if (!flight.settings.empty()) {
    rules.autopilots = {autopilot_of(flight.autopilot, flight.settings, flight.drag, flight.track)};
  }
  rules.acceptance = flight.acceptance;
  rules.return_height = flight.return_height;
  return replay(flight, rules);
}

Replay replay(const Flight& flight, const traj::MissionRules& asked) {
  traj::MissionRules rules = asked;
  std::shared_ptr<const geom::GroundModel> ground;
  if (!flight.ground.empty()) {
    ground = read_grid(flight.ground);
    rules.terrain = {ground.get(), geom::Axes::enu, flight.terrain_error};
  }
  traj::Mission mission = read_mission(flight.mission);
  const traj::MissionFrame frame{
      {mission.home->latitude, mission.home->longitude, mission.home->height}, 0};
  Replay out{traj::flown_mission(mission, frame, rules, flight.mission), {}, ground};
  const geom::GeographicFrame earth(frame.origin);
  std::ifstream in(flight.track);
  if (!in) throw std::runtime_error("no track " + flight.track);
  geom::TextLines lines(in, flight.track);
  for (lines.next(); lines.next();) {
    const std::vector<std::string> f = geom::split_fields(lines.line());
    if (f.size() != 4) lines.refuse({.expected = "seconds, latitude, longitude, altitude"});
    const auto value = [&](std::size_t i) { return geom::parse_number(f[i]).value(); };
    Vec3 p = earth.enu({value(1), value(2), frame.origin.height});
    p.z() = value(3) - mission.home->height;
    if (is_below_roof(out.mission, p)) break;
    out.samples.push_back({value(0), p});
  }
  return out;
}

double outside(const Flight& flight, const Replay& replay, const Vec3& place, double most) {
  double best = most;
  for (const traj::Drift& drift : replay.mission.drift) {
    const Vec3 pad = around(flight, drift);
    for (const traj::Sweep& sweep : drift.sweeps) {
      if (away(sweep.hull, place, pad + Vec3::Constant(best))) continue;
      const auto meets = [&](double more) {
        const Vec3 box = pad + Vec3::Constant(more);
        return geom::hull_meets(sweep.hull, {place - box, place + box}).has_value();
      };
      if (meets(0)) return 0;
      if (!meets(best)) continue;
      double near = 0;
      for (int i = 0; i < 20; ++i) {
        const double middle = (near + best) / 2;
        (meets(middle) ? best : near) = middle;
      }
    }
  }
  return best;
}

double claimed_height(const Flight& flight, const Replay& replay, const Vec3& place) {
  constexpr double kAny = 1e5;  // m
  double low = kAny;
  double high = -kAny;
  for (const traj::Drift& drift : replay.mission.drift) {
    const Vec3 pad = around(flight, drift);
    const Vec3 column(pad.x(), pad.y(), kAny);
    for (const traj::Sweep& sweep : drift.sweeps) {
      if (away(sweep.hull, place, column)) continue;
      if (!geom::hull_meets(sweep.hull, {place - column, place + column})) continue;
      for (const Vec3& p : sweep.hull) {
        low = std::min(low, p.z() - pad.z());
        high = std::max(high, p.z() + pad.z());
      }
    }
  }
  return std::max(0.0, high - low);
}

std::vector<CornerWidth> corner_widths(const Flight& flight, const Replay& replay) {
  constexpr double kNear = 30;  // m
  std::vector<CornerWidth> out;
  const traj::FlownMission& mission = replay.mission;
  for (const traj::Drift& drift : mission.drift) {
    for (const traj::Sweep& sweep : drift.sweeps) {
      if (sweep.part.manoeuvre != traj::Manoeuvre::corner) continue;
      auto found = std::find_if(out.begin(), out.end(), [&](const CornerWidth& one) {
        return one.item == sweep.part.item;
      });
      if (found == out.end()) found = out.insert(out.end(), CornerWidth{sweep.part.item, 0, 0});
      for (const Vec3& a : sweep.hull) {  // the middles of edges too: the deepest of a triangle
        for (const Vec3& b : sweep.hull) {
          found->claim = std::max(found->claim, from_way(mission, (a + b) / 2) +
                                                    around(flight, drift).head<2>().maxCoeff());
        }
      }
    }
  }
  for (CornerWidth& width : out) {
    for (std::size_t i = 1; i + 1 < mission.path.size(); ++i) {
      if (mission.legs[i].item != width.item) continue;
      for (const Sample& sample : replay.samples) {
        if ((sample.place - mission.path[i]).norm() > kNear) continue;
        width.track = std::max(width.track, from_way(mission, sample.place));
      }
    }
  }
  return out;
}

traj::Flown flown(const Flight& flight, const Replay& replay) {
  traj::FlownMission mission = replay.mission;
  mission.fences.clear();  // whatever the flight kept to
  mission.rally.clear();
  mission.touches.clear();
  mission.returns = false;
  return {std::move(mission),
          Vec3(flight.navigation_across, flight.navigation_across, flight.navigation_vertical)};
}

}  // namespace firmware
