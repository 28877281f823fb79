#include "plan/io/lattice_file.h"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "geom/error.h"
#include "geom/io/json_fields.h"

namespace plan {
namespace {

constexpr int kVersion = 1;
constexpr std::int64_t kSide = 8;  // nodes along a block's edge
constexpr std::size_t kBlock = kSide * kSide * kSide;
enum BlockState : std::uint8_t { kBlocked = 0, kFree = 1, kStored = 2 };

// The block grid of a lattice: calls f(block, local, node) in order of blocks, then of nodes.
class Blocks {
 public:
  explicit Blocks(const Index3& dims) : dims_(dims) {
    for (int k = 0; k < 3; ++k) count_[k] = (dims[k] + kSide - 1) / kSide;
  }

  std::size_t size() const { return static_cast<std::size_t>(count_[0] * count_[1] * count_[2]); }

  template <class F>
  void for_nodes(std::size_t block, const F& f) const {
    for_nodes(block, f, [](std::size_t) {});
  }

  // The same, and beyond(local) for the places of the block that are outside the lattice.
  template <class F, class G>
  void for_nodes(std::size_t block, const F& f, const G& beyond) const {
    const auto b = static_cast<std::int64_t>(block);
    const Index3 low = {b % count_[0] * kSide, b / count_[0] % count_[1] * kSide,
                        b / (count_[0] * count_[1]) * kSide};
    std::size_t local = 0;
    for (std::int64_t k = low[2]; k < low[2] + kSide; ++k) {
      for (std::int64_t j = low[1]; j < low[1] + kSide; ++j) {
        for (std::int64_t i = low[0]; i < low[0] + kSide; ++i, ++local) {
          if (i < dims_[0] && j < dims_[1] && k < dims_[2]) {
            f(local, Index3{i, j, k});
          } else {
            beyond(local);
          }
        }
      }
    }
  }

 private:
  Index3 dims_;
  Index3 count_{};
};

std::size_t node_of(const Index3& dims, const Index3& i) {
  return static_cast<std::size_t>(i[0] + dims[0] * (i[1] + dims[1] * i[2]));
}

// The half directions that stay inside the lattice.
std::uint32_t existing(const Index3& dims, const Index3& i, int directions) {
  std::uint32_t mask = 0;
  for (int d = 0; d < directions; ++d) {
    bool in = true;
    for (int k = 0; k < 3; ++k) {
      const std::int64_t v = i[k] + kDirection[d][k];
      in = in && v >= 0 && v < dims[k];
    }
    if (in) mask |= 1u << d;
  }
  return mask;
}

std::string meta_of(const Lattice& lattice) {
  const auto indices = [](const Index3& v) { return fmt::format("[{},{},{}]", v[0], v[1], v[2]); };
  std::string meta = fmt::format(R"({{"format":"skyway-lattice","version":{},)", kVersion);
  geom::append_json(meta, lattice.made_for());
  meta += "\"spacing\":";
  geom::append_json(meta, lattice.spec().spacing);
  meta += ",\"origin\":";
  geom::append_json(meta, lattice.spec().origin);
  meta += fmt::format(",\"connectivity\":{},\"first\":{},\"dims\":{},\"nodes\":{},\"edges\":{}}}\n",
                      static_cast<int>(lattice.spec().connectivity), indices(lattice.first()),
                      indices(lattice.dims()), lattice.free_nodes(), lattice.free_edges());
  return meta;
}

struct Meta {
  LatticeSpec spec;
  Index3 first;
  Index3 dims;
  geom::Provenance made_for;
};

Meta parse_meta(const geom::ArrayArchive& archive) {
  const geom::JsonFields fields(archive.meta(), archive.name(), 0);
  if (fields.text("format", "") != "skyway-lattice") {
    fields.refuse(fmt::format("expected a lattice (format \"skyway-lattice\"), found format \"{}\"",
                              fields.text("format", "")));
  }
  if (fields.number("version") != kVersion) {
    fields.refuse(fmt::format("expected lattice version {}, found {}", kVersion,
                              fields.number("version").value_or(0)));
  }
  Meta meta;
  meta.made_for = fields.provenance();
  meta.spec.spacing = fields.number("spacing").value_or(0);
  if (!(meta.spec.spacing > 0)) fields.refuse("spacing must be > 0");
  meta.spec.origin = fields.point("origin");
  const double connectivity = fields.number("connectivity").value_or(0);
  if (connectivity != 6 && connectivity != 18 && connectivity != 26) {
    fields.refuse(fmt::format("connectivity must be 6, 18 or 26, found {}", connectivity));
  }
  meta.spec.connectivity = static_cast<Connectivity>(static_cast<int>(connectivity));
  Vec3 first;  // not a point: with a small spacing the indices are larger than any coordinate
  const auto listed = fields.object().value("first", nlohmann::json());
  if (!listed.is_array() || listed.size() != 3) fields.refuse("first must be three whole numbers");
  for (int k = 0; k < 3; ++k) first[k] = fields.number(listed[k], "first");
  const Vec3 dims = fields.point("dims");
  for (int k = 0; k < 3; ++k) {
    if (first[k] != std::floor(first[k]) || dims[k] != std::floor(dims[k]) ||
        std::abs(first[k]) > 0x1p52) {
      fields.refuse("first and dims must be whole numbers");
    }
    meta.first[k] = static_cast<std::int64_t>(first[k]);
    meta.dims[k] = static_cast<std::int64_t>(dims[k]);
  }
  if (dims.minCoeff() < 1 || dims.x() * dims.y() * dims.z() > 2147483648.0) {
    fields.refuse("dims must be >= 1 and make at most 2^31 nodes");
  }
  return meta;
}

// Lower bits of one block, from its state or from what is stored.
class BlockReader {
 public:
  BlockReader(const geom::ArrayArchive& archive, const Meta& meta)
      : archive_(archive),
        meta_(meta),
        directions_(half_directions(meta.spec.connectivity)),
        nodes_(archive.array<std::uint8_t>("block_nodes", kBlock / 8)),
        edges_(archive.array<std::uint16_t>("block_edges", kBlock)) {}

  void read(const Blocks& blocks, std::size_t block, BlockState state,
            std::vector<std::uint32_t>& masks) {
    const std::size_t at = stored_ * kBlock;
    if (state == kStored && (at + kBlock > edges_.size() || at + kBlock > 8 * nodes_.size())) {
      refuse("more blocks are marked as stored than there are");
    }
    const auto stored_free = [&](std::size_t local) {
      return (nodes_[(at + local) / 8] >> (local % 8) & 1) != 0;
    };
    const auto in_lattice = [&](std::size_t local, const Index3& i) {
      const std::uint32_t possible = existing(meta_.dims, i, directions_);
      std::uint32_t mask = 0;
      if (state == kFree) mask = possible | Lattice::kNode;
      if (state == kStored) {
        const bool free = stored_free(local);
        mask = edges_[at + local] | (free ? Lattice::kNode : 0);
        if ((edges_[at + local] & ~possible) || (!free && edges_[at + local])) {
          refuse(fmt::format("node {} of block {} has an edge that cannot be", local, block));
        }
      }
      masks[node_of(meta_.dims, i)] = mask;
    };
    const auto beyond = [&](std::size_t local) {
      if (state == kStored && (stored_free(local) || edges_[at + local])) {
        refuse(fmt::format("place {} of block {} is outside the lattice, but not 0", local, block));
      }
    };
    blocks.for_nodes(block, in_lattice, beyond);
    stored_ += state == kStored;
  }

  void finish() const {
    if (stored_ * kBlock != edges_.size() || stored_ * kBlock != 8 * nodes_.size()) {
      refuse("fewer blocks are marked as stored than there are");
    }
  }

  int directions() const { return directions_; }
  [[noreturn]] void refuse(std::string_view message) const {
    throw geom::InputError(archive_.name(), message);
  }

 private:
  const geom::ArrayArchive& archive_;
  const Meta& meta_;
  int directions_;
  std::span<const std::uint8_t> nodes_;
  std::span<const std::uint16_t> edges_;
  std::size_t stored_ = 0;
};

void mirror(const Meta& meta, const BlockReader& reader, std::vector<std::uint32_t>& masks) {
  constexpr std::uint32_t kLower = (1u << kHalfDirections) - 1;
  for (std::size_t n = 0; n < masks.size(); ++n) {
    for (std::uint32_t lower = masks[n] & kLower; lower; lower &= lower - 1) {
      const int d = __builtin_ctz(lower);
      const std::size_t other =
          n + static_cast<std::size_t>(kDirection[d][0] +
                                       meta.dims[0] *
                                           (kDirection[d][1] + meta.dims[1] * kDirection[d][2]));
      if (!(masks[other] & Lattice::kNode)) {
        reader.refuse(fmt::format("node {} has an edge to a blocked node", n));
      }
      masks[other] |= 1u << (kHalfDirections + d);
    }
  }
}

}  // namespace

void write_lattice(std::ostream& out, const Lattice& lattice) {
  const Blocks blocks(lattice.dims());
  const int directions = half_directions(lattice.spec().connectivity);
  constexpr std::uint32_t kLower = (1u << kHalfDirections) - 1;
  std::vector<std::uint8_t> state(blocks.size());
  std::vector<std::uint8_t> nodes;
  std::vector<std::uint16_t> edges;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    bool any_free = false;
    bool all_free = true;
    blocks.for_nodes(b, [&](std::size_t, const Index3& i) {
      const std::uint32_t mask = lattice.mask(node_of(lattice.dims(), i));
      any_free = any_free || mask != 0;
      all_free = all_free && (mask & Lattice::kNode) &&
                 (mask & kLower) == existing(lattice.dims(), i, directions);
    });
    state[b] = all_free ? kFree : any_free ? kStored : kBlocked;
    if (state[b] != kStored) continue;
    const std::size_t at = edges.size();
    nodes.resize(nodes.size() + kBlock / 8);
    edges.resize(at + kBlock);
    blocks.for_nodes(b, [&](std::size_t local, const Index3& i) {
      const std::uint32_t mask = lattice.mask(node_of(lattice.dims(), i));
      if (mask & Lattice::kNode) {
        nodes[(at + local) / 8] |= static_cast<std::uint8_t>(1u << (local % 8));
      }
      edges[at + local] = static_cast<std::uint16_t>(mask & kLower);
    });
  }
  const geom::NamedArray arrays[] = {
      geom::named_array<std::uint8_t>("block_state", state),
      geom::named_array<std::uint8_t>("block_nodes", nodes, kBlock / 8),
      geom::named_array<std::uint16_t>("block_edges", edges, kBlock),
  };
  geom::write_array_archive(out, meta_of(lattice), arrays);
}

bool is_lattice(const geom::ArrayArchive& archive) {
  const geom::JsonFields fields(archive.meta(), archive.name(), 0);
  return fields.text("format", "") == "skyway-lattice";
}

Lattice read_lattice(const geom::ArrayArchive& archive) {
  const Meta meta = parse_meta(archive);
  const Blocks blocks(meta.dims);
  const auto state = archive.array<std::uint8_t>("block_state");
  BlockReader reader(archive, meta);
  if (state.size() != blocks.size()) {
    reader.refuse(fmt::format("expected {} blocks, found {}", blocks.size(), state.size()));
  }
  std::vector<std::uint32_t> masks(
      static_cast<std::size_t>(meta.dims[0] * meta.dims[1] * meta.dims[2]));
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (state[b] > kStored) reader.refuse(fmt::format("block {} has state {}", b, state[b]));
    reader.read(blocks, b, static_cast<BlockState>(state[b]), masks);
  }
  reader.finish();
  mirror(meta, reader, masks);
  return Lattice(meta.spec, meta.first, meta.dims, meta.made_for, std::move(masks));
}

}  // namespace plan
