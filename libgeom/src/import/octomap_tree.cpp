// OctoMap's binary trees (`.bt`), read by liboctomap: a box a leaf, whose ids count the boxes from
// 0. The bounds are those of all cells seen, free or occupied. Cells within them that were never
// seen are those of the octree, clipped.

#include <fmt/format.h>
#include <octomap/OcTree.h>

#include <iterator>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/import/import_boxes.h"
#include "geom/text/beginning.h"
#include "geom/text/counted.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

constexpr int kDepth = 16;

[[noreturn]] void refuse(std::string_view source, Fault fault) {
  throw InputError(source, std::move(fault));
}

struct Header {
  double resolution = 0;
  std::size_t data = 0;  // where the tree starts
};

Header read_header(const std::string& bytes, std::string_view source) {
  if (!bytes.starts_with("# Octomap OcTree binary file")) {
    refuse(source,
           {.expected = "\"# Octomap OcTree binary file\"",
            .found = in_quotes(bytes.substr(0, std::min<std::size_t>(40, bytes.find('\n'))))});
  }
  Header header;
  std::string id;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos) break;
    const std::string_view line = trimmed(std::string_view(bytes).substr(at, end - at));
    at = end + 1;
    if (line.starts_with("id ")) id = trimmed(line.substr(3));
    if (line.starts_with("res ")) {
      const auto value = parse_number(trimmed(line.substr(4)));
      // 2^15 cells to each side of the origin must stay within readable coordinates.
      if (!value || !(*value > 1e-6 && *value <= kLargestCoordinate / 32768)) {
        refuse(source,
               {.key = "res",
                .expected = fmt::format("a number in (1e-6, {}]", kLargestCoordinate / 32768),
                .found = in_quotes(line.substr(4, 40))});
      }
      header.resolution = *value;
    }
    if (line == "data") {
      header.data = at;
      break;
    }
  }
  if (id != "OcTree") {
    refuse(source, {.expected = "a tree of id OcTree", .found = in_quotes(id.substr(0, 40))});
  }
  if (header.resolution == 0 || header.data == 0) {
    refuse(source, {.says = "expected a header with res and data, and one is missing"});
  }
  return header;
}

// liboctomap recurses as deep as the bytes ask it to, so they are walked here first: two bytes an
// inner node, two bits a child, 11 being an inner node again.
void walk(const std::string& bytes, std::size_t& at, int level, std::string_view source) {
  if (level > kDepth)
    refuse(source, {.says = fmt::format("the tree is deeper than {} levels", kDepth)});
  if (bytes.size() - at < 2)
    refuse(source, {.says = "the tree is not complete", .advice = "the file was cut"});
  const unsigned bits = static_cast<unsigned char>(bytes[at]) |
                        static_cast<unsigned>(static_cast<unsigned char>(bytes[at + 1])) << 8;
  at += 2;
  if (bits == 0)
    refuse(source, {.expected = "at least one child of each inner node", .found = "one with none"});
  for (int child = 0; child < 8; ++child) {
    if ((bits >> (2 * child) & 3) == 3) walk(bytes, at, level + 1, source);
  }
}

class Reader {
 public:
  Reader(const octomap::OcTree& tree, bool unknown_blocked)
      : tree_(tree), unknown_blocked_(unknown_blocked) {}

  ImportedBoxes read() {
    out_.table.labels = {"", "unknown"};
    visit_seen(tree_.getRoot(), root());
    if (out_.bounds) visit_unknown(tree_.getRoot(), root());
    return std::move(out_);
  }

  std::size_t free() const { return free_; }  // leaves

 private:
  using Node = octomap::OcTreeNode;

  struct Cube {
    Eigen::Vector3i low;  // in smallest cells
    int size;
  };

  static Cube root() { return {Eigen::Vector3i::Constant(-32768), 65536}; }

  static Cube child(const Cube& cube, unsigned i) {
    const int half = cube.size / 2;
    return {cube.low + half * Eigen::Vector3i(i & 1, i >> 1 & 1, i >> 2 & 1), half};
  }

  Aabb box(const Cube& cube) const {
    return {cube.low.cast<double>() * tree_.getResolution(),
            (cube.low.array() + cube.size).matrix().cast<double>() * tree_.getResolution()};
  }

  void add(const Aabb& box, std::uint32_t label) {
    out_.table.add(box, out_.table.boxes.size(), label);
  }

  void visit_seen(const Node* node, const Cube& cube) {
    if (tree_.nodeHasChildren(node)) {
      for (unsigned i = 0; i < 8; ++i) {
        if (tree_.nodeChildExists(node, i)) visit_seen(tree_.getNodeChild(node, i), child(cube, i));
      }
      return;
    }
    const Aabb cell = box(cube);
    out_.bounds = out_.bounds ? merged(*out_.bounds, cell) : cell;
    if (tree_.isNodeOccupied(node)) {
      add(cell, 0);
    } else {
      ++free_;
    }
  }

  void visit_unknown(const Node* node, const Cube& cube) {
    if (node && !tree_.nodeHasChildren(node)) return;
    for (unsigned i = 0; node && i < 8; ++i) {
      const bool seen = tree_.nodeChildExists(node, i);
      visit_unknown(seen ? tree_.getNodeChild(node, i) : nullptr, child(cube, i));
    }
    if (node) return;
    Aabb cell = box(cube);
    cell = {cell.min.cwiseMax(out_.bounds->min), cell.max.cwiseMin(out_.bounds->max)};
    if ((cell.min.array() >= cell.max.array()).any()) return;
    ++out_.unknown;
    if (unknown_blocked_) add(cell, 1);
  }

  const octomap::OcTree& tree_;
  const bool unknown_blocked_;
  ImportedBoxes out_;
  std::size_t free_ = 0;
};

ImportedBoxes read_octomap(std::istream& in, std::string_view source,
                           const ImportOptions& options) {
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  const Header header = read_header(bytes, source);
  std::size_t end = header.data;
  walk(bytes, end, 1, source);
  if (end != bytes.size()) {
    refuse(source, {.expected = fmt::format("the file to end with its tree, at byte {}", end),
                    .found = fmt::format("{} more", counted(bytes.size() - end, "byte"))});
  }
  octomap::OcTree tree(header.resolution);
  TextInput data(bytes.substr(header.data));
  tree.readBinaryData(data);  // readBinary, which reads the header as well, prints
  if (!data || !tree.getRoot())
    refuse(source,
           {.says = "found a tree that liboctomap cannot read", .advice = "the file is damaged"});
  Reader reader(tree, options.unknown_blocked);
  ImportedBoxes out = reader.read();
  if (out.table.boxes.empty()) {
    refuse(source, {.expected = "at least one occupied cell",
                    .found = fmt::format("none ({} free)", reader.free())});
  }
  return out;
}

constexpr std::string_view kReaders[] = {"skyway-import"};
constexpr Format kFormat{.word = "octomap",
                         .what = "an OctoMap (.bt)",
                         .begins = begins_with<"# Octomap OcTree binary">,
                         .readers = kReaders};

}  // namespace

constinit const BoxFormat kOctomapTree{.format = &kFormat,
                                       .may_be = begins_with<"# Octomap">,
                                       .read = read_octomap,
                                       .has_unknown = true};

}  // namespace geom
