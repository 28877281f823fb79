#include "implicit_tiles.h"

#include <fmt/format.h>

#include <array>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "model_path.h"

namespace geom {
namespace {

constexpr std::uint64_t kMostLevels = 60;              // whose places are whole numbers of 64 bits
constexpr std::uint64_t kMostBitsOfALevel = 1u << 26;  // in a subtree
constexpr std::size_t kMostTiles = 20000000;

std::uint64_t branches_of(const JsonMembers& tiling) {
  const std::string scheme = tiling.text("subdivisionScheme");
  if (scheme == "QUADTREE") return 4;
  if (scheme == "OCTREE") return 8;
  tiling.refuse(
      {.expected = "subdivisionScheme QUADTREE or OCTREE", .found = in_quotes(excerpt(scheme))});
}

std::uint64_t levels_of(const JsonMembers& tiling, std::uint64_t branches) {
  const std::uint64_t levels = tiling.whole("subtreeLevels");
  std::uint64_t last = 1;
  for (std::uint64_t i = 0; i < levels && last <= kMostBitsOfALevel; ++i) last *= branches;
  if (levels == 0 || last > kMostBitsOfALevel) {
    tiling.refuse({.expected = fmt::format("subtreeLevels from 1 to {}", branches == 4 ? 13 : 8),
                   .found = fmt::to_string(levels)});
  }
  return levels;
}

}  // namespace

ImplicitTiles::ImplicitTiles(const JsonMembers& tile, std::vector<std::string> contents,
                             const std::string& path, const ModelFiles& files, ReadTile read)
    : path_(path), files_(files), read_(std::move(read)), contents_(std::move(contents)) {
  const JsonMembers tiling(tile.members("implicitTiling"), path, "implicitTiling");
  if (tile.has("children"))
    tile.refuse({.expected = "no children beside implicitTiling", .found = "some"});
  shape_.branches = branches_of(tiling);
  shape_.levels = levels_of(tiling, shape_.branches);
  shape_.contents = contents_.size();
  available_levels_ = tiling.whole("availableLevels");
  if (available_levels_ == 0 || available_levels_ > kMostLevels) {
    tiling.refuse({.expected = fmt::format("availableLevels from 1 to {}", kMostLevels),
                   .found = fmt::to_string(available_levels_)});
  }
  subtrees_ = JsonMembers(tiling.members("subtrees"), path, "subtrees").text("uri");
  require_pattern(tiling, subtrees_);
  for (const std::string& pattern : contents_) require_pattern(tile, pattern);
}

// Without one of these, many tiles would have one file.
void ImplicitTiles::require_pattern(const JsonMembers& at, const std::string& pattern) const {
  for (const char* variable : {"{level}", "{x}", "{y}", "{z}"}) {
    if (pattern.find(variable) != std::string::npos) continue;
    if (shape_.branches == 4 && std::string_view(variable) == "{z}") continue;
    at.refuse({.expected = fmt::format("{} in the URI \"{}\"", variable, excerpt(pattern)),
               .found = "none"});
  }
}

bool ImplicitTiles::read() {
  const Tile root;
  return visit(load(root), root, 0, 0).whole;
}

Subtree ImplicitTiles::load(const Tile& root) {
  return {path_of_uri(uri(subtrees_, root), path_, path_), shape_, files_};
}

std::string ImplicitTiles::uri(const std::string& pattern, const Tile& tile) const {
  const std::array<std::pair<std::string_view, std::uint64_t>, 4> variables = {
      {{"{level}", tile.level}, {"{x}", tile.x}, {"{y}", tile.y}, {"{z}", tile.z}}};
  std::string out = pattern;
  for (const auto& [variable, value] : variables) {
    for (std::size_t at = 0; (at = out.find(variable, at)) != std::string::npos;) {
      out.replace(at, variable.size(), fmt::format("{}", value));
    }
  }
  return out;
}

ImplicitTiles::Made ImplicitTiles::visit(const Subtree& subtree, const Tile& tile,
                                         std::uint64_t level, std::uint64_t i) {
  if (level == shape_.levels) {
    if (!subtree.has_child(i)) return {};
    return visit(load(tile), tile, 0, 0);
  }
  if (!subtree.has_tile(level, i)) return {};
  if (tile.level >= available_levels_) {
    throw InputError(path_,
                     {.expected = fmt::format("tiles on {} levels, as it says", available_levels_),
                      .found = fmt::format("one on level {}", tile.level)});
  }
  if (++visited_ > kMostTiles) {
    throw InputError(path_, {.says = fmt::format("more than {} implicit tiles", kMostTiles)});
  }
  bool below = true;
  bool any_child = false;
  for (std::uint64_t c = 0; c < shape_.branches; ++c) {
    const Tile child{tile.level + 1, 2 * tile.x + (c & 1), 2 * tile.y + (c >> 1 & 1),
                     2 * tile.z + (c >> 2 & 1)};
    const Made made = visit(subtree, child, level + 1, shape_.branches * i + c);
    if (!made.there) continue;
    any_child = true;
    below &= made.whole;
  }
  below &= any_child;
  std::vector<std::string> uris;
  for (std::size_t k = 0; k < contents_.size(); ++k) {
    if (subtree.has_content(k, level, i)) uris.push_back(uri(contents_[k], tile));
  }
  return {true, read_(uris, below, tile.level)};
}

}  // namespace geom
