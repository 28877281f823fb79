#include "geom/picture/take.h"

#include <algorithm>

#include "geom/base/parallel.h"

namespace geom::picture {
namespace {

constexpr int kTile = 32;  // pixels a side; a multiple of kBlock

struct Tile {
  std::size_t picture;
  int x;
  int y;
};

std::size_t index(const Picture& picture, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
         static_cast<std::size_t>(x);
}

void fill_block(const PictureScene& scene, const Shader& shader, const Rays& rays, int x, int y,
                Picture& out) {
  const Block block = scene.cast(rays, x, y);
  std::array<Colour, kBlock * kBlock> colours;
  if (!out.colour.empty()) colours = shader.colours(rays, x, y, block);
  for (int i = 0; i < kBlock * kBlock; ++i) {
    const int px = x + i % kBlock;
    const int py = y + i / kBlock;
    if (px >= out.width || py >= out.height) continue;
    const Hit& hit = block[static_cast<std::size_t>(i)];
    const std::size_t at = index(out, px, py);
    if (!out.colour.empty()) out.colour[at] = colours[static_cast<std::size_t>(i)];
    if (!out.depth.empty()) out.depth[at] = hit.depth;
    if (!out.id.empty()) out.id[at] = hit.kind == Hit::Kind::box ? hit.object + 1 : 0;
  }
}

void fill_depths(const PictureScene& scene, const Rays& rays, int x, int y, Picture& out) {
  const auto depths = scene.depths(rays, x, y);
  const int columns = std::min(kBlock, out.width - x);
  const int rows = std::min(kBlock, out.height - y);
  for (int row = 0; row < rows; ++row) {
    std::copy_n(depths.begin() + row * kBlock, columns,
                out.depth.begin() + static_cast<std::ptrdiff_t>(index(out, x, y + row)));
  }
}

void fill_tile(const PictureScene& scene, const Shader& shader, const View& view, const Tile& tile,
               Picture& out) {
  const Rays rays(view);
  const int right = std::min(tile.x + kTile, view.width);
  const int bottom = std::min(tile.y + kTile, view.height);
  const bool depth_alone = !out.depth.empty() && out.colour.empty() && out.id.empty();
  for (int y = tile.y; y < bottom; y += kBlock) {
    for (int x = tile.x; x < right; x += kBlock) {
      if (depth_alone) {
        fill_depths(scene, rays, x, y, out);
      } else {
        fill_block(scene, shader, rays, x, y, out);
      }
    }
  }
}

std::vector<Tile> tiles_of(std::span<const View> views) {
  std::vector<Tile> tiles;
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (int y = 0; y < views[i].height; y += kTile) {
      for (int x = 0; x < views[i].width; x += kTile) tiles.push_back({i, x, y});
    }
  }
  return tiles;
}

std::vector<Picture> one_ray_a_pixel(const PictureScene& scene, const Shader& shader,
                                     std::span<const View> views, const Wanted& wanted,
                                     const Execution& run) {
  std::vector<Picture> out;
  for (const View& view : views) {
    Picture picture;
    picture.width = view.width;
    picture.height = view.height;
    if (wanted.colour) picture.colour.resize(picture.pixels());
    if (wanted.depth) picture.depth.resize(picture.pixels());
    if (wanted.id) picture.id.resize(picture.pixels());
    out.push_back(std::move(picture));
  }
  const std::vector<Tile> tiles = tiles_of(views);
  Execution quiet = run;
  quiet.progress = nullptr;
  parallel_for(tiles.size(), quiet, [&](std::size_t i) {
    const Tile& tile = tiles[i];
    fill_tile(scene, shader, views[tile.picture], tile, out[tile.picture]);
  });
  return out;
}

// The mean of n x n pixels for each.
std::vector<Colour> reduced(const Picture& large, int n) {
  const int width = large.width / n;
  const int height = large.height / n;
  std::vector<Colour> out;
  out.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const int count = n * n;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      int sum[3] = {count / 2, count / 2, count / 2};
      for (int k = 0; k < count; ++k) {
        const Colour& c = large.colour[index(large, x * n + k % n, y * n + k / n)];
        sum[0] += c.r;
        sum[1] += c.g;
        sum[2] += c.b;
      }
      out.push_back({static_cast<std::uint8_t>(sum[0] / count),
                     static_cast<std::uint8_t>(sum[1] / count),
                     static_cast<std::uint8_t>(sum[2] / count)});
    }
  }
  return out;
}

}  // namespace

std::vector<Picture> take_pictures(const PictureScene& scene, const Shader& shader,
                                   std::span<const View> views, const Wanted& wanted,
                                   const Execution& run) {
  if (wanted.samples == 1 || !wanted.colour) {
    return one_ray_a_pixel(scene, shader, views, wanted, run);
  }
  auto out = one_ray_a_pixel(scene, shader, views, {false, wanted.depth, wanted.id, 1}, run);
  for (std::size_t i = 0; i < views.size(); ++i) {  // one large picture in memory at a time
    const View large = enlarged(views[i], wanted.samples);
    const auto pictures = one_ray_a_pixel(scene, shader, std::span(&large, 1), {}, run);
    out[i].colour = reduced(pictures[0], wanted.samples);
  }
  return out;
}

}  // namespace geom::picture
