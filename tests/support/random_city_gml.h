#pragma once

// Valid and less valid CityGML files with one obstacle that must not go missing.

#include <string>
#include <vector>

#include "support/random_city.h"

namespace support {

// The obstacle's roof is level, and its middle is here.
inline const geom::Vec3 kMarked{5003, 7003, 31};

class RandomCityGml {
 public:
  explicit RandomCityGml(std::uint64_t seed) : random_(seed) {
    three_ = random_.below(2) == 0;
    core_ = pick({"", "core:", "c:"});
    gml_ = pick({"gml:", "g:"});
  }

  std::string text() {
    std::string members;
    const int before = random_.below(3);
    for (int i = 0; i < before; ++i) members += member(other(i));
    members += marked();
    if (random_.below(2) == 0) members += member(other(7));
    for (const std::string& later : later_) members += later;
    return head() + "<" + core_ + "CityModel" + namespaces() + ">" + aside() + members + "</" +
           core_ + "CityModel>\n";
  }

 private:
  std::string pick(const std::vector<std::string>& words) {
    return words[static_cast<std::size_t>(random_.below(static_cast<int>(words.size())))];
  }
  bool seldom() { return random_.below(8) == 0; }

  std::string head() {
    std::string out = seldom() ? "" : "<?xml version='1.0' encoding='UTF-8'?>\n";
    if (!entity_.empty()) out += "<!DOCTYPE x " + entity_ + ">\n";
    return out + aside();
  }

  std::string namespaces() {
    const std::string base = "http://www.opengis.net/citygml/";
    const std::string version = three_ ? "3.0" : pick({"2.0", "1.0"});
    const auto space = [](const std::string& prefix, const std::string& uri) {
      return " xmlns" + (prefix.empty() ? "" : ":" + prefix.substr(0, prefix.size() - 1)) + "='" +
             uri + "'";
    };
    return space(core_, base + version) + space("b:", base + "building/" + version) +
           space("con:", base + "construction/3.0") + space("gen:", base + "generics/" + version) +
           space("grp:", base + "cityobjectgroup/" + version) + space("ade:", "http://own") +
           space(gml_, three_ ? "http://www.opengis.net/gml/3.2" : "http://www.opengis.net/gml") +
           space("xlink:", "http://www.w3.org/1999/xlink") +
           space("xi:", "http://www.w3.org/2001/XInclude");
  }

  std::string aside() { return pick({"", "", "", "<!-- a <b> c -->", "<?do it?>", "\n  "}); }

  std::string element(const std::string& name, const std::string& inside,
                      const std::string& attributes = "") {
    return "<" + name + attributes + ">" + aside() + inside + "</" + name + ">";
  }
  std::string id(const std::string& is) { return " " + gml_ + "id='" + is + "'"; }
  static std::string link(const std::string& name, const std::string& to) {
    return "<" + name + " xlink:href='" + to + "'/>";
  }

  std::string member(const std::string& object) {
    return element(core_ + "cityObjectMember", object);
  }

  // A level square of 6 m, in one of the ways to write it.
  std::string points(const geom::Vec3& middle) {
    const double d[5][2] = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}, {-3, -3}};
    const int form = random_.below(3);
    std::string out;
    for (const auto& [dx, dy] : d) {
      const auto number = [](double v) { return std::to_string(v).substr(0, 7); };
      const std::string x = number(middle.x() + dx);
      const std::string y = number(middle.y() + dy);
      const std::string z = number(middle.z());
      if (form == 0) out += x + " " + y + aside() + " " + z + " ";
      if (form == 1) out += element(gml_ + "pos", x + " " + y + " " + z);
      if (form == 2) out += x + "," + y + "," + z + " ";
    }
    if (form == 1) return out;
    if (seldom()) out = "<![CDATA[" + plain(out) + "]]>";
    return "<" + gml_ + (form == 0 ? "posList>" : "coordinates>") + out + "</" + gml_ +
           (form == 0 ? "posList>" : "coordinates>");
  }

  // Without comments and instructions, which CDATA would take for text.
  static std::string plain(std::string text) {
    for (std::size_t at = 0; (at = text.find('<')) != text.npos;) {
      text.erase(at,
                 text.find('>', text.find("?>", at) < text.find("-->", at) ? text.find("?>", at)
                                                                           : text.find("-->", at)) +
                     1 - at);
    }
    return text;
  }

  std::string polygon(const geom::Vec3& middle, const std::string& with = "") {
    const std::string kind = pick({"Polygon", "Polygon", "Polygon", "Polygon"});
    std::string ring = element(gml_ + "LinearRing", points(middle));
    if (seldom()) {
      ring = element(gml_ + "Ring",
                     element(gml_ + "curveMember",
                             element(gml_ + pick({"LineString", "ArcString"}), points(middle))));
    }
    return element(gml_ + kind, element(gml_ + "exterior", ring), with);
  }

  std::string surface_member(const std::string& inside) {
    return element(gml_ + "surfaceMember", inside);
  }

  // Many surfaces: those given as members, and noise.
  std::string shape(const std::string& members) {
    const std::string kind =
        pick({"MultiSurface", "CompositeSurface", "Solid", "MultiGeometry", "Surface"});
    if (kind == "Solid") {
      return element(
          gml_ + kind,
          element(gml_ + "exterior", element(gml_ + pick({"CompositeSurface", "Shell"}), members)));
    }
    if (kind != "Surface") return element(gml_ + kind, members);
    return element(gml_ + "MultiSurface",
                   surface_member(element(gml_ + "CompositeSurface", members)));
  }

  // The square of the obstacle as a member of a shape: there, linked to, or hidden.
  std::string marked_member(const geom::Vec3& at) {
    const std::string name = "p" + std::to_string(random_.below(100));
    switch (random_.below(9)) {
      case 0: {  // it stands in another object
        const std::string surface = lod(2, shape(surface_member(polygon(at, id(name)))));
        later_.push_back(member(building("later", surface)));
        return link(gml_ + "surfaceMember", "#" + name);
      }
      case 1:
        return link(gml_ + "surfaceMember", pick({"#nowhere", "other.gml#p", "#"}));
      case 2: {  // two of a name
        later_.push_back(
            member(building("twice", lod(2, shape(surface_member(polygon({1, 2, 3}, id(name))))))));
        later_.push_back(member(
            building("twice2", lod(2, shape(surface_member(polygon({1, 2, 4}, id(name))))))));
        return link(gml_ + "surfaceMember", "#" + name);
      }
      case 3:
        return element(gml_ + "surfaceMember", element(gml_ + "OrientableSurface",
                                                       element(gml_ + "baseSurface", polygon(at))));
      case 4:
        return surface_member(element(
            gml_ + "Surface",
            element(gml_ + "patches", pick({patch(at), element(gml_ + "Cylinder", points(at))}))));
      case 5:
        return hidden(surface_member(polygon(at)));
      default:
        return surface_member(polygon(at));
    }
  }

  std::string patch(const geom::Vec3& at) {
    return element(gml_ + "PolygonPatch",
                   element(gml_ + "exterior", element(gml_ + "LinearRing", points(at))));
  }

  // Behind an entity or an inclusion.
  std::string hidden(const std::string& part) {
    switch (random_.below(4)) {
      case 0:
        entity_ = "[<!ENTITY rest SYSTEM 'rest.xml'>]";
        return "&rest;";
      case 1:
        entity_ = "SYSTEM 'x.dtd'";
        return "&rest;";
      case 2:
        if (part.find('"') != part.npos || part.find('%') != part.npos) return part;
        entity_ = "[<!ENTITY rest \"" + part + "\">]";
        return "&rest;";
      default:
        return "<xi:include href='rest.xml'/>";
    }
  }

  std::string lod(int n, const std::string& geometry) {
    const std::string name = (three_ ? core_ : std::string("b:")) + "lod" + std::to_string(n) +
                             pick({"MultiSurface", "Solid", "Geometry"});
    return element(name, geometry);
  }

  std::string building(const std::string& is, const std::string& inside) {
    return element("b:Building", inside, id(is));
  }

  std::string other(int i) {
    const geom::Vec3 at{100.0 + 20 * i, 100, 9};
    std::string inside;
    if (seldom()) inside += address();
    inside += lod(1 + random_.below(3), shape(surface_member(polygon(at))));
    return building("o" + std::to_string(i), inside);
  }

  std::string address() {
    return element("b:address", element(core_ + "Address", element("ade:street", "Lane 7")));
  }

  // What shows the obstacle, within an object.
  std::string drawn() {
    const std::string all = marked_member(kMarked);
    const std::string more =
        random_.below(2) == 0 ? surface_member(polygon(kMarked - geom::Vec3(0, 0, 20))) : "";
    switch (random_.below(6)) {
      case 0:
        return bounded(lod(2, shape(all)));
      case 1:
        return placed();
      case 2:
        return lod(3, shape(more + all));
      case 3:
        return lod(2, shape(surface_member(polygon({5040, 7003, 4})) + all));
      default:
        return lod(1 + random_.below(3), shape(all + more));
    }
  }

  std::string bounded(const std::string& inside) {
    const std::string type = std::string(three_ ? "con:" : "b:") +
                             pick({"RoofSurface", "WallSurface", "OuterCeilingSurface"});
    const std::string property = three_ ? core_ + "boundary" : "b:boundedBy";
    const std::string ground =
        element(property, element(std::string(three_ ? "con:" : "b:") + "GroundSurface",
                                  lod(2, shape(surface_member(polygon({5003, 7003, 1}))))));
    if (random_.below(3) > 0) return ground + element(property, element(type, inside));
    const std::string name = "bound";
    if (random_.below(2) == 0) return ground + link(property, "far.gml#" + name);
    later_.push_back(
        pick({member(element(type, inside, id(name))),
              member(building("q", element(property, element(type, inside, id(name)))))}));
    return ground + link(property, "#" + name);
  }

  std::string placed() {
    const std::string matrix =
        pick({"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
              "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2", "1 0 0 0"});
    const std::string relative =
        element(core_ + (three_ ? "relativeGeometry" : "relativeGMLGeometry"),
                pick({shape(surface_member(polygon({0, 0, 0}))), line({0, 0, 0}), ""}));
    const std::string here = element(
        core_ + "referencePoint", element(gml_ + "Point", element(gml_ + "pos", "5003 7003 31")));
    return element((three_ ? core_ : std::string("b:")) + "lod2ImplicitRepresentation",
                   element(core_ + "ImplicitGeometry",
                           element(core_ + "transformationMatrix", matrix) + relative + here));
  }

  std::string line(const geom::Vec3& at) {
    return element(
        gml_ + "LineString",
        element(gml_ + "posList", std::to_string(at.x()) + " " + std::to_string(at.y()) + " 0 " +
                                      std::to_string(at.x()) + " " + std::to_string(at.y()) + " " +
                                      std::to_string(at.z() + 1)));
  }

  // An object or part that has surfaces, lines, or nothing at all.
  std::string body() {
    switch (random_.below(8)) {
      case 0:
        return "";
      case 1:
        return element((three_ ? core_ : std::string("b:")) + "lod2MultiCurve",
                       element(gml_ + "MultiCurve", element(gml_ + "curveMember", line(kMarked))));
      case 2:
        return lod(2, element(gml_ + "MultiGeometry",
                              element(gml_ + "geometryMember", polygon({5003, 7003, 4})) +
                                  element(gml_ + "geometryMember", line(kMarked))));
      default:
        return drawn();
    }
  }

  std::string part() {
    const std::string type =
        pick({"b:BuildingPart", "b:BuildingInstallation", "b:BuildingConstructiveElement"});
    return element(type, body(), id("part"));
  }

  std::string marked() {
    const std::string own = lod(2, shape(surface_member(polygon({5040, 7003, 4}))));
    const std::string property =
        pick({"b:consistsOfBuildingPart", "b:outerBuildingInstallation", "b:buildingPart"});
    switch (random_.below(9)) {
      case 0:
        return member(building("m", own + element(property, part())));
      case 1: {  // a part by link
        if (random_.below(2) == 0) return member(building("m", own + link(property, "#none")));
        later_.push_back(member(part()));
        return member(building("m", pick({own, ""}) + link(property, "#part")));
      }
      case 2:
        return member(element("gen:GenericCityObject", body()));
      case 3:
        return element(
            core_ + "cityObjectMember",
            element("grp:CityObjectGroup", element("grp:groupMember", building("m", body()))));
      case 4:
        return link(core_ + "cityObjectMember", pick({"#none", "rest.gml#m"}));
      case 5:
        return hidden(member(building("m", drawn())));
      case 6: {  // of another's module, coarser than what it stands on
        const std::string mast =
            element("ade:Mast", element("ade:lod1Solid", shape(surface_member(polygon(kMarked)))));
        const std::string roof =
            lod(3, shape(surface_member(polygon(kMarked - geom::Vec3(0, 0, 1))) +
                         surface_member(polygon(kMarked - geom::Vec3(0, 0, 30)))));
        return member(building("m", roof + element("ade:carries", mast)));
      }
      case 7:
        return element("ade:treeMember", element("ade:Tree", drawn()));
      default:
        return member(building("m", address() + body()));
    }
  }

  Random random_;
  bool three_;
  std::string core_;
  std::string gml_;
  std::string entity_;
  std::vector<std::string> later_;
};

}  // namespace support
