#pragma once

// The records of a LAS file that stand before its points.

#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "geom/earth/coordinate_reference.h"
#include "las_header.h"
#include "las_references.h"
#include "laz_setup.h"

namespace geom {

struct LasRecords {
  LasReferences references;  // what each record says
  CoordinateReference reference;
  std::optional<LazSetup> laz;
  std::string copc;  // the data of COPC's own record, which is the first; else empty
};

// Reads from the end of the header to the points. Throws InputError(source, …) where records are
// cut short or reach beyond that, where one that describes the coordinates stands where none
// begins, where records about the coordinates contradict each other, and where compressed points
// have no record that says how.
LasRecords read_las_records(std::istream& in, const LasHeader& header, std::string_view source);

}  // namespace geom
