#pragma once

// Boxes as CSV: six coordinates and a label a line, bit for bit both ways.
//
// Example:
//   geom::BoxTable table;
//   table.add({{0, 0, 0}, {10, 10, 8}}, 1, table.label_of("house"));
//   std::stringstream file;
//   geom::write_box_csv(file, table);
//   assert(geom::read_box_csv(file, "boxes.csv").boxes == table.boxes);
//
// The header is `min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label`.

#include <iosfwd>
#include <string_view>

#include "geom/map/box_map.h"

namespace geom {

// Throws InputError(source, line, …) for another header, a field that is not a finite number, an
// inverted box, and a table without boxes. Labels may be quoted (csv_records.h) and then hold any
// bytes. ids are the numbers of the lines on which records begin.
BoxTable read_box_csv(std::istream& in, std::string_view source);

// If a box is there for a time only, the table has the columns from_s and until_s: seconds after
// the map's epoch, empty for no such end. A table with these columns is not read back, because it
// does not say the epoch.
void write_box_csv(std::ostream& out, const BoxTable& table);

struct BoxFormat;
extern const BoxFormat kBoxCsv;  // of box_formats()

}  // namespace geom
