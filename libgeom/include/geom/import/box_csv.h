#pragma once

// Box CSV: `min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label`, bit for bit both ways.

#include <iosfwd>
#include <string_view>

#include "geom/map/box_map.h"

namespace geom {

// Throws InputError(source, line, …) for another header, a field that is not a finite number, an
// inverted box, and a table without boxes. Labels may be quoted (csv_records.h) and then hold any
// bytes. ids are the numbers of the lines on which records begin.
BoxTable read_box_csv(std::istream& in, std::string_view source);

// With the columns from_s and until_s, seconds after the map's epoch, where a box is not always
// there; empty: no such end. What has them is not read back, for it does not say the epoch.
void write_box_csv(std::ostream& out, const BoxTable& table);

struct BoxFormat;
extern const BoxFormat kBoxCsv;  // of box_formats()

}  // namespace geom
