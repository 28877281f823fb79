#include "fuzz/readers.h"
#include "geom/model/place_model.h"
#include "geom/model/tileset.h"

// A tileset, then a zero byte, then the bytes of every file that it names, subtrees too; of a few
// hundred of these, since implicit tiles may name millions.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size, [](std::istream& in) {
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    std::size_t opened = 0;
    geom::TilesModel tiles = geom::read_tileset("tileset.json", [&](const std::string& path) {
      if (++opened > 300) throw geom::InputError(path, {.says = "one too many"});
      return path == "tileset.json" ? bytes.substr(0, end)
                                    : bytes.substr(std::min(end + 1, bytes.size()));
    });
    if (tiles.on_earth) geom::place_on_map(tiles.model, std::nullopt, "fuzz");
  });
}
