#pragma once

// Which way the coordinates of a city model run.
//
// Example:
//   geom::CityModel model;
//   model.crs = "urn:ogc:def:crs:EPSG::4326";  // latitude first
//   model.objects.push_back({.type = "Building"});
//   const geom::CitySurface ground = {{{47, 8, 0}, {47, 8.1, 0}, {47.1, 8, 0}}};
//   model.objects[0].geometries.push_back({.surfaces = {ground}});
//   geom::gis::orient(model, geom::gis::Axes::as_named, false, "city.gml");
//   assert(model.objects[0].geometries[0].surfaces[0][0][0].x() == 8);  // longitude

#include <optional>
#include <string>

#include "geom/earth/proj_reference.h"
#include "geom/import/city_model.h"

namespace geom::gis {

enum class Axes { as_named, east_north, north_east };

// Brings x to the east and y to the north, and `model.crs` into the form of the other sources.
// Returns what PROJ knows of it; nothing where it is empty.
// `model.crs` is a srsName. One that is a URN or a URL of OGC's ("urn:ogc:def:crs:EPSG::4326")
// means the axes in the order of the system itself, which may be latitude or northing first; others
// ("EPSG:4326", those of the German AdV) and CityJSON mean east first. `axes` overrules that.
//
// Throws InputError(name, …) for a srsName that PROJ does not know, and unless `axes` says:
// where the coordinates lie in the area of the system only if they are exchanged, and where they
// lie in it either way and the surfaces face outward only if they are exchanged (what faces up runs
// counter-clockwise).
std::optional<ProjReference> orient(CityModel& model, Axes axes, bool city_json,
                                    const std::string& name);

// Throws InputError(name, …) where the srsName does not count metres: a shape that a matrix
// places in it would be bent.
void require_metres(const std::string& srs_name, const std::string& name);

}  // namespace geom::gis
