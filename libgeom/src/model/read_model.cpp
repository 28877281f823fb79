#include "geom/model/read_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geom/base/error.h"
#include "geom/base/sha256.h"
#include "geom/model/assimp_scene.h"
#include "geom/model/gltf_model.h"
#include "geom/model/tileset.h"
#include "geom/text/parse_json.h"
#include "model/draco_decoder.h"

namespace geom {
namespace {

std::string sha256_of(std::string_view bytes) {
  Sha256 sum;
  sum.update(std::as_bytes(std::span(bytes)));
  return sum.hex();
}

// Files beside the first one, as each is asked for; sums what it gives.
class Folder {
 public:
  Folder(const std::string& path, const ModelFiles& open)
      : folder_(std::filesystem::path(path).parent_path()), open_(open) {}

  std::string read(const std::string& name) {
    std::string bytes = open_((folder_ / name).string());
    add(name, bytes);
    return bytes;
  }

  void add(const std::string& name, std::string_view bytes) {
    ++count_;
    list_ += name + ' ' + sha256_of(bytes) + '\n';
  }

  std::size_t count() const { return count_; }
  std::string hash(const std::string& only) const {
    return "sha256:" + sha256_of(count_ == 1 ? only : list_);
  }

 private:
  std::filesystem::path folder_;
  const ModelFiles& open_;
  std::string list_;
  std::size_t count_ = 0;
};

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

// By how the bytes begin; OBJ, which begins in no way of its own, by its name.
std::string detect(const std::string& bytes, const std::string& path) {
  if (bytes.empty()) throw InputError(path, {.says = "the file is empty"});
  if (bytes.starts_with("glTF")) return "gltf";
  const std::string ending = ending_of(path);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && bytes[first] == '{') {
    return parse_json(bytes, path).contains("root") ? "tiles" : "gltf";
  }
  if (bytes.starts_with("b3dm")) {
    throw InputError(path, {.says = "this is one tile, which does not say where it stands",
                            .advice = "give the tileset.json that names it"});
  }
  for (const auto& [end, format] : {std::pair{".obj", "obj"},
                                    {".stl", "stl"},
                                    {".ply", "ply"},
                                    {".dae", "collada"},
                                    {".3ds", "3ds"}}) {
    if (ending == end) return format;
  }
  if (bytes.starts_with("solid")) return "stl";
  if (bytes.starts_with("ply")) return "ply";
  throw InputError(path, {.expected = "a file whose name ends in .obj, .stl, .ply, .dae or .3ds, a "
                                      "glTF file or a tileset.json; --format says what it is"});
}

Model read_alone(const std::string& bytes, const std::string& path, const std::string& format) {
  std::istringstream in(bytes);
  if (format == "obj") return read_obj(in, path);
  if (format == "ply") return read_ply_model(in, path);
  if (format == "stl") return read_stl(in, path);
  return read_scene(bytes, path, format);
}

}  // namespace

ModelSource read_model(const std::string& path, const std::string& format, const ModelFiles& open) {
  const std::string bytes = open(path);
  ModelSource out;
  out.format = format == "auto" ? detect(bytes, path) : format;
  Folder folder(path, open);
  const std::string name = std::filesystem::path(path).filename().string();
  if (out.format == "tiles") {
    const ModelFiles files = [&](const std::string& p) { return folder.read(p); };
    TilesModel tiles = read_tileset(name, files, decode_draco);
    out.model = std::move(tiles.model);
    out.tiles = tiles.tiles;
    out.coarser = tiles.coarser;
    out.on_earth = tiles.on_earth;
  } else if (out.format == "gltf") {
    folder.add(name, bytes);
    const ModelFiles files = [&](const std::string& p) { return folder.read(p); };
    out.model = read_gltf(bytes, path, files, {}, decode_draco);
  } else {
    folder.add(name, bytes);
    out.model = read_alone(bytes, path, out.format);
  }
  out.files = folder.count();
  out.hash = folder.hash(bytes);
  return out;
}

}  // namespace geom
