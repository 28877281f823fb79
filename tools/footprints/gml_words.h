#pragma once

// The elements of CityGML that are told apart by name.

#include <set>
#include <string>
#include <string_view>

namespace footprints {

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
inline const Words kMembers = {"cityObjectMember", "featureMember", "featureMembers",
                               "groupMember"};
// Objects within others.
inline const Words kNested = {"BuildingPart",
                              "BuildingInstallation",
                              "BridgePart",
                              "BridgeInstallation",
                              "BridgeConstructionElement",
                              "TunnelPart",
                              "TunnelInstallation",
                              "TINRelief",
                              "MassPointRelief",
                              "BreaklineRelief",
                              "RasterRelief"};
inline const Words kInterior = {"Room",        "IntBuildingInstallation", "BuildingFurniture",
                                "BridgeRoom",  "IntBridgeInstallation",   "BridgeFurniture",
                                "HollowSpace", "IntTunnelInstallation",   "TunnelFurniture"};
inline const Words kHeights = {"measuredHeight", "height", "averageHeight", "storeysAboveGround"};

// Elements of types, not of properties.
inline bool is_type(std::string_view name) {
  return !name.empty() && name[0] >= 'A' && name[0] <= 'Z';
}

// Properties whose lines are the object, and not where it meets the ground or has its address.
inline bool draws_lines(std::string_view property) {
  return property.ends_with("MultiCurve") || property.ends_with("Geometry");
}

// "urn:ogc:def:uom:UCUM::m" and "#m" as "m".
inline std::string unit_of(std::string_view uom) {
  const std::size_t at = uom.find_last_of(":#/");
  return std::string(at == std::string_view::npos ? uom : uom.substr(at + 1));
}

}  // namespace footprints
