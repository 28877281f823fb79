#include "embree_tree.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <type_traits>
#include <vector>

#include "filled_tree.h"

namespace geom {
namespace {

constexpr unsigned kMostBuiltDepth = 32;
static_assert(kMostBuiltDepth < BoxTree::kMostDepth);

[[noreturn]] void throw_error(RTCError error) {
  switch (error) {
    case RTC_ERROR_OUT_OF_MEMORY:
      throw std::bad_alloc();
    case RTC_ERROR_UNSUPPORTED_CPU:
      throw std::runtime_error("Embree does not support this processor");
    default:
      throw std::runtime_error("Embree could not build the collision structure");
  }
}

// What Embree's builder asks back: places for nodes, of which there is one for each box from the
// start, so that no callback needs memory.
class Nodes {
 public:
  explicit Nodes(std::size_t boxes)
      : nodes_(std::make_unique_for_overwrite<BoxNode[]>(boxes)), room_(boxes) {}

  BoxNode* add() noexcept {
    const std::size_t place = used_.fetch_add(1);
    if (place >= room_) return nullptr;
    nodes_[place] = empty_node();
    return &nodes_[place];
  }

  // What Embree is told of a child: a node, or a box by an odd number, as nodes are aligned.
  static void* name_of_box(unsigned box) noexcept {
    return reinterpret_cast<void*>(std::uintptr_t{box} << 1 | 1);
  }
  std::uint32_t child(const void* name) const noexcept {
    const auto bits = reinterpret_cast<std::uintptr_t>(name);
    if ((bits & 1) != 0) return BoxNode::kBox | static_cast<std::uint32_t>(bits >> 1);
    return static_cast<std::uint32_t>(static_cast<const BoxNode*>(name) - nodes_.get());
  }

  bool enough() const { return used_ <= room_; }
  std::span<const BoxNode> all() const { return {nodes_.get(), used_.load()}; }

 private:
  std::unique_ptr<BoxNode[]> nodes_;
  std::size_t room_;
  std::atomic<std::size_t> used_ = 0;  // counts on where there are too many, which has no tree
};

template <class Bounds>
void set_lane(BoxNode& node, unsigned k, const Bounds& bounds) noexcept {
  node.plane[0][k] = bounds.lower_x;
  node.plane[1][k] = bounds.lower_y;
  node.plane[2][k] = bounds.lower_z;
  node.plane[3][k] = bounds.upper_x;
  node.plane[4][k] = bounds.upper_y;
  node.plane[5][k] = bounds.upper_z;
}

void* create_node(RTCThreadLocalAllocator, unsigned, void* nodes) noexcept {
  return static_cast<Nodes*>(nodes)->add();
}

void set_bounds(void* at, const RTCBounds** bounds, unsigned count, void*) noexcept {
  if (!at) return;
  for (unsigned k = 0; k < count; ++k) set_lane(*static_cast<BoxNode*>(at), k, *bounds[k]);
}

void set_children(void* at, void** children, unsigned count, void* nodes) noexcept {
  if (!at) return;
  for (unsigned k = 0; k < count; ++k) {
    static_cast<BoxNode*>(at)->child[k] = static_cast<Nodes*>(nodes)->child(children[k]);
  }
}

// A few boxes share a node.
void* create_leaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* boxes, std::size_t count,
                  void* nodes) noexcept {
  if (count == 1) return Nodes::name_of_box(boxes->primID);
  BoxNode* const node = static_cast<Nodes*>(nodes)->add();
  for (unsigned k = 0; node && k < count; ++k) {
    set_lane(*node, k, boxes[k]);
    node->child[k] = BoxNode::kBox | boxes[k].primID;
  }
  return node;
}

std::vector<RTCBuildPrimitive> primitives(std::span<const Aabb> boxes, const TreeFrame& frame) {
  std::vector<RTCBuildPrimitive> out(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Aabb& box = boxes[i];
    out[i] = {frame.low(box, 0),  frame.low(box, 1),  frame.low(box, 2),  0,
              frame.high(box, 0), frame.high(box, 1), frame.high(box, 2), static_cast<unsigned>(i)};
  }
  return out;
}

struct ReleaseBvh {
  void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};
using Bvh = std::unique_ptr<std::remove_pointer_t<RTCBVH>, ReleaseBvh>;

// What one build is about; the root is none until it worked.
struct Build {
  RTCDevice device;
  std::span<RTCBuildPrimitive> boxes;
  Nodes* nodes;
  const void* root = nullptr;
};

// Returns the first error that Embree kept to itself. May throw std::bad_alloc all the same: where
// there is no memory to keep the error in.
RTCError run(Build& build, Bvh& bvh) {
  // The thread's error has its place from the first look at it on, which may itself fail and leave
  // an error behind.
  if (rtcGetDeviceError(build.device) && rtcGetDeviceError(build.device)) {
    return RTC_ERROR_OUT_OF_MEMORY;
  }
  bvh.reset(rtcNewBVH(build.device));
  if (!bvh) return rtcGetDeviceError(build.device);
  RTCBuildArguments args = rtcDefaultBuildArguments();
  args.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  args.maxBranchingFactor = BoxNode::kLanes;
  args.maxDepth = kMostBuiltDepth;
  args.sahBlockSize = BoxNode::kLanes;
  args.maxLeafSize = BoxNode::kLanes;
  args.minLeafSize = BoxNode::kLanes;  // else a few boxes would be split once more
  args.bvh = bvh.get();
  args.primitives = build.boxes.data();
  args.primitiveCount = build.boxes.size();
  args.primitiveArrayCapacity = build.boxes.size();
  args.createNode = create_node;
  args.setNodeBounds = set_bounds;
  args.setNodeChildren = set_children;
  args.createLeaf = create_leaf;
  args.userPtr = build.nodes;
  build.root = rtcBuildBVH(&args);
  return rtcGetDeviceError(build.device);
}

// The same on a thread that ends with it.
RTCError run_apart(Build& build, Bvh& bvh) {
  RTCError error = RTC_ERROR_OUT_OF_MEMORY;
  try {
    std::thread([&]() noexcept {
      try {
        error = run(build, bvh);
      } catch (const std::bad_alloc&) {
      }
    }).join();
  } catch (const std::system_error&) {  // no room for a thread
  }
  return error;
}

// A build that failed is kept to the end of the process: releasing it ends the process where tasks
// of it were left behind. They may still refer to its nodes.
struct HalfBuilt {
  Nodes nodes;
  std::vector<RTCBuildPrimitive> boxes;
  Bvh bvh = nullptr;
  HalfBuilt* next = nullptr;
};

void keep(std::unique_ptr<HalfBuilt> build) noexcept {
  static std::atomic<HalfBuilt*> all = nullptr;
  HalfBuilt* const node = build.release();
  node->next = all.load();
  while (!all.compare_exchange_weak(node->next, node)) {
  }
}

BuiltTree tree_of_one(const TreeFrame& frame, const RTCBuildPrimitive& box) {
  Nodes nodes(1);
  BoxNode& node = *nodes.add();
  set_lane(node, 0, box);
  node.child[0] = BoxNode::kBox;
  return filled_tree(frame, nodes.all(), 1);
}

struct Started {
  RTCDevice device = nullptr;
  RTCError error = RTC_ERROR_OUT_OF_MEMORY;
};

Started start() noexcept {
  Started out;
  try {
    out.device = rtcNewDevice("threads=1");
    if (!out.device) out.error = rtcGetDeviceError(nullptr);
  } catch (const std::bad_alloc&) {  // not even the error could be kept
  }
  return out;
}

// The process's one device, which is never released: memory that runs out while Embree starts or
// stops leaves what all its devices share in disorder, so it does either at most once.
RTCDevice embree_device() {
  static const Started embree = start();
  if (!embree.device) throw_error(embree.error);
  return embree.device;
}

}  // namespace

void start_embree() { embree_device(); }

// Where memory runs out inside a build, what Embree keeps of its thread may refer to memory that is
// gone, and the thread's next build would write there. So from the first failure in a process on,
// each build has a thread of its own.
BuiltTree embree_tree(std::span<const Aabb> boxes, const TreeFrame& frame) {
  static std::atomic<bool> any_failed = false;
  const RTCDevice device = embree_device();
  std::unique_ptr<HalfBuilt> half(new HalfBuilt{Nodes(boxes.size()), primitives(boxes, frame)});
  if (boxes.size() == 1) return tree_of_one(frame, half->boxes.front());
  Build build{device, half->boxes, &half->nodes};
  RTCError error = RTC_ERROR_OUT_OF_MEMORY;
  try {
    error = (any_failed ? run_apart : run)(build, half->bvh);
  } catch (const std::bad_alloc&) {
  }
  if (error == RTC_ERROR_NONE && build.root && half->nodes.enough()) {
    return filled_tree(frame, half->nodes.all(), boxes.size());
  }
  any_failed = true;
  keep(std::move(half));
  throw_error(error);
}

}  // namespace geom
