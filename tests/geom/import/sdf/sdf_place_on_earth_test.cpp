#include "import/sdf/sdf_place_on_earth.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace geom {
namespace {

struct World {
  explicit World(const std::string& inside)
      : root(parse_xml("<world>" + inside + "</world>", "w")) {}
  XmlElement root;
  std::string source = "w";
  Frame frame() const { return frame_of({&root, &source}); }
  std::optional<Aabb> bounds() const { return bounds_of({&root, &source}); }
};

std::string coordinates(const std::string& more) {
  return "<spherical_coordinates><latitude_deg>47.5</latitude_deg>"
         "<longitude_deg> 8.25</longitude_deg>" +
         more + "</spherical_coordinates>";
}

TEST(SdfPlaceOnEarth, IsTheOriginOfTheFrame) {
  EXPECT_FALSE(World("").frame().origin);
  const Frame frame = World(coordinates("<surface_model>EARTH_WGS84</surface_model>"
                                        "<elevation>400</elevation><heading_deg>0</heading_deg>"))
                          .frame();
  EXPECT_EQ(frame.axes, Axes::enu);
  EXPECT_EQ(frame.origin, (GeodeticOrigin{47.5, 8.25, 400}));
}

TEST(SdfPlaceOnEarth, RefusesOtherWorldsAxesAndTurns) {
  for (const std::string& bad :
       {coordinates("<surface_model>MOON_SCS</surface_model>"),
        coordinates("<world_frame_orientation>NED</world_frame_orientation>"),
        coordinates("<heading_deg>90</heading_deg>"), coordinates("<elevation>nan</elevation>"),
        std::string("<spherical_coordinates/>"),
        std::string("<spherical_coordinates><latitude_deg>91</latitude_deg>"
                    "<longitude_deg>0</longitude_deg></spherical_coordinates>")}) {
    EXPECT_NE(support::refusal_of([&] { World(bad).frame(); }), "") << bad;
  }
}

TEST(SdfPlaceOnEarth, KeepsWhatSkywayAdds) {
  const World w("<skyway:map bounds='0 1 2 3 4 5' crs='EPSG:28992' origin='52 4 0'/>");
  EXPECT_EQ(w.bounds(), (Aabb{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(w.frame().crs, "EPSG:28992");
  EXPECT_EQ(w.frame().origin, (GeodeticOrigin{52, 4, 0}));
  EXPECT_FALSE(World("").bounds());
  for (const char* bad :
       {"bounds='0 1 2'", "bounds='3 0 0 1 1 1'", "bounds='a'", "bounds='0 0 0 1 1 nan'"}) {
    EXPECT_NE(
        support::refusal_of([&] { World(std::string("<skyway:map ") + bad + "/>").bounds(); }), "")
        << bad;
  }
  EXPECT_NE(support::refusal_of([] { World("<skyway:map origin='95 0 0'/>").frame(); }), "");
}

}  // namespace
}  // namespace geom
