#include "traj/submit/population.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "geom/base/error.h"
#include "traj/mission/airspace/volume_around.h"

namespace {

const geom::GeodeticOrigin kOrigin{47.4, 8.5, 400};
constexpr double kCell = 0.001;  // degrees

// 20 by 20 cells around the origin, the first row in the north.
traj::Population cells() {
  traj::Population out;
  for (std::size_t row = 0; row < 20; ++row) {
    for (std::size_t column = 0; column < 20; ++column) {
      const double north = 47.41 - kCell * static_cast<double>(row);
      const double west = 8.49 + kCell * static_cast<double>(column);
      out.cells.push_back({row,
                           column,
                           static_cast<double>((7 * row + 3 * column) % 11),
                           {{{north, west, 0},
                             {north, west + kCell, 0},
                             {north - kCell, west + kCell, 0},
                             {north - kCell, west, 0}}}});
    }
  }
  return out;
}

traj::RiskVolume buffer(std::vector<geom::Vec2> plan) {
  return {traj::volume_around({std::move(plan), 0, 10}, kOrigin, "test"), 10, 10};
}

TEST(Population, ComesBackAsItWasWritten) {
  traj::Population population = cells();
  population.cells[3].people.reset();
  const std::string text = traj::population_csv(population);
  std::istringstream in(text);
  EXPECT_EQ(traj::population_csv(traj::read_population(in, "p.csv")), text);
}

TEST(Population, IsRefusedWhereCellsAreMissingOrComeTwice) {
  for (const bool twice : {true, false}) {
    traj::Population population = cells();
    if (twice) {
      population.cells.push_back(population.cells.back());
    } else {
      population.cells.erase(population.cells.begin() + 5);
    }
    std::istringstream in(traj::population_csv(population));
    EXPECT_THROW(traj::read_population(in, "p.csv"), geom::InputError);
  }
  std::istringstream below(
      "row,column,people,lon,lat,lon,lat,lon,lat,lon,lat\n0,0,-1,8,47,9,47,9,48,8,48\n");
  EXPECT_THROW(traj::read_population(below, "p.csv"), geom::InputError);
}

// Each place of a buffer belongs to a cell; the people of all cells that places were found in are
// never more than those exposed.
TEST(Population, CountsEveryCellThatABufferTouches) {
  const traj::Population population = cells();
  const traj::PopulationOnMap on_map(population, kOrigin);
  const geom::GeographicFrame earth(kOrigin);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> at(-500, 500), share(0, 1);
  for (int k = 0; k < 40; ++k) {
    const geom::Vec2 a(at(random), at(random));
    const std::vector<geom::Vec2> plan{a, a + geom::Vec2(150, 10), a + geom::Vec2(40, 120)};
    const std::vector<traj::RiskVolume> buffers{buffer(plan)};
    const traj::Exposed exposed = on_map.exposed(buffers);
    EXPECT_TRUE(exposed.inside);
    std::vector<bool> found(population.cells.size());
    double people = 0;
    for (int i = 0; i < 3000; ++i) {
      double s = share(random), t = share(random);
      if (s + t > 1) s = 1 - s, t = 1 - t;
      const geom::Vec2 p = plan[0] + s * (plan[1] - plan[0]) + t * (plan[2] - plan[0]);
      const auto place = earth.place({p.x(), p.y(), 0});
      const auto row = static_cast<std::size_t>((47.41 - place.latitude) / kCell);
      const auto column = static_cast<std::size_t>((place.longitude - 8.49) / kCell);
      if (found[row * 20 + column]) continue;
      found[row * 20 + column] = true;
      people += *population.cells[row * 20 + column].people;
    }
    EXPECT_GE(exposed.people, people);
    EXPECT_LE(exposed.people, people + 60);  // neighbours that are only just touched
  }
}

TEST(Population, SaysWhenItDoesNotReachAsFarAsABuffer) {
  const traj::PopulationOnMap on_map(cells(), kOrigin);
  const std::vector<traj::RiskVolume> buffers{buffer({{0, 0}, {1500, 0}, {0, 10}})};
  EXPECT_FALSE(on_map.exposed(buffers).inside);
}

// Rows and columns of 50 m about the origin, turned; the first column begins at `from`.
traj::Population turned_cells(double angle, double from) {
  const geom::GeographicFrame earth(kOrigin);
  const geom::Vec2 along(std::cos(angle), std::sin(angle)), down(along.y(), -along.x());
  const auto corner = [&](std::size_t row, std::size_t column) {
    const geom::Vec2 p = (from + 50.0 * static_cast<double>(column)) * along +
                         50.0 * (static_cast<double>(row) - 20) * down;
    return earth.place({p.x(), p.y(), 0});
  };
  traj::Population out;
  for (std::size_t row = 0; row < 40; ++row) {
    for (std::size_t column = 0; column < 40; ++column) {
      out.cells.push_back({row,
                           column,
                           10,
                           {{corner(row, column), corner(row, column + 1),
                             corner(row + 1, column + 1), corner(row + 1, column)}}});
    }
  }
  return out;
}

// The rectangle around turned cells reaches further than they do.
TEST(Population, SaysWhenATurnedRasterEndsBelowABuffer) {
  const std::vector<traj::RiskVolume> buffers{
      buffer({{-100, -100}, {100, -100}, {100, 100}, {-100, 100}})};
  for (const double degrees : {0.0, 30.0, 45.0, 135.0, 200.0, 300.0}) {
    const double angle = degrees * M_PI / 180;
    const auto inside = [&](double from) {
      return traj::PopulationOnMap(turned_cells(angle, from), kOrigin).exposed(buffers).inside;
    };
    EXPECT_TRUE(inside(-1000)) << degrees;
    EXPECT_TRUE(inside(-150)) << degrees << ": it ends just beyond the buffer";
    EXPECT_FALSE(inside(-90)) << degrees;
    EXPECT_FALSE(inside(0)) << degrees;
    EXPECT_FALSE(inside(150)) << degrees << ": it begins beyond the buffer";
    EXPECT_FALSE(inside(-1910)) << degrees << ": it ends in the buffer";
  }
}

TEST(Population, SaysWhenCellsLeaveAGapBelowABuffer) {
  traj::Population population = turned_cells(0.3, -1000);
  const std::vector<traj::RiskVolume> buffers{buffer({{-200, -10}, {200, -10}, {200, 10}})};
  EXPECT_TRUE(traj::PopulationOnMap(population, kOrigin).exposed(buffers).inside);
  for (traj::PopulationCell& cell : population.cells) {
    if (cell.column < 20) continue;
    for (geom::GeodeticPlace& corner : cell.corners) corner.longitude += 1e-5;
  }
  EXPECT_FALSE(traj::PopulationOnMap(population, kOrigin).exposed(buffers).inside);
}

TEST(Population, CountsCellsWithoutANumberApart) {
  traj::Population population = cells();
  for (auto& cell : population.cells) cell.people.reset();
  const std::vector<traj::RiskVolume> buffers{buffer({{0, 0}, {10, 0}, {0, 10}})};
  const traj::Exposed exposed = traj::PopulationOnMap(population, kOrigin).exposed(buffers);
  EXPECT_EQ(exposed.people, 0);
  EXPECT_GE(exposed.unknown, 1u);
}

}  // namespace
