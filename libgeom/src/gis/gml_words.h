#pragma once

// The elements of CityGML that are told apart by name.

#include <set>
#include <string>
#include <string_view>

namespace geom::gis {

using Words = std::set<std::string, std::less<>>;

inline const Words kPolygons = {"Polygon", "PolygonPatch", "Triangle", "Rectangle"};
inline const Words kShapes = {"MultiSurface",
                              "CompositeSurface",
                              "Surface",
                              "OrientableSurface",
                              "PolyhedralSurface",
                              "TriangulatedSurface",
                              "Tin",
                              "Solid",
                              "MultiSolid",
                              "CompositeSolid",
                              "MultiPolygon",
                              "MultiGeometry",
                              "GeometricComplex",
                              "Shell"};
inline const Words kLines = {"Point",      "MultiPoint",     "LineString",     "Curve",
                             "MultiCurve", "CompositeCurve", "MultiLineString"};
// Members that are no city objects.
inline const Words kRecords = {"Address", "Appearance", "Dynamizer", "Version",
                               "VersionTransition"};
inline const Words kMembers = {"cityObjectMember", "featureMember", "featureMembers",
                               "groupMember"};
// Objects within others, which are missed where they have no surfaces.
inline const Words kNested = {"BuildingPart",
                              "BuildingInstallation",
                              "BuildingConstructiveElement",
                              "BridgePart",
                              "BridgeInstallation",
                              "BridgeConstructionElement",
                              "BridgeConstructiveElement",
                              "TunnelPart",
                              "TunnelInstallation",
                              "TunnelConstructiveElement",
                              "OtherConstruction",
                              "TINRelief",
                              "MassPointRelief",
                              "BreaklineRelief",
                              "RasterRelief"};
inline const Words kInterior = {"Room",
                                "IntBuildingInstallation",
                                "BuildingFurniture",
                                "BuildingRoom",
                                "BuildingUnit",
                                "Storey",
                                "BridgeRoom",
                                "IntBridgeInstallation",
                                "BridgeFurniture",
                                "HollowSpace",
                                "IntTunnelInstallation",
                                "TunnelFurniture"};
// What bounds an object, besides surfaces of other names.
inline const Words kBoundaries = {"Door", "Window", "TrafficArea", "AuxiliaryTrafficArea",
                                  "Marking"};
inline const Words kHeights = {"measuredHeight", "height", "averageHeight", "storeysAboveGround"};
inline const Words kHeightParts = {"highReference", "lowReference", "value"};
// Properties of data, in which links lead to nothing that stands,
inline const Words kData = {"address",           "appearance",       "appearanceMember",
                            "externalReference", "metaDataProperty", "xalAddress"};
// and those whose link does: what is related may be in another file.
inline const Words kRelations = {"dataSource",     "description",    "descriptionReference",
                                 "engineeringCRS", "generalizesTo",  "linkToObservation",
                                 "name",           "parent",         "predecessor",
                                 "relatedTo",      "sensorLocation", "successor",
                                 "target"};
// Objects on the ground whose lines are their middle.
inline const Words kWays = {"Road",    "Track",        "Railway",      "Square",
                            "Section", "Intersection", "TrafficSpace", "AuxiliaryTrafficSpace",
                            "Waterway"};
// Properties whose lines and points say where an object is, meets the ground or leads to.
inline const Words kPlaces = {"lod0Point",      "lod0Network",  "multiPoint",
                              "location",       "centerLine",   "gridPoint",
                              "referencePoint", "reliefPoints", "controlPoint"};

// Elements of types, not of properties.
inline bool is_type(std::string_view name) {
  return !name.empty() && name[0] >= 'A' && name[0] <= 'Z';
}

// Whether the lines of a property are the object, as an aerial is drawn.
inline bool draws_lines(std::string_view property) {
  return !kPlaces.contains(property) && property.find("TerrainIntersection") == property.npos;
}

inline bool is_shape(std::string_view name) {
  return kPolygons.contains(name) || kShapes.contains(name);
}

inline bool is_geometry(std::string_view name) { return is_shape(name) || kLines.contains(name); }

inline bool is_boundary(std::string_view name) {
  return name.ends_with("Surface") || kBoundaries.contains(name);
}

// "urn:ogc:def:uom:UCUM::m" and "#m" as "m".
inline std::string unit_of(std::string_view uom) {
  const std::size_t at = uom.find_last_of(":#/");
  return std::string(at == std::string_view::npos ? uom : uom.substr(at + 1));
}

}  // namespace geom::gis
