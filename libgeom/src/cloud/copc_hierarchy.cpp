#include "copc_hierarchy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "geom/base/error.h"
#include "point_chunks.h"

// Offsets below are those of COPC 1.0, "info VLR" and "hierarchy VLR".

namespace geom {
namespace {

constexpr std::size_t kInfo = 160;
constexpr std::size_t kEntry = 32;
constexpr int kDeepest = 30;  // levels, so that a key fits 31 bits
constexpr std::uint64_t kMostPages = 1 << 22;

[[noreturn]] void refuse(std::string_view source, Fault fault) {
  throw InputError(source, std::move(fault));
}

struct Page {
  std::uint64_t place;
  std::uint64_t bytes;
  friend auto operator<=>(const Page&, const Page&) = default;
};

class Hierarchy {
 public:
  Hierarchy(const ReadAt& read, std::string_view source) : read_(read), source_(source) {}

  std::vector<CopcNode> nodes(const Page& root) {
    open_.push_back(root);
    while (!open_.empty()) {
      const Page page = open_.back();
      open_.pop_back();
      read_page(page);
    }
    require_keys_once();
    std::sort(nodes_.begin(), nodes_.end(),
              [](const CopcNode& a, const CopcNode& b) { return a.place < b.place; });
    return std::move(nodes_);
  }

 private:
  void read_page(const Page& page) {
    if (page.bytes % kEntry != 0 || page.bytes == 0) {
      refuse(source_,
             {.expected = fmt::format("a page of its octree to have entries of {} bytes", kEntry),
              .found = fmt::format("{} bytes at {}", page.bytes, page.place)});
    }
    if (!seen_.insert(page.place).second || seen_.size() > kMostPages) {
      refuse(source_,
             {.says = fmt::format("a page of its octree, at byte {}, comes twice", page.place)});
    }
    const std::string bytes = read_whole(read_, page.place, page.bytes, source_);
    for (std::size_t at = 0; at < bytes.size(); at += kEntry) {
      take(reinterpret_cast<const unsigned char*>(bytes.data()) + at);
    }
  }

  void take(const unsigned char* entry) {
    CopcNode node;
    node.level = number_at<std::int32_t>(entry);
    node.x = number_at<std::int32_t>(entry + 4);
    node.y = number_at<std::int32_t>(entry + 8);
    node.z = number_at<std::int32_t>(entry + 12);
    node.place = number_at<std::uint64_t>(entry + 16);
    const auto bytes = number_at<std::int32_t>(entry + 24);
    const auto points = number_at<std::int32_t>(entry + 28);
    require_key(node);
    if (points == -1) {
      open_.push_back({node.place, static_cast<std::uint64_t>(std::max(bytes, 0))});
      return;
    }
    if (points < 0 || bytes < 0 || (points > 0) != (bytes > 0)) {
      refuse(source_, {.says = fmt::format(
                           "cube {}-{}-{}-{} of its octree is said to have {} points in {} bytes",
                           node.level, node.x, node.y, node.z, points, bytes)});
    }
    node.bytes = static_cast<std::uint32_t>(bytes);
    node.points = static_cast<std::uint32_t>(points);
    if (points > 0) nodes_.push_back(node);
  }

  void require_key(const CopcNode& node) const {
    const bool deep = node.level < 0 || node.level > kDeepest;
    const std::int32_t side = deep ? 0 : std::int32_t{1} << node.level;
    const auto inside = [&](std::int32_t v) { return v >= 0 && v < side; };
    if (!deep && inside(node.x) && inside(node.y) && inside(node.z)) return;
    refuse(source_, {.says = fmt::format("its octree has no cube {}-{}-{}-{}", node.level, node.x,
                                         node.y, node.z)});
  }

  void require_keys_once() {
    const auto key = [](const CopcNode& n) { return std::tie(n.level, n.x, n.y, n.z); };
    std::sort(nodes_.begin(), nodes_.end(),
              [&](const CopcNode& a, const CopcNode& b) { return key(a) < key(b); });
    const auto twice =
        std::adjacent_find(nodes_.begin(), nodes_.end(),
                           [&](const CopcNode& a, const CopcNode& b) { return key(a) == key(b); });
    if (twice == nodes_.end()) return;
    refuse(source_, {.says = fmt::format("cube {}-{}-{}-{} of its octree comes twice", twice->level,
                                         twice->x, twice->y, twice->z)});
  }

  const ReadAt& read_;
  std::string_view source_;
  std::vector<Page> open_;
  std::set<std::uint64_t> seen_;
  std::vector<CopcNode> nodes_;
};

}  // namespace

CopcInfo parse_copc_info(std::string_view data, std::string_view source) {
  if (data.size() < kInfo) refuse(source, {.says = "its record of COPC is cut short"});
  const auto* bytes = reinterpret_cast<const unsigned char*>(data.data());
  CopcInfo info;
  for (int i = 0; i < 3; ++i) info.centre[i] = number_at<double>(bytes + 8 * i);
  info.half = number_at<double>(bytes + 24);
  info.spacing = number_at<double>(bytes + 32);
  info.root = number_at<std::uint64_t>(bytes + 40);
  info.root_bytes = number_at<std::uint64_t>(bytes + 48);
  const auto length = [](double v) { return v > 0 && v <= kLargestCoordinate; };
  if (!(info.centre.cwiseAbs().maxCoeff() <= kLargestCoordinate) || !length(info.half) ||
      !length(info.spacing)) {
    refuse(source, {.expected = "a cube and a spacing of finite lengths > 0 in its record of COPC",
                    .found = fmt::format("{} and {}", info.half, info.spacing)});
  }
  return info;
}

Aabb CopcNode::cube(const CopcInfo& info) const {
  const double side = std::ldexp(2 * info.half, -level);
  const Vec3 low = info.centre - Vec3::Constant(info.half) + side * Vec3(x, y, z);
  return {low, low + Vec3::Constant(side)};
}

std::vector<CopcNode> read_copc_nodes(const ReadAt& read, const CopcInfo& info,
                                      std::string_view source) {
  return Hierarchy(read, source).nodes({info.root, info.root_bytes});
}

std::string read_whole(const ReadAt& read, std::uint64_t at, std::uint64_t bytes,
                       std::string_view source) {
  constexpr std::uint64_t kPiece = 1 << 24;
  std::string out;
  while (out.size() < bytes) {
    const std::size_t had = out.size();
    out.resize(had + std::min<std::uint64_t>(kPiece, bytes - had));
    const std::span<unsigned char> to(reinterpret_cast<unsigned char*>(out.data()) + had,
                                      out.size() - had);
    if (read(at + had, to) < to.size()) {
      refuse(
          source,
          {.says = fmt::format(
               "expected {} bytes at byte {}, and the file ends before: it is cut short or damaged",
               bytes, at)});
    }
  }
  return out;
}

}  // namespace geom
