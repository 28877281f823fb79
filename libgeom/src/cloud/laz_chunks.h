#pragma once

// The chunks of a LAZ file, and the table that says where they are.

#include "geom/cloud/point_cloud.h"
#include "laz_item_decoder.h"
#include "laz_setup.h"

namespace geom {

// Reads `points` points, chunk after chunk, from the place where a LAZ header says that points
// start, to the end of the table of chunks. Returns where that end is: `bytes` are then there.
// Chunks are decoded on all threads where their sizes are known before: those of layers say them;
// others where `reading` has another way to the table, or where they vary in size. Points come in
// the file's order always, and the file is read front to back.
// Memory does not grow with the file, but for layers (some chunks) and for chunks of varying size
// that are not layers (the compressed points).
//
// Throws InputError where bytes end before the points, where a chunk takes more or fewer bytes or
// points than the table says, or where the table is missing or elsewhere. That a header counts a
// point too many or too few is found by the bytes and by the end of the code of each chunk; only a
// point as usual as those before it, which takes a small part of a bit, may be missed. What was
// found on the other way counts for nothing unless the table agrees with it when its turn comes.
void for_each_laz_point(ByteSource& bytes, const LazSetup& setup, std::uint64_t points,
                        const LasReading& reading, const LazPointSink& sink);

}  // namespace geom
