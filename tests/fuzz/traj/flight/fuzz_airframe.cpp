#include <iterator>

#include "flight/airframe_record.h"
#include "fuzz/readers.h"
#include "geom/text/json_fields.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const std::string text(std::istreambuf_iterator<char>(in), {});
    traj::parse_airframe(geom::JsonFields(text, "fuzz", 0));
  });
}
