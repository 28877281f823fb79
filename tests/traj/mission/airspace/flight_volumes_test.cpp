#include "traj/mission/airspace/flight_volumes.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>
#include <cmath>
#include <random>

#include "geom/text/instant.h"

namespace traj {
namespace {

using geom::Vec2;

const geom::GeodeticOrigin kOrigin{48.2, 16.37, 200};

struct Flight {
  Trajectory trajectory;
  FlightOnEarth on_earth;
};

// Smooth bits between random places, a hundred metres and more apart.
void make_flight(std::uint64_t seed, double size, Flight& out) {
  std::mt19937_64 random(seed);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<>(a, b)(random);
  };
  Vec3 at(between(-1e4, 1e4), between(-1e4, 1e4), between(20, 100));
  for (int i = 0; i < 4; ++i) {
    const Vec3 to = at + Vec3(between(-size, size), between(-size, size), between(-15, 15));
    const Vec3 bow(between(-size, size) / 5, between(-size, size) / 5, 0);
    Segment s;
    s.duration = between(5, 60);
    for (std::size_t k = 0; k < kPoints; ++k) {
      const double share = static_cast<double>(k) / kDegree;
      s.point[k] = at + share * (to - at) + 4 * share * (1 - share) * bow;
    }
    s.point.front() = at;
    s.point.back() = to;
    out.trajectory.segments.push_back(s);
    at = to;
  }
  out.on_earth = {{&out.trajectory, between(-100, 1e5), Vec3(0.5, 0.5, 0.3)},
                  "2026-05-04T06:30:00.1Z",
                  kOrigin};
}

// The outline with its edges as geodesics, in metres about a place: an oracle that shares nothing
// with the proof.
bool inside_of_geodesics(const geom::Volume4d& volume, const geom::GeodeticPlace& place) {
  const geom::GeographicFrame here({place.latitude, place.longitude, 0});
  geom::Polygon polygon;
  const auto& ring = volume.outline.ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    const auto line = GeographicLib::Geodesic::WGS84().InverseLine(a.latitude, a.longitude,
                                                                   b.latitude, b.longitude);
    for (int k = 0; k < 20; ++k) {
      double latitude;
      double longitude;
      line.Position(line.Distance() * k / 20, latitude, longitude);
      Vec2 p;
      here.from_geodetic(latitude, longitude, p.x(), p.y());
      polygon.outer.push_back(p);
    }
  }
  return geom::contains(polygon, Vec2::Zero());
}

double total(const FlightOnEarth& flight, std::span<const geom::Volume4d> volumes) {
  double sum = 0;
  for (const geom::Volume4d& v : volumes) {
    const auto outline =
        geom::outline_on_map(v.outline, flight.origin, geom::CircleSide::within, "v", "v");
    double twice = 0;
    for (std::size_t i = 0; i < outline.ring.size(); ++i) {
      const Vec2& a = outline.ring[i];
      const Vec2& b = outline.ring[(i + 1) % outline.ring.size()];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    sum +=
        std::abs(twice) / 2 * (*v.upper - *v.lower) * geom::seconds_between(*v.start, *v.end).most;
  }
  return sum;
}

TEST(FlightVolumes, HoldTheFlight) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Flight flight;
    make_flight(seed, seed % 2 ? 300 : 4000, flight);
    for (const std::size_t most : {1u, 4u, 8u, 64u}) {
      const auto volumes = flight_volumes(flight.on_earth, most, "f");
      ASSERT_GE(volumes.size(), 1u);
      ASSERT_LE(volumes.size(), most);
      EXPECT_EQ(why_not_held(flight.on_earth, volumes, "f"), std::nullopt) << seed << ' ' << most;
    }
  }
}

// Control points that lie so near each other give outlines with edges of millimetres.
TEST(FlightVolumes, HoldFlightsThatStopAndGo) {
  Flight flight;
  Vec3 at(30, 5, 5);
  for (const Vec3& to :
       {Vec3(26.001, 26.001, 4.949), Vec3(16.999, 34.999, 4.962), Vec3(10, 70, 5)}) {
    Segment s;
    s.duration = 6;
    for (std::size_t k = 0; k < kPoints; ++k) s.point[k] = k < kPoints / 2 ? at : to;
    flight.trajectory.segments.push_back(s);
    at = to;
  }
  flight.on_earth = {{&flight.trajectory, 12.5, Vec3(1, 1, 1)},
                     "2026-05-04T06:30:00Z",
                     {37.79248, -122.39745, -10}};
  for (const std::size_t most : {1u, 2u, 5u, 12u, 64u}) {
    const auto volumes = flight_volumes(flight.on_earth, most, "f");
    EXPECT_EQ(why_not_held(flight.on_earth, volumes, "f"), std::nullopt) << most;
  }
}

// Their sides have many corners that lie all but on one line.
TEST(FlightVolumes, HoldFlightsOfStraightLegs) {
  std::mt19937_64 random(5);
  for (const double size : {20.0, 200.0, 3000.0}) {
    std::uniform_real_distribution<> across(-size, size);
    std::uniform_real_distribution<> up(20, 400);
    for (int i = 0; i < 8; ++i) {
      Flight flight;
      Vec3 at(across(random), across(random), up(random));
      for (int leg = 0; leg < 2; ++leg) {
        const Vec3 to(across(random), across(random), up(random));
        Segment s;
        s.duration = size / 5;
        for (std::size_t k = 0; k < kPoints; ++k) {
          s.point[k] = at + (to - at) * (static_cast<double>(k) / kDegree);
        }
        flight.trajectory.segments.push_back(s);
        at = s.point.back();
      }
      flight.on_earth = {
          {&flight.trajectory, 12.5, Vec3(1, 1, 1)}, "2026-05-04T06:30:00Z", kOrigin};
      for (const std::size_t most : {1u, 8u}) {
        const auto volumes = flight_volumes(flight.on_earth, most, "f");
        EXPECT_EQ(why_not_held(flight.on_earth, volumes, "f"), std::nullopt) << size << ' ' << i;
      }
    }
  }
}

TEST(FlightVolumes, HoldEveryCornerAsOthersSeeIt) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Flight flight;
    make_flight(seed, 3000, flight);
    const auto volumes = flight_volumes(flight.on_earth, 6, "f");
    const geom::GeographicFrame earth(kOrigin);
    for (const geom::Volume4d& v : volumes) {
      const double begin = geom::seconds_between(flight.on_earth.epoch, *v.start).most;
      const double end = geom::seconds_between(flight.on_earth.epoch, *v.end).least;
      for (int k = 0; k <= 40; ++k) {
        const double start = flight.on_earth.flight.start;
        const double t =
            std::clamp(begin + (end - begin) * k / 40 - start, 0.0, duration(flight.trajectory));
        const Vec3 p = evaluate(flight.trajectory, t).position;
        ASSERT_GE(p.z() - 0.3 + 200, *v.lower);
        ASSERT_LE(p.z() + 0.3 + 200, *v.upper);
        for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
          ASSERT_TRUE(inside_of_geodesics(v, earth.place(p + Vec3(x, y, 0)))) << seed << ' ' << t;
        }
      }
    }
  }
}

// Departures as skyway-fleet gives them: at tenths, thirds and thousandths of seconds.
TEST(FlightVolumes, HoldFlightsThatBeginAtFractionsOfSeconds) {
  for (int i = 0; i < 300; ++i) {
    Flight flight;
    make_flight(5, 300, flight);
    flight.on_earth.epoch = "2026-05-04T06:30:00Z";
    flight.on_earth.flight.start = i / (i % 2 ? 10.0 : 1000.0) + 12;
    for (Segment& s : flight.trajectory.segments) s.duration = std::round(s.duration * 10) / 10;
    const auto volumes = flight_volumes(flight.on_earth, 2, "f");
    ASSERT_EQ(why_not_held(flight.on_earth, volumes, "f"), std::nullopt)
        << flight.on_earth.flight.start;
  }
}

TEST(FlightVolumes, AreTight) {
  Flight flight;
  make_flight(7, 800, flight);
  double before = 1e300;
  for (const std::size_t most : {1u, 2u, 4u, 8u, 16u}) {
    const double now = total(flight.on_earth, flight_volumes(flight.on_earth, most, "f"));
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(FlightVolumes, CutAtMillisecondsOfTheCalendar) {
  Flight flight;
  make_flight(3, 300, flight);
  const auto volumes = flight_volumes(flight.on_earth, 5, "f");
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    EXPECT_LE(volumes[i].start->size(), std::string("2026-05-04T06:30:00.123Z").size());
    if (i > 0) {
      EXPECT_EQ(volumes[i].start, volumes[i - 1].end);
    }
  }
}

TEST(FlightVolumes, TakeFlightsOfAnInstantAlmost) {
  Flight flight;
  make_flight(3, 300, flight);
  flight.trajectory.segments.resize(1);
  flight.trajectory.segments[0].duration = 1e-9;
  flight.on_earth.flight.start = 0;
  const auto volumes = flight_volumes(flight.on_earth, 8, "f");
  EXPECT_EQ(volumes.size(), 1u);
  EXPECT_EQ(why_not_held(flight.on_earth, volumes, "f"), std::nullopt);
}

}  // namespace
}  // namespace traj
