// An obstacle of a city model is built, or the reader says that it is not.

#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "geom/base/error.h"
#include "gis/city_gml.h"
#include "import/city_footprints.h"
#include "import/city_json.h"
#include "import/city_types.h"
#include "support/cases.h"
#include "support/random_city_gml.h"
#include "support/random_city_json.h"

namespace geom::gis {
namespace {

enum class Fate { built, told, silent };

bool covers(const geom::Footprint& f, const geom::Vec3& p) {
  geom::Vec2 low = f.polygon.outer.at(0);
  geom::Vec2 high = low;
  for (const geom::Vec2& corner : f.polygon.outer) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const bool over =
      (low.array() <= p.head<2>().array()).all() && (high.array() >= p.head<2>().array()).all();
  return over && f.bottom <= p.z() && f.top >= p.z() - 1e-6;
}

using Read = std::function<geom::CityModel(std::istream&)>;

Fate fate_of(const std::string& text, const Read& read) {
  std::istringstream in(text);
  try {
    geom::CityModel model = read(in);
    geom::leave_out(model, {}, 1);  // of what lies on the ground, and so never of the marked one
    const geom::CityFootprints city = geom::footprints_of(model, 1, {});
    if (!city.skipped.empty()) return Fate::told;
    const bool built =
        std::any_of(city.footprints.begin(), city.footprints.end(),
                    [](const geom::Footprint& f) { return covers(f, support::kMarked); });
    return built ? Fate::built : Fate::silent;
  } catch (const geom::InputError&) {
    return Fate::told;
  }
}

void expect_none_silent(const std::function<std::string(std::uint64_t)>& make, const Read& read) {
  std::map<Fate, int> count;
  const int all = support::cases(10000);
  for (int seed = 0; seed < all && count[Fate::silent] < 3; ++seed) {
    const std::string text = make(static_cast<std::uint64_t>(seed));
    const Fate fate = fate_of(text, read);
    ++count[fate];
    EXPECT_NE(fate, Fate::silent) << "seed " << seed << ":\n" << text;
  }
  EXPECT_GT(count[Fate::built], all / 10);
  EXPECT_GT(count[Fate::told], all / 10);
}

geom::CityModel json(std::istream& in) { return geom::read_city_json(in, "t"); }

TEST(CityProperty, NoObstacleOfCityGmlIsSilentlyLeftOut) {
  expect_none_silent([](std::uint64_t seed) { return support::RandomCityGml(seed).text(); },
                     [](std::istream& in) { return read_city_gml(in, "t", "").model; });
}

TEST(CityProperty, NoObstacleOfCityJsonIsSilentlyLeftOut) {
  expect_none_silent([](std::uint64_t seed) { return support::RandomCityJson(seed).document(); },
                     json);
}

TEST(CityProperty, NoObstacleOfASequenceIsSilentlyLeftOut) {
  expect_none_silent([](std::uint64_t seed) { return support::RandomCityJson(seed).sequence(); },
                     json);
}

}  // namespace
}  // namespace geom::gis
