#pragma once

// GPSTIME11 of LAZ: times by the step since the last one, of which only the code is read (Isenburg
// 2013, "Compressing GPSTIME11").

#include "laz_item_decoder.h"

namespace geom {

// Version 1 or 2.
std::unique_ptr<LazItemDecoder> gps_time_decoder(unsigned version);

}  // namespace geom
