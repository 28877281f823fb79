#include "mission_jumps.h"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "geom/base/error.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace traj {
namespace {

struct Jump {
  std::size_t to = 0;    // index of an item
  std::size_t left = 0;  // how often it is still taken
};

class Order {
 public:
  Order(const Mission& mission, std::string_view source) : items_(mission.items), source_(source) {
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (!at_.emplace(items_[i].number, i).second) twice_.insert(items_[i].number);
    }
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (items_[i].command == kJump) jumps_.emplace(i, jump(items_[i]));
    }
  }

  std::size_t endless() const { return endless_; }

  std::vector<std::size_t> flown() {
    std::vector<std::size_t> order;
    std::size_t steps = 0;
    for (std::size_t i = 0; i < items_.size(); ++steps) {
      if (steps >= kMostItems) {
        refuse_item(source_, items_[i],
                    {.expected = fmt::format("at most {} items with all jumps taken", kMostItems),
                     .found = "more"});
      }
      const auto jump = jumps_.find(i);
      if (jump == jumps_.end()) {
        order.push_back(i++);
      } else if (jump->second.left == 0) {
        ++i;
      } else {
        --jump->second.left;
        i = jump->second.to;
      }
    }
    return order;
  }

 private:
  Jump jump(const MissionItem& item) {
    const double to = item.param[0];
    const double times = item.param[1];
    const auto place = to >= 0 && to < 1e9 && to == std::floor(to)
                           ? at_.find(static_cast<std::size_t>(to))
                           : at_.end();
    if (place == at_.end()) {
      refuse_item(source_, item,
                  {.expected = "a jump to an item", .found = fmt::format("one to {}", to)});
    }
    if (twice_.contains(items_[place->second].number)) {
      refuse_item(source_, item,
                  {.expected = "a jump to one item",
                   .found = fmt::format("several with the number {}", to)});
    }
    if (times < 0) {
      ++endless_;
      return {place->second, 2};
    }
    if (!(times <= 1e9) || times != std::floor(times)) {
      refuse_item(
          source_, item,
          {.expected = "a jump taken a whole number of times", .found = fmt::to_string(times)});
    }
    return {place->second, static_cast<std::size_t>(times)};
  }

  const std::vector<MissionItem>& items_;
  std::string_view source_;
  std::size_t endless_ = 0;
  std::unordered_map<std::size_t, std::size_t> at_;  // by number
  std::unordered_set<std::size_t> twice_;            // numbers of several
  std::unordered_map<std::size_t, Jump> jumps_;
};

}  // namespace

std::vector<std::size_t> flown_order(const Mission& mission, std::string_view source,
                                     std::size_t& endless) {
  Order order(mission, source);
  endless = order.endless();
  return order.flown();
}

void refuse_item(std::string_view source, const MissionItem& item, geom::Fault fault) {
  if (!item.line) fault = within(fmt::format("item {}", item.number), std::move(fault));
  throw geom::InputError(source, item.line, std::move(fault));
}

}  // namespace traj
