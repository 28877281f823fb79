#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "batched_model.h"
#include "geom/base/error.h"
#include "geom/model/gltf_model.h"
#include "geom/model/model_format.h"
#include "geom/model/tileset.h"
#include "geom/text/beginning.h"
#include "geom/text/parse_json.h"
#include "implicit_tiles.h"
#include "json_members.h"
#include "model_path.h"

namespace geom {
namespace {

using Transform = Eigen::Matrix4d;

bool is_json(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != bytes.npos && bytes[first] == '{';
}

// Whatever the file is called.
bool is_tileset(const std::string& bytes, const std::string& path) {
  return is_json(bytes) && parse_json(bytes, path).contains("root");
}

constexpr std::size_t kDeepest = 300;              // tiles in tiles, whatever files they stand in
constexpr std::size_t kMostFiles = 1000000;        // read, the same ones again included
constexpr std::size_t kMostTriangles = 300000000;  // no cover takes more
constexpr double kNoPlaceOnEarth = 1e6;  // metres: nearer to the middle of the Earth than any

class TilesetReader {
 public:
  TilesetReader(const ModelFiles& files, const DracoDecoder& draco) : files_(files), draco_(draco) {
    model_.up = UpAxis::z;
  }

  TilesModel read(const std::string& path) {
    model_.unit = 1;
    read_tileset_file(path, files_(path), Transform::Identity(), 0);
    TilesModel out;
    out.tiles = tiles_;
    out.coarser = coarser_;
    out.on_earth = on_earth(path);
    out.model = std::move(model_);
    return out;
  }

 private:
  using Whole = bool;  // whether a tile has content, or else all those below it are whole

  Whole read_tileset_file(const std::string& path, const std::string& bytes, const Transform& place,
                          std::size_t depth) {
    if (!open_.insert(path).second) {
      throw InputError(path, {.says = "this tileset is within itself"});
    }
    const nlohmann::json json = parse_json(bytes, path);
    const JsonMembers root(json, path, "tileset");
    const std::string version = JsonMembers(root.members("asset"), path, "asset").text("version");
    if (version != "1.0" && version != "1.1") {
      root.refuse({.expected = "version 1.0 or 1.1", .found = in_quotes(version.substr(0, 20))});
    }
    take_up_axis(JsonMembers(root.members("asset"), path, "asset"), depth == 0);
    for (const nlohmann::json& name : root.list("extensionsRequired")) {
      if (name == "3DTILES_content_gltf" || name == "3DTILES_metadata") continue;
      root.refuse(
          {.says = fmt::format("it requires the extension {}, which is not read", shown(name))});
    }
    if (!root.has("root")) root.refuse({.expected = "\"root\"", .found = "none"});
    const Whole whole = read_tile({json.at("root"), path, "root"}, path, place, "", depth);
    open_.erase(path);
    return whole;
  }

  // Older writers have content that is z up already and say so; the standard has no such word.
  void take_up_axis(const JsonMembers& asset, bool first) {
    const std::string up = asset.find_text("gltfUpAxis").value_or("Y");
    const bool z = up == "Z" || up == "z";
    if (!z && up != "Y" && up != "y") {
      asset.refuse({.expected = "gltfUpAxis Y or Z", .found = in_quotes(up.substr(0, 20))});
    }
    if (first) z_up_ = z;
    if (z != z_up_)
      asset.refuse({.expected = "one gltfUpAxis in all tilesets", .found = "another"});
  }

  static Transform transform_of(const JsonMembers& tile) {
    Transform out = Transform::Identity();
    const auto m = tile.numbers("transform", 16);
    if (!m) return out;
    for (Eigen::Index i = 0; i < 16; ++i) out(i % 4, i / 4) = (*m)[static_cast<std::size_t>(i)];
    if (out.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
      tile.refuse({.expected = "a transform whose last row is 0, 0, 0, 1"});
    }
    return out;
  }

  Whole read_tile(const JsonMembers& tile, const std::string& path, const Transform& above,
                  const std::string& refine_above, std::size_t depth) {
    if (depth > kDeepest) tile.refuse({.says = fmt::format("more than {} tiles deep", kDeepest)});
    if (tile.members("extensions").contains("3DTILES_implicit_tiling")) {
      tile.refuse({.says = "3DTILES_implicit_tiling is not read", .advice = "write version 1.1"});
    }
    const Transform place = above * transform_of(tile);
    const std::string refine = tile.find_text("refine").value_or(refine_above);
    if (refine != "ADD" && refine != "REPLACE") {
      tile.refuse({.expected = "refine ADD or REPLACE", .found = in_quotes(refine.substr(0, 20))});
    }
    if (tile.has("implicitTiling")) {
      const auto read = [&](const std::vector<std::string>& uris, bool below, std::size_t level) {
        return read_contents(uris, below, refine, path, place, depth + level);
      };
      return ImplicitTiles(tile, contents_of(tile), path, files_, read).read();
    }
    const std::size_t children = tile.list("children").size();
    bool below = children > 0;
    for (std::size_t i = 0; i < children; ++i) {
      below &= read_tile(tile.at("children", i, "tile"), path, place, refine, depth + 1);
    }
    return read_contents(contents_of(tile), below, refine, path, place, depth);
  }

  // Of a tile, when those below it are read.
  Whole read_contents(const std::vector<std::string>& uris, bool below, const std::string& refine,
                      const std::string& path, const Transform& place, std::size_t depth) {
    const bool replaced = refine == "REPLACE" && below;
    bool whole = below;
    for (const std::string& uri : uris) {
      whole |= read_content(path_of_uri(uri, path, path), replaced, place, depth);
    }
    return whole;
  }

  static std::vector<std::string> contents_of(const JsonMembers& tile) {
    std::vector<std::string> out;
    const auto add = [&](const JsonMembers& content) {
      const auto uri = content.has("uri") ? content.find_text("uri") : content.find_text("url");
      if (!uri) content.refuse({.expected = "\"uri\"", .found = "none"});
      out.push_back(*uri);
    };
    if (tile.has("content")) {
      add({tile.members("content"), tile.source(), "content"});
    }
    for (std::size_t i = 0; i < tile.list("contents").size(); ++i) {
      add(tile.at("contents", i, "content"));
    }
    if (tile.members("extensions").contains("3DTILES_multiple_contents")) {
      tile.refuse({.says = "3DTILES_multiple_contents is not read", .advice = "write version 1.1"});
    }
    return out;
  }

  // `replaced`: tiles below are finer. A tileset is no coarser content: it has tiles of its own, of
  // whatever size.
  Whole read_content(const std::string& path, bool replaced, const Transform& place,
                     std::size_t depth) {
    if (++files_read_ > kMostFiles) {
      throw InputError(path, {.says = fmt::format("more than {} files of tiles", kMostFiles)});
    }
    const std::string bytes = files_(path);
    if (is_tileset(bytes, path)) return read_tileset_file(path, bytes, place, depth + 1);
    if (replaced) {
      ++coarser_;
      return false;
    }
    if (bytes.starts_with("b3dm")) {
      ++tiles_;
      const BatchedModel batch = read_batched_model(bytes, path);
      Transform centred = Transform::Identity();
      centred.topRightCorner<3, 1>() = batch.center;
      return add(read_gltf(batch.gltf, path, files_, path, draco_), place * centred, batch.names,
                 path);
    }
    if (bytes.starts_with("glTF") || is_json(bytes)) {
      ++tiles_;
      return add(read_gltf(bytes, path, files_, path, draco_), place, {}, path);
    }
    model_.skipped.add("content that is no b3dm, glb, glTF or tileset", path);
    return false;
  }

  // Positions are y up in the glTF, and z up in the tile (OGC 22-025r4, 6.7.1.6.2), unless the
  // tileset says otherwise.
  Whole add(GltfModel content, const Transform& place, const std::vector<std::string>& names,
            const std::string& path) {
    const auto first = static_cast<std::uint32_t>(model_.mesh.vertices.size());
    if (content.mesh.vertices.size() > std::numeric_limits<std::uint32_t>::max() - first) {
      throw InputError(path, {.says = "more than 2^32 vertices in all tiles"});
    }
    for (const Vec3& v : content.mesh.vertices) {
      model_.mesh.vertices.push_back(place.topLeftCorner<3, 3>() * (z_up_ ? v : z_up_of_y_up(v)) +
                                     place.topRightCorner<3, 1>());
    }
    if (content.mesh.triangles.size() > kMostTriangles - model_.mesh.triangles.size()) {
      throw InputError(
          path, {.says = fmt::format("more than {} triangles in all tiles", kMostTriangles)});
    }
    for (std::size_t t = 0; t < content.mesh.triangles.size(); ++t) {
      MeshTriangle triangle = content.mesh.triangles[t];
      for (std::uint32_t& corner : triangle.corners) corner += first;
      triangle.part = part_of(content, t, names, path);
      model_.mesh.triangles.push_back(triangle);
    }
    model_.skipped.add_of(path, content.skipped);
    return !content.mesh.triangles.empty() || !content.skipped.empty();
  }

  // Features of two tiles are two parts, whatever their names.
  std::uint32_t part_of(const GltfModel& content, std::size_t t,
                        const std::vector<std::string>& names, const std::string& path) {
    const std::int64_t feature = content.feature[t];
    const std::uint32_t node = content.mesh.triangles[t].part;
    const std::pair key{tiles_, feature >= 0 ? feature : -1 - static_cast<std::int64_t>(node)};
    const auto [at, added] =
        parts_.try_emplace(key, static_cast<std::uint32_t>(model_.parts.size()));
    if (added) {
      const bool named = feature >= 0 && static_cast<std::size_t>(feature) < names.size();
      model_.parts.push_back(named          ? names[static_cast<std::size_t>(feature)]
                             : feature >= 0 ? fmt::format("{} {}", path, feature)
                                            : content.parts[node]);
    }
    return at->second;
  }

  bool on_earth(const std::string& path) const {
    const auto& all = model_.mesh.vertices;
    const auto near = [](const Vec3& v) { return v.norm() < kNoPlaceOnEarth; };
    const auto count = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), near));
    if (count == all.size()) return false;
    if (count == 0) return true;
    throw InputError(
        path, {.expected = "earth-centred coordinates, or local ones",
               .found = fmt::format(
                   "both: {} of {} vertices are less than 1,000 km from the middle of the Earth",
                   count, all.size())});
  }

  const ModelFiles& files_;
  const DracoDecoder& draco_;
  Model model_;
  std::set<std::string> open_;  // tilesets that this one is within
  std::map<std::pair<std::size_t, std::int64_t>, std::uint32_t> parts_;
  bool z_up_ = false;  // in the glTF, too
  std::size_t files_read_ = 0;
  std::size_t tiles_ = 0;
  std::size_t coarser_ = 0;
};

}  // namespace

TilesModel read_tileset(const std::string& path, const ModelFiles& files,
                        const DracoDecoder& draco) {
  return TilesetReader(files, draco).read(path);
}

namespace {

LoadedModel load_tiles(const ModelFile& file) {
  TilesModel read = read_tileset(file.name, file.files, file.decoders.draco);
  return {std::move(read.model), read.tiles, read.coarser, read.on_earth};
}

bool may_be_tiles(std::string_view bytes, const std::string& path) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != bytes.npos && bytes[first] == '{' && parse_json(bytes, path).contains("root");
}

constexpr std::string_view kReaders[] = {"skyway-mesh"};
constexpr Format kFormat{.word = "tiles",
                         .what = "a tileset of 3D Tiles",
                         .begins = json_with<R"("geometricError":)">,
                         .readers = kReaders};

}  // namespace

constinit const ModelFormat kTilesModel{
    .format = &kFormat, .may_be = may_be_tiles, .read = load_tiles};

}  // namespace geom
