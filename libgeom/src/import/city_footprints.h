#pragma once

// Objects of a city model as footprints under their surfaces.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geom/import/building_height.h"
#include "geom/import/city_model.h"
#include "geom/map/footprint.h"

namespace geom {

struct CityFootprints {
  // In plan in the model's own coordinates, heights in metres; ids count the objects from 0.
  std::vector<Footprint> footprints;
  Skipped skipped;                             // and what the reader has skipped
  std::size_t objects = 0;                     // that gave footprints
  std::map<std::string, std::size_t> by_kind;  // "Building LoD 2": of these, how many
  // Of the buildings that are drawn flat: where their heights came from.
  std::vector<std::pair<std::string, BuildingHeight>> heights;
};

// Of each object all geometries of its highest level of detail, whatever its type: a road may lead
// over a bridge; and those of a lower level that reach a quarter of their size beyond, or whose
// plan the higher levels leave a gap in (has_gap): one of level 0 then is as high as the object.
// Each surface is solid below, down to the lowest point of all that the object is a part of, and by
// its `measuredHeight` below its highest where that is lower. Terrain, land use and water are
// ground. A building that is drawn flat stands on that as high as `measuredHeight`, `height` or
// `storeysAboveGround` say, or else `options.default_height`; a roof's edge alone is taken at
// either end of that height. Others that are drawn flat reach up by their `height` or
// `averageHeight`. A plan in level of detail 0 of an object whose parts stand on all of it
// (has_gap) has its heights from them, and lies on the ground; else it needs a height of its own.
//
// Objects that are left out (city_types.h) give nothing and are not skipped.
//
// Skipped are: an object without surfaces, unless it has parts, lies on the ground or is a group;
// one that stands up, is drawn flat in level of detail 0 and has no height; and a building of roofs
// alone without a measured height, since nothing says where its ground is.
//
// `unit`: metres in one of the model's heights. `options.unit` is that of heights in attributes
// that name none.
CityFootprints footprints_of(const CityModel& model, double unit, const HeightOptions& options);

}  // namespace geom
