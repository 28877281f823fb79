#include "traj/export/geo_line.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <istream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>

#include "geom/error.h"
#include "geom/io/markup.h"
#include "geom/io/parse_json.h"
#include "geom/io/record.h"

namespace traj {
namespace {

std::string coordinates(const geom::GeodeticPlace& p) {
  return fmt::format("{:.9f},{:.9f},{:.4f}", p.longitude, p.latitude, p.height);
}

std::string all_of(std::istream& in) { return {std::istreambuf_iterator<char>(in), {}}; }

[[noreturn]] void refuse(std::string_view source, const std::string& message) {
  throw geom::InputError(source, message);
}

geom::GeodeticPlace place_of(double longitude, double latitude, double height,
                             std::string_view source) {
  if (!(std::abs(longitude) <= 180) || !(std::abs(latitude) <= 90) ||
      !(std::abs(height) <= geom::kLargestCoordinate)) {
    refuse(source, fmt::format("expected longitude, latitude and height, found {},{},{}", longitude,
                               latitude, height));
  }
  return {latitude, longitude, height};
}

geom::GeodeticPlace parse_tuple(std::string_view text, std::string_view source) {
  double value[3];
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [rest, error] = std::from_chars(at, end, value[i]);
    const bool last = i == 2;
    if (error != std::errc() || (last ? rest != end : rest == end || *rest != ',')) {
      refuse(source,
             fmt::format("expected longitude,latitude,height, found \"{}\"", text.substr(0, 60)));
    }
    at = rest + 1;
  }
  return place_of(value[0], value[1], value[2], source);
}

}  // namespace

void write_kml(std::ostream& out, const GeoLine& line) {
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n<Placemark>\n"
      << "<name>" << geom::escaped_markup(line.name) << "</name>\n";
  if (!line.note.empty())
    out << "<description>" << geom::escaped_markup(line.note) << "</description>\n";
  out << "<Style><LineStyle><color>ff0066ff</color><width>3</width></LineStyle></Style>\n"
         "<LineString>\n<altitudeMode>absolute</altitudeMode>\n<coordinates>\n";
  for (const geom::GeodeticPlace& p : line.points) out << coordinates(p) << '\n';
  out << "</coordinates>\n</LineString>\n</Placemark>\n</Document>\n</kml>\n";
}

void write_geojson(std::ostream& out, const GeoLine& line) {
  std::string text = R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{)";
  text += "\"name\":";
  geom::append_json(text, std::string_view(line.name));
  if (!line.note.empty()) {
    text += ",\"note\":";
    geom::append_json(text, std::string_view(line.note));
  }
  text += R"(},"geometry":{"type":"LineString","coordinates":[)";
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    text += (i ? ",\n[" : "\n[") + coordinates(line.points[i]) + ']';
  }
  out << text << "]}}]}\n";
}

std::vector<geom::GeodeticPlace> read_kml(std::istream& in, std::string_view source) {
  constexpr std::string_view kOpen = "<coordinates>";
  const std::string text = all_of(in);
  const std::size_t line = text.find("<LineString");
  const std::size_t open = line == text.npos ? text.npos : text.find(kOpen, line);
  const std::size_t close = open == text.npos ? text.npos : text.find("</coordinates>", open);
  if (close == text.npos) refuse(source, "expected a LineString with coordinates, found none");
  std::string_view rest(text.data() + open + kOpen.size(), close - open - kOpen.size());
  constexpr std::string_view kSpace = " \t\r\n";
  std::vector<geom::GeodeticPlace> points;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kSpace), rest.size()));
    if (rest.empty()) break;
    const std::size_t stop = std::min(rest.find_first_of(kSpace), rest.size());
    points.push_back(parse_tuple(rest.substr(0, stop), source));
    rest.remove_prefix(stop);
  }
  if (points.empty()) refuse(source, "expected a LineString with coordinates, found none");
  return points;
}

std::vector<geom::GeodeticPlace> read_geojson(std::istream& in, std::string_view source) {
  std::vector<geom::GeodeticPlace> points;
  const nlohmann::json json = geom::parse_json(in, source);
  try {
    for (const nlohmann::json& feature : json.at("features")) {
      const nlohmann::json& geometry = feature.at("geometry");
      if (geometry.at("type") != "LineString") continue;
      for (const nlohmann::json& p : geometry.at("coordinates")) {
        points.push_back(place_of(p.at(0), p.at(1), p.at(2), source));
      }
      break;
    }
  } catch (const nlohmann::json::exception&) {
    refuse(source,
           "expected GeoJSON features with a LineString of [longitude, latitude, height], found "
           "other keys or values");
  }
  if (points.empty()) refuse(source, "expected GeoJSON with a LineString, found none");
  return points;
}

}  // namespace traj
