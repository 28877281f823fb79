#pragma once

// Which boxes wear windows: buildings do; trees, poles and the blocks of a course do not.

#include <string_view>
#include <vector>

#include "geom/map/box_map.h"

namespace geom::picture {

// Whether a label names something that is no building: a word of it (split at other characters and
// before capitals, so "SolitaryVegetationObject" too) is tree, pole, wall, terrain or the like, or
// the label is a colour, as the blocks of a course have.
bool names_no_building(std::string_view label);

// One a box. True unless the label says otherwise, or the box is less than a storey high (3 m) or a
// bay wide (4 m along its longer side), or stands on a stem: on boxes that carry less than a
// quarter of its base, as a crown on its trunk and a lamp on its pole.
std::vector<bool> windows_of(const BoxMap& map);

}  // namespace geom::picture
