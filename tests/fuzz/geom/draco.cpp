#include "fuzz/reader.h"
#include "model/draco_decoder.h"

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"draco", [](std::istream& in) { geom::decode_draco(fuzz::rest_of(in), "fuzz"); }}};
}
