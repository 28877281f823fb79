#include <fmt/format.h>

#include <cstdint>

#include "byte_source.h"
#include "copc_hierarchy.h"
#include "geom/base/in_order.h"
#include "geom/base/text_stream.h"
#include "geom/cloud/copc.h"
#include "las_header.h"
#include "las_records.h"
#include "laz_chunk.h"
#include "point_chunks.h"

namespace geom {
namespace {

constexpr std::size_t kHead = 589;            // the header, and the record of COPC behind it
constexpr std::uint64_t kMostHead = 1 << 26;  // records before the points
constexpr std::size_t kLaterHead = 60;

[[noreturn]] void refuse(std::string_view source, Fault fault) {
  throw InputError(source, std::move(fault));
}

class Reader {
 public:
  Reader(const ReadAt& read, std::string_view source)
      : read_([&read, this](std::uint64_t at, std::span<unsigned char> to) {
          const std::size_t got = read(at, to);
          counts_.bytes += got;
          return got;
        }),
        source_(source) {}

  CopcCounts run(const CopcChooser& choose, const PointSink& sink, const Execution& run) {
    read_head();
    nodes_ = read_copc_nodes(read_, info_, source_);
    require_all_accounted_for();
    const CopcPart part = choose(reference_);
    const int deepest = deepest_level(part);
    std::vector<CopcNode> wanted;
    std::uint64_t most = 0;
    for (const CopcNode& node : nodes_) {
      if (part.region && !meets(node, *part.region)) {
        counts_.outside += node.points;
      } else if (node.level > deepest) {
        counts_.finer += node.points;
      } else {
        wanted.push_back(node);
        most = std::max<std::uint64_t>(most, node.points);
      }
    }
    if (counts_.finer > 0) counts_.spacing = std::ldexp(info_.spacing, -deepest);
    PointChunks chunks(source_, sink);
    auto next = wanted.begin();
    in_order<NodeChunk>(
        run, laz_window(run, most),
        [&]() -> std::optional<NodeChunk> {
          if (next == wanted.end()) return std::nullopt;
          const CopcNode& node = *next++;
          return NodeChunk{&node, read_chunk(node)};
        },
        [&](NodeChunk& read) { read.chunk.decode(setup_, source_); },
        [&](const NodeChunk& read) { take(read, part, chunks); });
    counts_.cloud = chunks.finish();
    return counts_;
  }

 private:
  struct NodeChunk {
    const CopcNode* node;
    LazChunk chunk;
  };

  void read_head() {
    std::string head = read_whole(read_, 0, kHead, source_);
    if (!is_copc(head)) refuse(source_, {.expected = "a COPC file", .found = "another"});
    const auto points = number_at<std::uint32_t>(reinterpret_cast<unsigned char*>(&head[96]));
    if (points > kMostHead) {
      refuse(source_, {.expected = fmt::format("points within {} bytes", kMostHead),
                       .found = fmt::format("them at byte {}", points)});
    }
    if (points > kHead) head += read_whole(read_, kHead, points - kHead, source_);
    TextInput in(head);
    header_ = read_las_header(in, source_);
    LasRecords records = read_las_records(in, header_, source_);
    if (!header_.compressed || header_.format < 6 || header_.format > 8 ||
        records.laz->layout != LazSetup::Layout::layers || !records.laz->chunks_vary()) {
      refuse(source_,
             {.expected = "LAZ of point format 6 to 8 in chunks that vary, as COPC has it"});
    }
    reference_ = records.reference;
    setup_ = std::move(*records.laz);
    info_ = parse_copc_info(records.copc, source_);
    tolerance_ = 2 * header_.scale.cwiseAbs();
    counts_.all = header_.points;
    require_whole_later_records();
    require_told_before(records.references);
  }

  void require_whole_later_records() {
    std::uint64_t at = header_.later_records;
    for (std::uint32_t i = 0; i < header_.later_count; ++i) {
      const std::string head = read_whole(read_, at, kLaterHead, source_);
      const auto length =
          number_at<std::uint64_t>(reinterpret_cast<const unsigned char*>(head.data()) + 20);
      if (length >= UINT64_MAX - kLaterHead - at) {  // it would lead back, and never end
        refuse(source_, {.says = fmt::format("a record after its points claims {} bytes", length)});
      }
      at += kLaterHead + length;
    }
  }

  // What follows the compressed points must say nothing of the coordinates that the records before
  // do not.
  void require_told_before(const LasReferences& told) {
    LaterReferences later(told, header_.well_known_text);
    std::vector<unsigned char> piece(1 << 16);
    std::uint64_t at = chunk_table();
    while (const std::size_t got = read_(at, piece)) {
      later.take({piece.data(), got});
      at += got;
    }
    later.finish();
  }

  // The place of the table of chunks, behind the last of them.
  std::uint64_t chunk_table() const {
    const std::string place = read_whole(read_, header_.data, 8, source_);
    return number_at<std::uint64_t>(reinterpret_cast<const unsigned char*>(&place[0]));
  }

  // Each point of the header and each byte between the first chunk and the table of chunks is of
  // one cube: none is forgotten.
  void require_all_accounted_for() {
    const std::uint64_t start = header_.data;
    const std::uint64_t table = chunk_table();
    std::uint64_t at = start + 8;
    std::uint64_t points = 0;
    for (const CopcNode& node : nodes_) {
      if (node.place != at) {
        refuse(source_,
               {.expected = fmt::format("the chunk of a cube of its octree at byte {}", at),
                .found = fmt::format("the next at {}", node.place),
                .advice = "chunks are missing, or come twice"});
      }
      at += node.bytes;
      points += node.points;
    }
    if (points != header_.points) {
      refuse(source_, {.says = fmt::format("its header counts {} points, and its octree {}",
                                           header_.points, points)});
    }
    if (at != table) {
      refuse(source_,
             {.says = fmt::format(
                  "its octree ends at byte {}, and its compressed points at {}: chunks are missing",
                  at, table)});
    }
  }

  int deepest_level(const CopcPart& part) const {
    int last = 0;
    for (const CopcNode& node : nodes_) last = std::max(last, node.level);
    if (!(part.resolution > 0)) return last;
    int level = 0;
    while (level < last && std::ldexp(info_.spacing, -level) > part.resolution) ++level;
    return level;
  }

  Aabb reach(const CopcNode& node) const {
    Aabb cube = node.cube(info_);
    // What doubles lose of a cube's place and of a point's.
    const Vec3 slack = tolerance_ + 1e-12 * (info_.centre.cwiseAbs() + Vec3::Constant(info_.half));
    cube.min -= slack;
    cube.max += slack;
    return cube;
  }

  bool meets(const CopcNode& node, const Aabb& region) const {
    const Aabb cube = reach(node);
    return cube.min.x() <= region.max.x() && cube.max.x() >= region.min.x() &&
           cube.min.y() <= region.max.y() && cube.max.y() >= region.min.y();
  }

  LazChunk read_chunk(const CopcNode& node) {
    const std::string chunk = read_whole(read_, node.place, node.bytes, source_);
    ByteSource bytes({reinterpret_cast<const unsigned char*>(chunk.data()), chunk.size()},
                     node.place, source_);
    LazChunk out = LazChunk::of_layers(bytes, setup_, node.points);
    if (out.points() == node.points && out.bytes() == node.bytes) return out;
    bytes.refuse({.says = fmt::format("cube {}-{}-{}-{} of its octree is said to have {} points in "
                                      "{} bytes, and has {} in {}",
                                      node.level, node.x, node.y, node.z, node.points, node.bytes,
                                      out.points(), out.bytes())});
  }

  void take(const NodeChunk& read, const CopcPart& part, PointChunks& chunks) {
    const Aabb cube = reach(*read.node);
    read.chunk.for_each(setup_, source_, [&](const LazPoint& raw) {
      const Vec3 p = Vec3(raw.x, raw.y, raw.z).cwiseProduct(header_.scale) + header_.offset;
      if (!contains(cube, p)) leaves_cube(*read.node, p);
      const bool inside =
          !part.region || (p.x() >= part.region->min.x() && p.x() <= part.region->max.x() &&
                           p.y() >= part.region->min.y() && p.y() <= part.region->max.y());
      if (inside) {
        chunks.add(p, raw.cls);
      } else {
        ++counts_.outside;
      }
    });
  }

  [[noreturn]] void leaves_cube(const CopcNode& node, const Vec3& p) const {
    refuse(source_, {.says = fmt::format(
                         "point [{}, {}, {}] lies outside its cube {}-{}-{}-{} of the octree",
                         p.x(), p.y(), p.z(), node.level, node.x, node.y, node.z),
                     .advice = "read the file whole, without bounds and resolution"});
  }

  CopcCounts counts_;
  ReadAt read_;
  std::string_view source_;
  LasHeader header_;
  LazSetup setup_;
  CopcInfo info_;
  CoordinateReference reference_;
  Vec3 tolerance_ = Vec3::Zero();
  std::vector<CopcNode> nodes_;
};

}  // namespace

bool is_copc(std::string_view head) {
  constexpr std::size_t kUser = 375 + 2;
  return head.size() >= kHead && head.starts_with("LASF") &&
         head.substr(kUser, 5) == std::string_view("copc\0", 5) && head[kUser + 16] == 1 &&
         head[kUser + 17] == 0;
}

CopcCounts read_copc(const ReadAt& read, std::string_view source, const CopcChooser& choose,
                     const PointSink& sink, const Execution& run) {
  return Reader(read, source).run(choose, sink, run);
}

}  // namespace geom
