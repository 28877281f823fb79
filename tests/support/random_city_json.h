#pragma once

// CityJSON files and sequences with one obstacle that must not go missing.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/random_city.h"

namespace support {

class RandomCityJson {
 public:
  using Json = nlohmann::json;

  explicit RandomCityJson(std::uint64_t seed) : random_(seed) {
    scale_ = random_.below(20) == 0 ? 0 : random_.below(2) == 0 ? 0.5 : 1;
  }

  // The obstacle's roof is level, and its middle is at kMarked.
  std::string document() {
    Json out = header();
    Json objects = Json::object();
    Json vertices = Json::array();
    for (int i = random_.below(3); i > 0; --i) add_other(objects, vertices, i);
    add_marked(objects, vertices);
    out["CityObjects"] = objects;
    out["vertices"] = vertices;
    return out.dump(random_.below(2) == 0 ? -1 : 1);
  }

  std::string sequence() {
    Json first = header();
    first["CityObjects"] = Json::object();
    first["vertices"] = Json::array();
    if (seldom()) first.erase("transform");
    std::vector<Json> lines;
    for (int i = random_.below(3); i > 0; --i) {
      lines.push_back(feature());
      add_other(lines.back()["CityObjects"], lines.back()["vertices"], i);
    }
    lines.push_back(feature());
    add_marked(lines.back()["CityObjects"], lines.back()["vertices"]);
    lines.back()["id"] = seldom() ? "absent" : lines.back()["CityObjects"].items().begin().key();
    if (seldom()) lines.back()["transform"] = first.value("transform", Json::object());
    if (seldom()) std::swap(lines.front(), lines.back());
    std::string out = seldom() ? "" : first.dump() + end_of_line();
    for (const Json& line : lines) {
      if (seldom()) out += seldom() ? first.dump() + "\n" : "\n";
      out += line.dump() + end_of_line();
    }
    return out;
  }

 private:
  bool seldom() { return random_.below(12) == 0; }
  std::string end_of_line() { return random_.below(3) == 0 ? "\r\n" : "\n"; }

  Json header() {
    Json out = {{"type", "CityJSON"}, {"version", random_.below(2) == 0 ? "2.0" : "1.1"}};
    out["transform"] = {{"scale", {scale_, scale_, scale_}}, {"translate", {5000, 7000, 1}}};
    const Json last = seldom() ? Json({0, 0, 0, 2}) : Json({0, 0, 0, 1});
    matrix_ = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    for (const Json& n : last) matrix_.push_back(n);
    Json shape = {{"type", "MultiSurface"}, {"lod", "2"}, {"boundaries", {{{0, 1, 2, 3}}}}};
    if (seldom()) shape = {{"type", "MultiLineString"}, {"lod", "2"}, {"boundaries", {{0, 1}}}};
    out["geometry-templates"] = {
        {"templates", {shape}},
        {"vertices-templates", {{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}}};
    return out;
  }

  Json feature() {
    return {{"type", "CityJSONFeature"},
            {"id", "o1"},
            {"CityObjects", Json::object()},
            {"vertices", Json::array()}};
  }

  // A vertex in the file's own whole numbers.
  int vertex(Json& vertices, const geom::Vec3& at) const {
    const double scale = scale_ == 0 ? 1 : scale_;
    vertices.push_back({static_cast<int>((at.x() - 5000) / scale),
                        static_cast<int>((at.y() - 7000) / scale),
                        static_cast<int>((at.z() - 1) / scale)});
    return static_cast<int>(vertices.size()) - 1;
  }

  Json square(Json& vertices, const geom::Vec3& middle) {
    Json ring = Json::array();
    for (const auto& [dx, dy] : {std::pair{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}) {
      ring.push_back(vertex(vertices, middle + geom::Vec3(dx, dy, 0)));
    }
    return Json::array({ring});
  }

  Json geometry(Json& vertices, const geom::Vec3& middle) {
    Json surface = square(vertices, middle);
    Json out = {{"lod", random_.below(2) == 0 ? Json("2.2") : Json(2)}};
    switch (random_.below(3)) {
      case 0:
        out["type"] = "MultiSurface";
        out["boundaries"] = {surface};
        break;
      case 1:
        out["type"] = "Solid";
        out["boundaries"] = {{surface}};
        break;
      default:
        out["type"] = "CompositeSolid";
        out["boundaries"] = {{{surface}}};
        break;
    }
    return out;
  }

  void add_other(Json& objects, Json& vertices, int i) {
    objects["o" + std::to_string(i)] = {
        {"type", "Building"}, {"geometry", {geometry(vertices, {5000.0 + 20 * i, 7100, 9})}}};
  }

  Json body(Json& vertices) {
    switch (random_.below(6)) {
      case 0:
        return Json::array();
      case 1:
        return {{{"type", "GeometryInstance"},
                 {"template", 0},
                 {"boundaries", {vertex(vertices, kMarkedHere)}},
                 {"transformationMatrix", matrix_}}};
      case 2:
        return {
            geometry(vertices, {5040, 7003, 4}),
            {{"type", "MultiLineString"},
             {"lod", "2"},
             {"boundaries", {{vertex(vertices, kMarkedHere), vertex(vertices, {5003, 7003, 4})}}}}};
      case 3: {
        Json both = {geometry(vertices, {5003, 7003, 11}), geometry(vertices, kMarkedHere)};
        return both;
      }
      default:
        return {geometry(vertices, kMarkedHere)};
    }
  }

  void add_marked(Json& objects, Json& vertices) {
    const char* kinds[] = {"BuildingPart", "BuildingInstallation", "+Antenna"};
    Json marked = {{"type", kinds[random_.below(3)]}, {"parents", {"house"}}};
    marked["geometry"] = body(vertices);
    Json house = {{"type", "Building"}, {"children", {"part"}}};
    switch (random_.below(5)) {
      case 0:
        house["geometry"] = {geometry(vertices, {5040, 7003, 4})};
        break;
      case 1:
        house["geometry"] = Json::array();
        break;
      case 2:
        house["children"] = {"part", "absent"};
        break;
      default:
        break;
    }
    const int which = random_.below(6);
    if (which == 0) {  // the parts are elsewhere
      objects["house"] = house;
      return;
    }
    if (which == 1) marked = {{"type", "CityFurniture"}, {"geometry", body(vertices)}};
    if (which > 2) objects["house"] = house;
    objects["part"] = marked;
  }

  static inline const geom::Vec3 kMarkedHere{5003, 7003, 31};
  Random random_;
  double scale_;
  Json matrix_ = Json::array();
};

}  // namespace support
