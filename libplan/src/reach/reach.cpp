#include "plan/reach/reach.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "free_cells.h"
#include "geom/base/error.h"

namespace plan {
namespace {

using geom::Aabb;

constexpr std::size_t kMostNodes = std::size_t{1} << 23;  // kept from one question to the next
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Where two cells that share a part of a face do so; a box that is flat.
Aabb shared(const Aabb& a, const Aabb& b) { return {a.min.cwiseMax(b.min), a.max.cwiseMin(b.max)}; }

Vec3 middle(const Aabb& box) { return box.min + 0.5 * (box.max - box.min); }

double squared_distance(const Aabb& box, const Vec3& p) {
  return (p.cwiseMax(box.min).cwiseMin(box.max) - p).squaredNorm();
}

// What was found from one end.
class Flood {
 public:
  Flood(FreeCells& cells, std::uint32_t first, const Vec3& towards)
      : cells_(cells), towards_(towards) {
    add(first, kNone);
  }

  bool done() const { return queue_.empty(); }
  bool has(std::uint32_t cell) const { return from_.contains(cell); }
  std::size_t size() const { return found_.size(); }

  // Looks around the next cell. The first new one that the other flood has, if any.
  std::optional<std::uint32_t> step(const Flood& other) {
    const std::uint32_t cell = queue_.top().cell;
    queue_.pop();
    cells_.neighbours(cell, near_);
    for (const std::uint32_t next : near_) {
      if (has(next)) continue;
      add(next, cell);
      if (other.has(next)) return next;
    }
    return std::nullopt;
  }

  std::vector<Aabb> all() const {
    std::vector<Aabb> out;
    for (const std::uint32_t cell : found_) out.push_back(cells_.region(cell));
    return out;
  }

  // From a cell back to the first.
  std::vector<Aabb> back_from(std::uint32_t cell) const {
    std::vector<Aabb> out;
    for (; cell != kNone; cell = from_.at(cell)) out.push_back(cells_.region(cell));
    return out;
  }

 private:
  struct Entry {
    double distance;
    Vec3 corner;  // ties go by place, so that no order of questions matters
    std::uint32_t cell;

    bool operator<(const Entry& other) const {
      const auto key = [](const Entry& e) {
        return std::make_tuple(e.distance, e.corner.x(), e.corner.y(), e.corner.z());
      };
      return key(other) < key(*this);
    }
  };

  void add(std::uint32_t cell, std::uint32_t from) {
    from_.emplace(cell, from);
    found_.push_back(cell);
    const Aabb& region = cells_.region(cell);
    queue_.push({squared_distance(region, towards_), region.min, cell});
  }

  FreeCells& cells_;
  Vec3 towards_;
  std::unordered_map<std::uint32_t, std::uint32_t> from_;  // where each cell was seen from
  std::vector<std::uint32_t> found_;
  std::priority_queue<Entry> queue_;
  std::vector<std::uint32_t> near_;
};

ReachResult connected(const Flood& start, const Flood& goal, std::uint32_t meeting) {
  ReachResult result;
  result.answer = Reachable::yes;
  result.cells = start.back_from(meeting);
  std::reverse(result.cells.begin(), result.cells.end());
  const std::vector<Aabb> rest = goal.back_from(meeting);
  result.cells.insert(result.cells.end(), rest.begin() + 1, rest.end());
  return result;
}

ReachResult apart(const Flood& flood, bool from_start) {
  ReachResult result;
  result.answer = Reachable::no;
  result.cells = flood.all();
  result.from_start = from_start;
  return result;
}

// One step from each end in turn.
ReachResult joined(Flood& start, Flood& goal, std::size_t most) {
  while (start.size() + goal.size() <= most) {
    if (start.done()) return apart(start, true);
    if (const auto met = start.step(goal)) return connected(start, goal, *met);
    if (goal.done()) return apart(goal, false);
    if (const auto met = goal.step(start)) return connected(start, goal, *met);
  }
  return {};
}

void require_free(const geom::CollisionScene& scene, const Vec3& p, const char* end) {
  if (!scene.free(p)) throw geom::InputError(end, {.expected = "a place that is free"});
}

}  // namespace

struct Reach::Impl {
  explicit Impl(const geom::CollisionScene& of) : scene(of) {}

  const geom::CollisionScene& scene;
  std::mutex mutex;
  std::optional<FreeCells> cells;
};

Reach::Reach(const geom::CollisionScene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Reach::~Reach() = default;

ReachResult Reach::ask(const Vec3& from, const Vec3& to, std::size_t most) {
  require_free(impl_->scene, from, "start");
  require_free(impl_->scene, to, "goal");
  const std::lock_guard lock(impl_->mutex);
  if (!impl_->cells || impl_->cells->size() > kMostNodes) impl_->cells.emplace(impl_->scene);
  FreeCells& cells = *impl_->cells;
  const std::uint32_t first = cells.cell_at(from);
  const std::uint32_t last = cells.cell_at(to);
  Flood start(cells, first, to);
  ReachResult result;
  std::size_t looked_at = 1;
  if (first == last) {
    result = {Reachable::yes, {cells.region(first)}, true, 0};
  } else {
    Flood goal(cells, last, from);
    result = joined(start, goal, most);
    looked_at = start.size() + goal.size();
  }
  result.looked_at = looked_at;
  return result;
}

geom::Polyline way_through(const std::vector<Aabb>& cells, const Vec3& from, const Vec3& to) {
  geom::Polyline way = {from};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) way.push_back(middle(shared(cells[i - 1], cells[i])));
    way.push_back(middle(cells[i]));
  }
  way.push_back(to);
  way.erase(std::unique(way.begin(), way.end()), way.end());
  return way;
}

}  // namespace plan
