#include "gis/city_gml.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "import/city_footprints.h"
#include "support/reading.h"

namespace geom::gis {
namespace {

using support::says;

std::string document(const std::string& members, const std::string& version = "2.0") {
  return "<CityModel xmlns='http://www.opengis.net/citygml/" + version +
         "' xmlns:bldg='http://www.opengis.net/citygml/building/2.0' "
         "xmlns:gml='http://www.opengis.net/gml' xmlns:xlink='http://www.w3.org/1999/xlink' "
         "xmlns:gen='http://www.opengis.net/citygml/generics/2.0'>" +
         members + "</CityModel>";
}

std::string member(const std::string& object) {
  return "<cityObjectMember>" + object + "</cityObjectMember>";
}

std::string ring(const std::string& points) {
  return "<gml:exterior><gml:LinearRing>" + points + "</gml:LinearRing></gml:exterior>";
}

std::string polygon(const std::string& points, const std::string& id = "") {
  return "<gml:Polygon" + (id.empty() ? "" : " gml:id='" + id + "'") + ">" +
         ring("<gml:posList>" + points + "</gml:posList>") + "</gml:Polygon>";
}

std::string surfaces(const std::string& members) {
  return "<gml:MultiSurface><gml:surfaceMember>" + members +
         "</gml:surfaceMember></gml:MultiSurface>";
}

const std::string kRoof = "0 0 5 9 0 5 9 9 8 0 9 8 0 0 5";

std::string building(const std::string& inside) {
  return "<bldg:Building gml:id='b'>" + inside + "</bldg:Building>";
}

std::string lod(int n, const std::string& geometry) {
  const std::string name = "bldg:lod" + std::to_string(n) + "MultiSurface";
  return "<" + name + ">" + geometry + "</" + name + ">";
}

CityGml read(const std::string& text, const std::string& attribute = "") {
  return read_city_gml(support::Text(text), "city", attribute);
}

std::string refusal_of(const std::string& text) {
  return support::refusal_of([&] { read(text); });
}

TEST(CityGml, TakesSurfacesByLevelOfDetail) {
  const CityGml city = read(document(member(building(
      lod(1, surfaces(polygon("0 0 0 9 0 0 9 9 0"))) + lod(2, surfaces(polygon(kRoof)))))));
  ASSERT_EQ(city.model.objects.size(), 1u);
  const geom::CityObject& object = city.model.objects[0];
  EXPECT_EQ(object.type, "Building");
  EXPECT_EQ(object.name, "b");
  ASSERT_EQ(object.geometries.size(), 2u);
  EXPECT_EQ(object.geometries[1].lod, 2);
  EXPECT_EQ(object.geometries[1].surfaces[0][0][2], geom::Vec3(9, 9, 8));
}

TEST(CityGml, FollowsLinksForwardAndBack) {
  const std::string link =
      "<gml:Solid><gml:exterior><gml:CompositeSurface>"
      "<gml:surfaceMember xlink:href='#roof'/></gml:CompositeSurface>"
      "</gml:exterior></gml:Solid>";
  const std::string roof = "<bldg:boundedBy><bldg:RoofSurface>" +
                           lod(2, surfaces(polygon(kRoof, "roof"))) +
                           "</bldg:RoofSurface></bldg:boundedBy>";
  const std::string solid = "<bldg:lod2Solid>" + link + "</bldg:lod2Solid>";
  for (const std::string& text : {solid + roof, roof + solid}) {
    const CityGml city = read(document(member(building(text))));
    ASSERT_EQ(city.model.objects[0].geometries.size(), 1u);  // the same polygon
    EXPECT_EQ(city.model.objects[0].geometries[0].surfaces.size(), 1u);
    EXPECT_TRUE(city.model.skipped.empty());
  }
  EXPECT_EQ(read(document(member(building(solid)))).model.skipped.count(), 1u);
  EXPECT_EQ(
      read(document(member(building(solid + roof)) + member(building(roof)))).model.skipped.count(),
      1u);
}

TEST(CityGml, AShapeThatLinksToItselfEnds) {
  const std::string loop =
      "<gml:MultiSurface gml:id='m'><gml:surfaceMember xlink:href='#m'/><gml:surfaceMember>" +
      polygon(kRoof) + "</gml:surfaceMember></gml:MultiSurface>";
  EXPECT_EQ(
      read(document(member(building(lod(2, loop))))).model.objects[0].geometries[0].surfaces.size(),
      1u);
}

TEST(CityGml, ReadsEveryWayToWriteARing) {
  const std::string pos =
      "<gml:pos>0 0 5</gml:pos><gml:pos>9 0 5</gml:pos><gml:pos>9 9 8</gml:pos>";
  const std::string commas = "<gml:coordinates>0,0,5 9,0,5 9,9,8</gml:coordinates>";
  const std::string odd =
      "<gml:coordinates cs=';' ts='|' decimal=','>0;0;5|9,0;0;5|9;9;8</gml:coordinates>";
  for (const std::string& points : {pos, commas, odd}) {
    const CityGml city = read(document(
        member(building(lod(2, surfaces("<gml:Polygon>" + ring(points) + "</gml:Polygon>"))))));
    EXPECT_EQ(city.model.objects[0].geometries[0].surfaces[0][0].at(2), geom::Vec3(9, 9, 8))
        << points;
  }
}

TEST(CityGml, KeepsHolesApart) {
  const std::string hole = "<gml:Polygon>" + ring("<gml:posList>0 0 5 9 0 5 9 9 5</gml:posList>") +
                           "<gml:interior><gml:LinearRing><gml:posList>5 1 5 6 1 5 6 2 5"
                           "</gml:posList></gml:LinearRing></gml:interior></gml:Polygon>";
  const CityGml city = read(document(member(building(lod(2, surfaces(hole))))));
  EXPECT_EQ(city.model.objects[0].geometries[0].surfaces[0].size(), 2u);
}

TEST(CityGml, PlacesImplicitGeometries) {
  const std::string text = member(
      "<gen:GenericCityObject><gen:lod1ImplicitRepresentation><ImplicitGeometry>"
      "<transformationMatrix>2 0 0 1 0 2 0 0 0 0 3 0 0 0 0 1</transformationMatrix>"
      "<relativeGMLGeometry>" +
      surfaces(polygon("0 0 0 1 0 0 1 1 2")) +
      "</relativeGMLGeometry>"
      "<referencePoint><gml:Point><gml:pos>100 200 5</gml:pos></gml:Point></referencePoint>"
      "</ImplicitGeometry></gen:lod1ImplicitRepresentation></gen:GenericCityObject>");
  const CityGml city = read(document(text));
  EXPECT_TRUE(city.placed);
  EXPECT_EQ(city.model.objects[0].geometries.at(0).surfaces[0][0][2], geom::Vec3(103, 202, 11));
  const CityGml elsewhere = read(document(member(
      "<gen:GenericCityObject><gen:lod1ImplicitRepresentation><ImplicitGeometry>"
      "<libraryObject>tree.obj</libraryObject></ImplicitGeometry></gen:lod1ImplicitRepresentation>"
      "</gen:GenericCityObject>")));
  EXPECT_TRUE(says(elsewhere.model.skipped.text(), "another file"));
}

TEST(CityGml, RefusesAReferencePointInAnotherSystem) {
  const auto placed = [](const std::string& srs) {
    return document(
        "<gml:boundedBy><gml:Envelope srsName='EPSG:25832'/></gml:boundedBy>" +
        member("<gen:GenericCityObject><gen:lod1ImplicitRepresentation><ImplicitGeometry>"
               "<transformationMatrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</transformationMatrix>"
               "<relativeGMLGeometry>" +
               surfaces(polygon(kRoof)) +
               "</relativeGMLGeometry><referencePoint><gml:Point srsName='" + srs +
               "'><gml:pos>1 2 5</gml:pos></gml:Point></referencePoint></ImplicitGeometry>"
               "</gen:lod1ImplicitRepresentation></gen:GenericCityObject>"));
  };
  EXPECT_EQ(refusal_of(placed("EPSG:25832")), "");
  EXPECT_TRUE(says(refusal_of(placed("EPSG:2056")), "one coordinate reference system"));
}

TEST(CityGml, KeepsHeightsWithTheirUnit) {
  const std::string text = document(member(building(
      "<gen:measureAttribute name='ridge'><gen:value uom='m'>7</gen:value></gen:measureAttribute>"
      "<bldg:measuredHeight uom='urn:adv:uom:ft'>\n 20 \n</bldg:measuredHeight>"
      "<bldg:storeysAboveGround>2</bldg:storeysAboveGround>" +
      lod(2, surfaces(polygon(kRoof))))));
  const auto attributes = read(text, "ridge").model.objects[0].attributes;
  EXPECT_EQ(attributes.at("measuredHeight"), "20 ft");
  EXPECT_EQ(attributes.at("storeysAboveGround"), "2");
  EXPECT_EQ(attributes.at("ridge"), "7 m");
  EXPECT_EQ(read(text).model.objects[0].attributes.count("ridge"), 0u);
}

TEST(CityGml, KeepsAllHeightsOfOneName) {
  const auto generic = [](const std::string& name, const std::string& value) {
    return "<gen:measureAttribute name='" + name + "'><gen:value uom='m'>" + value +
           "</gen:value></gen:measureAttribute>";
  };
  const std::string text =
      document(member(building(generic("Ridge", "50") + generic("ridge", "7") +
                               "<bldg:measuredHeight uom='m'>50</bldg:measuredHeight>"
                               "<bldg:measuredHeight uom='m'>3</bldg:measuredHeight>" +
                               lod(2, surfaces(polygon(kRoof))))));
  const auto attributes = read(text, "RIDGE").model.objects[0].attributes;
  EXPECT_EQ(attributes.at("RIDGE"), "50 m;7 m");
  EXPECT_EQ(attributes.at("measuredHeight"), "50 m;3 m");
}

TEST(CityGml, PartsBelongToTheirBuilding) {
  const CityGml city =
      read(document(member(building("<bldg:consistsOfBuildingPart><bldg:BuildingPart>" +
                                    lod(2, surfaces(polygon(kRoof))) +
                                    "</bldg:BuildingPart></bldg:consistsOfBuildingPart>")) +
                    member(building(lod(2, surfaces(polygon(kRoof)))))));
  ASSERT_EQ(city.model.objects.size(), 3u);
  EXPECT_TRUE(city.model.objects[0].has_parts);
  EXPECT_TRUE(city.model.objects[1].is_part);
  EXPECT_EQ(city.model.objects[1].whole, city.model.objects[0].whole);
  EXPECT_NE(city.model.objects[2].whole, city.model.objects[0].whole);
}

TEST(CityGml, SkipsWhatItCannotBuild) {
  const auto skipped = [](const std::string& geometry) {
    return read(document(member(building(lod(2, surfaces(geometry)))))).model.skipped.text();
  };
  EXPECT_TRUE(says(skipped("<gml:Polygon>" + ring("<gml:pos>0 0</gml:pos><gml:pos>9 0</gml:pos>") +
                           "</gml:Polygon>"),
                   "without heights"));
  EXPECT_TRUE(
      says(skipped("<gml:Polygon><gml:exterior><gml:Ring><gml:curveMember><gml:Curve><gml:segments>"
                   "<gml:Arc><gml:posList>0 0 1 1 1 1 2 0 1</gml:posList></gml:Arc></gml:segments>"
                   "</gml:Curve></gml:curveMember></gml:Ring></gml:exterior></gml:Polygon>"),
           "curves"));
  EXPECT_TRUE(says(skipped("<gml:Polygon/>"), "without corners"));
  // A terrain that is only said to be, and the area that it is said of.
  const CityGml relief = read(document(
      member("<TINRelief><extent>" + polygon(kRoof) +
             "</extent><tin><gml:Tin><gml:controlPoint><gml:posList>"
             "0 0 0 9 0 0 9 9 9</gml:posList></gml:controlPoint></gml:Tin></tin></TINRelief>")));
  EXPECT_EQ(geom::footprints_of(relief.model, 1, {}).skipped.count(), 1u);
}

TEST(CityGml, RefusesWhatWouldMislead) {
  const auto with = [](const std::string& points) {
    return refusal_of(document(member(building(lod(2, surfaces(polygon(points)))))));
  };
  EXPECT_TRUE(says(with("0 0 5 9 0 5 9 9"), "expected numbers by 3"));
  EXPECT_TRUE(says(with("0 0 5 9 0 nan 9 9 8"), "expected numbers by 3"));
  EXPECT_TRUE(says(with("0 0 5 9 0 1e300 9 9 8"), "within 1e8"));
  EXPECT_TRUE(says(refusal_of(document("", "4.0")), "CityGML 1.0 to 3.0"));
  EXPECT_TRUE(says(refusal_of("<gpx/>"), "CityGML 1.0 to 3.0"));
  const std::string whole = document(member(building(lod(2, surfaces(polygon(kRoof))))));
  EXPECT_TRUE(says(refusal_of(whole.substr(0, whole.size() / 2)), "may be cut"));
  EXPECT_TRUE(
      says(refusal_of(document("<a srsName='EPSG:1'/><a srsName='EPSG:2'/>")), "expected one"));
}

std::string part_in(const std::string& id, const std::string& inside) {
  return "<bldg:BuildingPart gml:id='" + id + "'>" + inside + "</bldg:BuildingPart>";
}

const std::string kFloor = polygon("0 0 1 9 0 1 9 9 1 0 9 1");

TEST(CityGml, FollowsLinksToParts) {
  const std::string house =
      member(building(lod(2, surfaces(kFloor)) + "<bldg:consistsOfBuildingPart xlink:href='#p'/>"));
  const std::string part = member(part_in("p", lod(2, surfaces(polygon(kRoof)))));
  for (const std::string& text : {house + part, part + house}) {
    const CityGml city = read(document(text));
    ASSERT_EQ(city.model.objects.size(), 2u);
    EXPECT_EQ(city.model.objects[0].whole, city.model.objects[1].whole);
    EXPECT_TRUE(city.model.skipped.empty());
    // The part stands on the lowest ground of the house.
    for (const auto& f : geom::footprints_of(city.model, 1, {}).footprints) EXPECT_EQ(f.bottom, 1);
  }
}

TEST(CityGml, FollowsLinksToBoundaries) {
  const std::string roof =
      "<bldg:RoofSurface gml:id='r'>" + lod(2, surfaces(polygon(kRoof))) + "</bldg:RoofSurface>";
  const std::string house =
      member(building(lod(2, surfaces(kFloor)) + "<bldg:boundedBy xlink:href='#r'/>"));
  const std::string next = member("<bldg:Building>" + lod(2, surfaces(kFloor)) +
                                  "<bldg:boundedBy>" + roof + "</bldg:boundedBy></bldg:Building>");
  const CityGml shared = read(document(house + next));
  EXPECT_EQ(shared.model.objects[0].geometries.size(), 2u);
  const CityGml alone = read(document(house + member(roof)));
  EXPECT_EQ(alone.model.objects[0].whole, alone.model.objects[1].whole);
}

TEST(CityGml, CountsLinksThatLeadNowhere) {
  const std::string own = lod(2, surfaces(kFloor));
  for (const char* property :
       {"bldg:consistsOfBuildingPart", "bldg:boundedBy", "bldg:outerBuildingInstallation",
        "bldg:interiorRoom", "gen:somethingElse"}) {
    for (const char* target : {"#none", "other.gml#p", "#"}) {
      const std::string link = std::string("<") + property + " xlink:href='" + target + "'/>";
      EXPECT_EQ(read(document(member(building(own + link)))).model.skipped.count(), 1u) << link;
    }
  }
  EXPECT_EQ(read(document("<cityObjectMember xlink:href='rest.gml#a'/>" + member(building(own))))
                .model.skipped.count(),
            1u);
  // What is related need not stand here.
  EXPECT_EQ(read(document(member(building(own + "<generalizesTo xlink:href='#none'/>"))))
                .model.skipped.count(),
            0u);
}

TEST(CityGml, RefusesADocumentTypeAndAnInclusion) {
  const std::string city = document(member(building(lod(2, surfaces(kFloor)) + "&rest;")));
  const std::string laughs = "<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;'>";
  for (const std::string& type : {std::string("<!DOCTYPE c [<!ENTITY rest SYSTEM 'rest.xml'>]>"),
                                  std::string("<!DOCTYPE c SYSTEM 'c.dtd'>"),
                                  "<!DOCTYPE c [" + laughs + "<!ENTITY rest '&b;&b;'>]>"}) {
    EXPECT_TRUE(says(refusal_of(type + city), "expected no document type"));
  }
  EXPECT_TRUE(says(refusal_of(city), "only entities of XML itself"));
  EXPECT_TRUE(says(refusal_of(document("<i:include xmlns:i='http://www.w3.org/2001/XInclude' "
                                       "href='rest.xml'/>")),
                   "XInclude"));
}

TEST(CityGml, CountsShapesThatItDoesNotKnow) {
  const auto skipped = [](const std::string& geometry) {
    return read(document(member(building(lod(2, geometry))))).model;
  };
  EXPECT_EQ(skipped("<gml:Surface><gml:patches><gml:PolygonPatch>" +
                    ring("<gml:posList>0 0 1 9 0 1 9 9 1</gml:posList>") +
                    "</gml:PolygonPatch><gml:Cylinder/></gml:patches></gml:Surface>")
                .skipped.count(),
            1u);
  // A line among surfaces, as an aerial is drawn.
  const auto city = skipped("<gml:MultiGeometry><gml:geometryMember>" + kFloor +
                            "</gml:geometryMember><gml:geometryMember><gml:LineString>"
                            "<gml:posList>0 0 1 0 0 30</gml:posList></gml:LineString>"
                            "</gml:geometryMember></gml:MultiGeometry>");
  EXPECT_EQ(geom::footprints_of(city, 1, {}).skipped.count(), 1u);
}

TEST(CityGml, RefusesTextBesideElementsAndPerspectives) {
  EXPECT_TRUE(says(refusal_of(document(member(building(lod(
                       2, surfaces("<gml:Polygon>" +
                                   ring("<gml:posList>0 0 1 9 0 1 9 9 1 <a/> 9 9 1</gml:posList>") +
                                   "</gml:Polygon>")))))),
                   "expected text alone"));
  EXPECT_TRUE(says(
      refusal_of(document(
          member("<gen:GenericCityObject><gen:lod1ImplicitRepresentation><ImplicitGeometry>"
                 "<transformationMatrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2</transformationMatrix>"
                 "<relativeGMLGeometry>" +
                 surfaces(kFloor) +
                 "</relativeGMLGeometry>"
                 "<referencePoint><gml:Point><gml:pos>1 2 5</gml:pos></gml:Point></referencePoint>"
                 "</ImplicitGeometry></gen:lod1ImplicitRepresentation></gen:GenericCityObject>"))),
      "last row"));
}

// Objects of modules that nobody knows are not replaced by finer ones around them.
TEST(CityGml, BuildsObjectsOfUnknownModulesByThemselves) {
  const CityGml city = read(document(
      member(building(lod(3, surfaces(kFloor)) + "<x:carries xmlns:x='x'><x:Mast>" +
                      lod(1, surfaces(polygon("4 4 2 5 4 2 5 5 2"))) + "</x:Mast></x:carries>"))));
  EXPECT_EQ(geom::footprints_of(city.model, 1, {}).footprints.size(), 2u);
}

std::string third(const std::string& members) {
  return "<CityModel xmlns='http://www.opengis.net/citygml/3.0' "
         "xmlns:bldg='http://www.opengis.net/citygml/building/3.0' "
         "xmlns:con='http://www.opengis.net/citygml/construction/3.0' "
         "xmlns:pcl='http://www.opengis.net/citygml/pointcloud/3.0' "
         "xmlns:gen='http://www.opengis.net/citygml/generics/3.0' "
         "xmlns:gml='http://www.opengis.net/gml/3.2' xmlns:xlink='http://www.w3.org/1999/xlink'>" +
         members + "</CityModel>";
}

std::string core_lod(int n, const std::string& geometry) {
  const std::string name = "lod" + std::to_string(n) + "MultiSurface";
  return "<" + name + ">" + geometry + "</" + name + ">";
}

std::string height(const std::string& high, const std::string& low, const std::string& value) {
  return "<con:height><con:Height><con:highReference>" + high +
         "</con:highReference>\n<con:lowReference>" + low +
         "</con:lowReference><con:status>measured</con:status>\n<con:value uom='m'>" + value +
         "</con:value></con:Height></con:height>";
}

TEST(CityGml3, TakesBoundariesPartsAndAttributes) {
  const std::string boundary = "<boundary><con:RoofSurface gml:id='r'>" +
                               core_lod(2, surfaces(polygon(kRoof))) +
                               "</con:RoofSurface></boundary>";
  const std::string part = "<bldg:buildingPart>" + part_in("p", boundary) + "</bldg:buildingPart>";
  const std::string ridge =
      "<genericAttribute><gen:MeasureAttribute><gen:name>ridge</gen:name>"
      "<gen:value uom='m'>7</gen:value></gen:MeasureAttribute>"
      "</genericAttribute>";
  const CityGml city =
      read(third(member(building(ridge + core_lod(2, surfaces(kFloor)) +
                                 height("highestRoofEdge", "lowestGroundPoint", "20") + part))),
           "ridge");
  ASSERT_EQ(city.model.objects.size(), 2u);
  EXPECT_EQ(city.model.objects[0].attributes.at("measuredHeight"), "20 m");
  EXPECT_EQ(city.model.objects[0].attributes.at("ridge"), "7 m");
  EXPECT_TRUE(city.model.objects[1].geometries.at(0).roofs_only);
  EXPECT_EQ(city.model.objects[1].whole, city.model.objects[0].whole);
  EXPECT_TRUE(city.model.skipped.empty());
}

// The place of an address is in a reference system of its own.
TEST(CityGml3, TakesTheReferenceSystemOfItsSurfaces) {
  const std::string address =
      "<bldg:address><Address><multiPoint><gml:MultiPoint srsName='EPSG:4326'><gml:pointMember>"
      "<gml:Point><gml:pos>48 11 0</gml:pos></gml:Point></gml:pointMember></gml:MultiPoint>"
      "</multiPoint></Address></bldg:address>";
  const CityGml city =
      read(third("<boundedBy srsName='EPSG:25832'/>" +
                 member(building(address + core_lod(2, surfaces(polygon(kRoof)))))));
  EXPECT_EQ(city.model.crs, "EPSG:25832");
  EXPECT_TRUE(geom::footprints_of(city.model, 1, {}).skipped.empty());
}

// What is drawn flat is as high as its highest point above its lowest ground; to its eaves alone
// it may be higher.
TEST(CityGml3, TakesHeightsThatReachTheTop) {
  const auto city = [](const std::string& heights) {
    return geom::footprints_of(
        read(third(member(building(core_lod(0, surfaces(kFloor)) + heights)))).model, 1, {});
  };
  const auto eaves = height("generalEave", "lowestGroundPoint", "20");
  EXPECT_EQ(city(eaves + height("highestRoofEdge", "lowestGroundPoint", "12")).footprints.at(0).top,
            13);
  EXPECT_TRUE(city(eaves).heights.at(0).second.junk);
  EXPECT_TRUE(city(height("highestRoofEdge", "entrancePoint", "12")).heights.at(0).second.junk);
}

TEST(CityGml3, CountsPartsWithoutSurfacesAndCloudsAlone) {
  const auto skipped = [](const std::string& inside) {
    return geom::footprints_of(read(third(member(building(inside)))).model, 1, {}).skipped.count();
  };
  const std::string cloud =
      "<pointCloud><pcl:PointCloud><pcl:pointFile>a.laz</pcl:pointFile>"
      "</pcl:PointCloud></pointCloud>";
  EXPECT_EQ(skipped(cloud), 1u);
  EXPECT_EQ(skipped(cloud + core_lod(2, surfaces(polygon(kRoof)))), 0u);
  EXPECT_EQ(skipped(core_lod(2, surfaces(polygon(kRoof))) +
                    "<bldg:buildingPart><bldg:BuildingPart/></bldg:buildingPart>"),
            1u);
}

}  // namespace
}  // namespace geom::gis
