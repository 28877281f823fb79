#include "geom/map/column_grid.h"

#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "cell_index.h"
#include "column_bands.h"
#include "column_shard.h"
#include "geom/base/parallel.h"
#include "geom/base/precondition.h"

namespace geom {
namespace {

constexpr std::size_t kShards = 1024;
constexpr std::size_t kBlock = std::size_t{1} << 15;  // points that a thread takes at once
// So many spans wait that what a processor fetches of the cells is used for several of them. With
// few of them a cloud takes half as long again.
constexpr std::size_t kWaiting = std::size_t{1} << 22;
constexpr std::size_t kWaitingBlocks = kWaiting / kBlock;
constexpr std::size_t kSome = kWaitingBlocks / 4;  // that a group is brought at once
constexpr std::size_t kTogether = 16;              // shards of a group
constexpr std::size_t kGroups = kShards / kTogether;
constexpr std::size_t kAhead = 64;  // points between the one that is fetched and the one in use

// The shard of a cell: by areas of 32 cells, so that points which are near to each other mostly
// meet in one, and by a hash of these, so that all shards get about the same number.
std::size_t shard_of(std::int32_t x, std::int32_t y) {
  const std::uint64_t area =
      std::uint64_t{static_cast<std::uint32_t>(y >> 5)} << 32 | static_cast<std::uint32_t>(x >> 5);
  return static_cast<std::size_t>((area * 0x9e3779b97f4a7c15u) >> 54);
}
static_assert(kShards == std::size_t{1} << (64 - 54));

struct Indices {
  explicit Indices(const ColumnSpec& spec) : cell(spec.cell), step(spec.step) {}

  CellIndex cell;
  CellIndex step;
};

// Calls f(CellSpan) for the cells that a point is in, or within its reach.
template <class F>
void for_each_cell(const Vec3& p, double reach, const Indices& of, const F& f) {
  if (reach == 0) {
    const std::int32_t low = of.step.floor(p.z());
    return f(CellSpan{of.cell.floor(p.x()), of.cell.floor(p.y()), {low, low + 1}});
  }
  HeightSpan span{of.step.floor(p.z() - reach), of.step.ceil(p.z() + reach)};
  if (span.low == span.high) ++span.high;  // on a step: some height, so that boxes join
  const std::int32_t x0 = of.cell.floor(p.x() - reach);
  const std::int32_t y0 = of.cell.floor(p.y() - reach);
  const std::int32_t x1 = of.cell.floor(p.x() + reach);
  const std::int32_t y1 = of.cell.floor(p.y() + reach);
  for (std::int32_t y = y0; y <= y1; ++y) {
    for (std::int32_t x = x0; x <= x1; ++x) f(CellSpan{x, y, span});
  }
}

// The spans of a block of points, by their shard. Its memory is used again for the next block.
class BinnedSpans {
 public:
  // `spans` is room for them in the order of the points.
  void bin(std::span<const Vec3> points, double reach, const Indices& indices,
           std::vector<CellSpan>& spans) {
    spans.clear();
    spans.reserve(points.size());
    begins_.fill(0);
    for (const Vec3& p : points) {
      __builtin_prefetch(&p + kAhead);
      for_each_cell(p, reach, indices, [&](const CellSpan& span) {
        spans.push_back(span);
        ++begins_[shard_of(span.x, span.y) + 1];
      });
    }
    for (std::size_t s = 1; s <= kShards; ++s) begins_[s] += begins_[s - 1];
    binned_.resize(std::max(binned_.size(), spans.size()));
    std::array<std::uint32_t, kShards> next;
    std::copy_n(begins_.begin(), kShards, next.begin());
    for (const CellSpan& span : spans) binned_[next[shard_of(span.x, span.y)]++] = span;
  }

  std::size_t size() const { return begins_[kShards]; }
  std::span<const CellSpan> of(std::size_t shard) const {
    return std::span(binned_).subspan(begins_[shard], begins_[shard + 1] - begins_[shard]);
  }

 private:
  std::vector<CellSpan> binned_;
  std::array<std::uint32_t, kShards + 1> begins_{};
};

void prefetch(std::span<const CellSpan> spans) {
  for (std::size_t i = 0; i < spans.size(); i += 64 / sizeof(CellSpan)) {
    __builtin_prefetch(&spans[i]);
  }
}

}  // namespace

// The cells are in shards, so that threads can add to different ones at the same time, and each
// finds what it changes in its cache. A cell is in one shard, and how its spans come out does not
// depend on the order in which they come.
struct ColumnGrid::Impl {
  explicit Impl(const ColumnSpec& s) : spec(s), indices(s) {
    require_size("cell", s.cell);
    require_size("step", s.step);
    require_length("gap", s.gap, kLargestCoordinate);
    gap = static_cast<std::int64_t>(std::min(std::floor(s.gap / s.step), 0x1p33));
  }

  void add(const CellSpan& span) { shards[shard_of(span.x, span.y)].add({&span, 1}, gap); }

  bool has_enough_waiting() const {
    std::size_t spans = 0;
    for (std::size_t b = 0; b < waiting; ++b) spans += blocks[b].size();
    return waiting >= kWaitingBlocks || spans >= kWaiting;
  }

  // Brings what waits for a group of shards to its cells.
  void add_waiting(std::size_t group) {
    std::vector<CellSpan> spans;  // of one shard
    for (std::size_t s = group * kTogether; s < (group + 1) * kTogether; ++s) {
      spans.clear();
      for (std::size_t b = added[group]; b < waiting; ++b) {
        if (b + 4 < waiting) prefetch(blocks[b + 4].of(s));
        const std::span<const CellSpan> some = blocks[b].of(s);
        spans.insert(spans.end(), some.begin(), some.end());
      }
      shards[s].add(spans, gap);
    }
    added[group] = waiting;
  }

  // Brings what waits in the blocks to its cells.
  void add_waiting(const Execution& run) {
    parallel_for(kGroups, {run.threads, {}}, [&](std::size_t group) { add_waiting(group); });
    added.fill(0);
    waiting = 0;
  }

  bool add_some_waiting() {
    if (waiting < added[next_group] + kSome) return false;
    add_waiting(next_group);
    next_group = (next_group + 1) % kGroups;
    return true;
  }

  // By y, then x.
  std::vector<ColumnTile> tiles() const {
    std::vector<ColumnTile> out;
    for (const ColumnShard& shard : shards) {
      for (const auto* tile : shard.tiles().sorted()) out.push_back({tile, &shard});
    }
    std::sort(out.begin(), out.end(), [](const ColumnTile& a, const ColumnTile& b) {
      return std::tie(a.tile->y, a.tile->x) < std::tie(b.tile->y, b.tile->x);
    });
    return out;
  }

  ColumnSpec spec;
  Indices indices;
  std::int64_t gap;  // steps; no two are 2^33 apart
  std::vector<ColumnShard> shards{kShards};
  std::vector<BinnedSpans> blocks;
  std::vector<CellSpan> room;  // for a block that comes alone: the system takes its time to give it
  std::size_t waiting = 0;     // blocks with spans that are not in all shards yet, the first ones
  std::array<std::size_t, kGroups> added{};  // blocks whose spans are in the shards of a group
  std::size_t next_group = 0;                // that is brought what waits for it
};

ColumnGrid::ColumnGrid(const ColumnSpec& spec) : impl_(std::make_unique<Impl>(spec)) {}

// The tiles of a large grid are many small pieces, which the C library would keep: what is made of
// the boxes takes as much again.
ColumnGrid::~ColumnGrid() {
  constexpr std::size_t kLarge = 4096;
  std::size_t tiles = 0;
  if (impl_) {
    for (const ColumnShard& shard : impl_->shards) tiles += shard.tiles().size();
  }
  impl_.reset();
#ifdef __GLIBC__
  if (tiles >= kLarge) malloc_trim(0);
#endif
}

ColumnGrid::ColumnGrid(ColumnGrid&&) noexcept = default;

void ColumnGrid::add(const Vec3& p, double reach) {
  for_each_cell(p, reach, impl_->indices, [&](const CellSpan& span) { impl_->add(span); });
}

void ColumnGrid::add(std::span<const Vec3> points, double reach, const Execution& run) {
  const std::size_t count = (points.size() + kBlock - 1) / kBlock;
  const std::size_t first = impl_->waiting;
  std::vector<BinnedSpans>& blocks = impl_->blocks;
  if (blocks.size() < first + count) blocks.resize(first + count);
  parallel_for(count, {run.threads, {}}, [&](std::size_t b) {
    const std::size_t begin = b * kBlock;
    std::vector<CellSpan> own;
    blocks[first + b].bin(points.subspan(begin, std::min(kBlock, points.size() - begin)), reach,
                          impl_->indices, count == 1 ? impl_->room : own);
  });
  impl_->waiting += count;
  if (impl_->has_enough_waiting()) impl_->add_waiting(run);
}

bool ColumnGrid::sort_some() { return impl_->add_some_waiting(); }

BoxTable ColumnGrid::boxes(std::string_view source, const Execution& run) {
  impl_->add_waiting(run);
  impl_->blocks = {};
  impl_->room = {};
  return boxes_of_columns(impl_->tiles(), impl_->spec, source, run);
}

}  // namespace geom
