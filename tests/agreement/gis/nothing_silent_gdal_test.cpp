#include <fmt/format.h>
#include <gtest/gtest.h>

#include "marked_obstacle.h"
#include "support/shape_files.h"

namespace geom::gis {
namespace {

std::string json_ring(const Obstacle& square, const std::array<double, 4>& levels, bool deep) {
  const auto corners = square.corners();
  std::string out;
  for (std::size_t i = 0; i < 5; ++i) {
    const geom::Vec2& p = corners[i % 4];
    out += deep ? fmt::format("[{:.7f},{:.7f},{}],", p.x(), p.y(), levels[i % 4])
                : fmt::format("[{:.7f},{:.7f}],", p.x(), p.y());
  }
  out.pop_back();
  return "[" + out + "]";
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\\\"" : std::string(1, c);
  return out + "\"";
}

std::string json_properties(const Tags& tags, geom::SplitMix64& random) {
  std::string out;
  for (const auto& [key, value] : tags) {
    const bool number = !value.empty() && value.find_first_not_of("0123456789.") == value.npos &&
                        value.front() != '0' && random.chance(0.5);
    out +=
        fmt::format("{}{}:{}", out.empty() ? "" : ",", quoted(key), number ? value : quoted(value));
  }
  return "{" + out + "}";
}

std::string polygon_json(const std::string& ring) {
  return fmt::format(R"({{"type":"Polygon","coordinates":[{}]}})", ring);
}

std::string feature_json(const std::string& geometry, const std::string& properties) {
  return fmt::format(R"({{"type":"Feature","properties":{},"geometry":{}}})", properties, geometry);
}

// A geometry that holds the ring, or should.
std::string geometry_json(const std::string& ring, geom::SplitMix64& random) {
  switch (random.whole(0, 12)) {
    case 0:
      return fmt::format(R"({{"type":"MultiPolygon","coordinates":[[{}]]}})", ring);
    case 1:
      return fmt::format(R"({{"type":"GeometryCollection","geometries":[{}]}})",
                         polygon_json(ring));
    case 2:
      return fmt::format(R"({{"type":"LineString","coordinates":{}}})", ring);
    case 3:
      return fmt::format(R"({{"type":"MultiPoint","coordinates":{}}})", ring);
    case 4:
      return R"({"type":"Point","coordinates":[24.9,60.1]})";
    case 5:
      return "null";
    case 6:
      return fmt::format(R"({{"type":"polygon","coordinates":[{}]}})", ring);
    case 7:
      return R"({"type":"Polygon","coordinates":[]})";
    case 8:
      return fmt::format(R"({{"type":"Curve","coordinates":[{}]}})", ring);
    case 9:
      return fmt::format(R"({{"type":"GeometryCollection","geometries":[{},{{"type":"Point",)"
                         R"("coordinates":[24.9,60.1]}}]}})",
                         polygon_json(ring));
    default:
      return polygon_json(ring);
  }
}

// The marked feature, or what somebody made of it.
std::string marked_json(Obstacle& obstacle, geom::SplitMix64& random) {
  Tags tags{{"building", "yes"}};
  for (auto& tag : height_tags(obstacle, random)) tags.push_back(tag);
  std::array<double, 4> levels{};
  const bool deep = random.chance(0.4);
  if (deep) {
    for (double& level : levels) level = random.whole(0, 60);
    if (random.chance(0.3)) levels.fill(levels[0]);
    const double low = *std::min_element(levels.begin(), levels.end());
    const double high = *std::max_element(levels.begin(), levels.end());
    if (obstacle.top) obstacle.top = *obstacle.top + high;
    obstacle.bottom = std::min(*obstacle.bottom, low);
  }
  const std::string geometry = geometry_json(json_ring(obstacle, levels, deep), random);
  const std::string properties = json_properties(tags, random);
  const std::string feature = feature_json(geometry, properties);
  switch (random.whole(0, 11)) {
    case 0:  // a key twice: the first wins, or the last
      return fmt::format(R"({{"type":"Feature","geometry":{},"properties":{},"geometry":{}}})",
                         geometry, properties,
                         polygon_json(json_ring({{10, 10}, 1, {}, {}, {}}, {}, false)));
    case 1:
      return fmt::format(R"({{"type":"Feature","properties":{},"properties":{{"height":2}},)"
                         R"("geometry":{}}})",
                         properties, geometry);
    case 2:
      return fmt::format(R"({{"type":"FeatureCollection","features":[{}]}})", feature);
    case 3:
      return fmt::format(R"({{"type":"feature","properties":{},"geometry":{}}})", properties,
                         geometry);
    default:
      return feature;
  }
}

// The members of the root before its features, and the features that the server sent.
std::string collection_json(std::vector<std::string> features, std::size_t marked,
                            geom::SplitMix64& random) {
  std::string before;
  const bool cut = random.chance(0.15);
  if (cut) {
    features.erase(features.begin() + static_cast<std::ptrdiff_t>(marked));
    const std::size_t n = features.size();
    before = any_of(
        std::array<std::string, 5>{
            R"("exceededTransferLimit":true,)", R"("properties":{"exceededTransferLimit":true},)",
            fmt::format(R"("numberMatched":{},"numberReturned":{},)", n + 1, n),
            fmt::format(R"("totalFeatures":{},)", n + 1), R"("links":[{"rel":"next"}],)"},
        random);
  }
  std::string list;
  for (const std::string& feature : features) list += (list.empty() ? "" : ",") + feature;
  if (!cut && random.chance(0.05)) {
    return fmt::format(R"({{"type":"FeatureCollection","features":[{}],"features":[{}]}})", list,
                       feature_json(polygon_json(json_ring({{10, 10}, 1, {}, {}, {}}, {}, false)),
                                    R"({"height":4})"));
  }
  return fmt::format(R"({{"type":"FeatureCollection",{}"features":[{}]}})", before, list);
}

TEST(NothingSilent, GeoJson) {
  expect_told(kFiles, [](int things, int marked, geom::SplitMix64& random) {
    Obstacle obstacle;
    std::vector<std::string> features;
    for (int k = 0; k < things; ++k) {
      const Obstacle square{place(k), 0.0002, 0, std::nullopt, false};
      if (k == marked) {
        obstacle = square;
        features.push_back(marked_json(obstacle, random));
      } else {
        features.push_back(
            feature_json(polygon_json(json_ring(square, {}, false)), R"({"height":12})"));
      }
    }
    const std::string text = collection_json(features, static_cast<std::size_t>(marked), random);
    return Told{is_told(obstacle, [&] { return read_geojson(text, {}); }), text};
  });
}

// ---- Shapefile and GeoPackage ----

std::vector<Prism> prisms(int things, int marked, Obstacle& obstacle, geom::SplitMix64& random) {
  std::vector<Prism> out;
  for (int k = 0; k < things; ++k) {
    const geom::Vec2 at(100.0 * k, 50);
    Prism prism{{at, at + geom::Vec2(9, 0), at + geom::Vec2(9, 9), at + geom::Vec2(0, 9)},
                {0, 0, 0, 0},
                12};
    if (k == marked) {
      prism.height = random.whole(4, 400) / 4.0;
      obstacle = {at, 9, 0, prism.height, false};
      if (random.chance(0.6)) {
        for (double& level : prism.levels) level = random.whole(-5, 80);
      }
      const double low = *std::min_element(prism.levels.begin(), prism.levels.end());
      const double high = *std::max_element(prism.levels.begin(), prism.levels.end());
      obstacle.bottom = std::min(low, 0.0);
      obstacle.top = high + prism.height;
    }
    out.push_back(prism);
  }
  return out;
}

// What happens to shapefiles: a row is deleted, a part is of another state of the file or is cut.
void damage(const ShapeFiles& files, int marked, geom::SplitMix64& random) {
  std::string dbf = files.dbf.read();
  std::string shx = files.shx.read();
  const auto byte = [&](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(dbf[at]));
  };
  const std::size_t row = byte(8) + 256 * byte(9) + static_cast<std::size_t>(marked) * byte(10);
  const auto entry = shx.begin() + 100 + 8 * marked;
  switch (random.whole(0, 7)) {
    case 0:
      dbf[row] = '*';
      break;
    case 1:
      dbf.erase(row, byte(10));
      dbf[4] = static_cast<char>(dbf[4] - 1);
      break;
    case 2:
      dbf.resize(row);
      break;
    case 3:
      shx.erase(entry, entry + 8);
      shx[27] = static_cast<char>(shx[27] - 4);
      break;
    case 4:
      shx.resize(static_cast<std::size_t>(entry - shx.begin()));
      break;
    case 5:
      std::copy(shx.begin() + 100, shx.begin() + 108, entry);  // the first record twice
      if (marked == 0) shx.resize(104);
      break;
    default:
      return;
  }
  files.dbf.write(dbf);
  files.shx.write(shx);
}

TEST(NothingSilent, Shapefile) {
  expect_told(kFiles, [](int things, int marked, geom::SplitMix64& random) {
    Obstacle obstacle;
    const ShapeFiles files;
    write_layer("ESRI Shapefile", files.shp.path(), prisms(things, marked, obstacle, random));
    damage(files, marked, random);
    return Told{is_told(obstacle, [&] { return read_vector(files.shp.path(), "city.shp", {}); })};
  });
}

// A tenth of the files: SQLite takes milliseconds to make one.
TEST(NothingSilent, GeoPackage) {
  expect_told(kFiles / 10, [](int things, int marked, geom::SplitMix64& random) {
    Obstacle obstacle;
    const MemoryFile file("city.gpkg");
    write_layer("GPKG", file.path(), prisms(things, marked, obstacle, random));
    return Told{is_told(obstacle, [&] { return read_vector(file.path(), "city.gpkg", {}); })};
  });
}

}  // namespace
}  // namespace geom::gis
