#pragma once

// Indices of boxes that a search of a region found.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace geom {

// Few are kept in place, as many searches find few.
class MeetingBoxes {
 public:
  // Room for so many more, of which `keep` says how many count.
  std::size_t* room(std::size_t count) {
    if (few_count_ + count > kFew) spill(count);
    return few_.data() + few_count_;
  }
  void keep(std::size_t count) { few_count_ += count; }

  std::size_t size() const { return more_.size() + few_count_; }

  // Ascending.
  std::vector<std::size_t> sorted() {
    if (more_.empty() && few_count_ <= kRanked) return ranked();
    spill(0);
    std::sort(more_.begin(), more_.end());
    return std::move(more_);
  }

 private:
  static constexpr std::size_t kFew = 192;
  static constexpr std::size_t kRanked = 24;  // about where a sort is as fast

  // No branch depends on the numbers, which come in no order.
  std::vector<std::size_t> ranked() const {
    std::vector<std::size_t> out(few_count_);
    for (std::size_t i = 0; i < few_count_; ++i) {
      std::size_t rank = 0;
      for (std::size_t j = 0; j < few_count_; ++j) rank += few_[j] < few_[i] ? 1 : 0;
      out[rank] = few_[i];
    }
    return out;
  }

  void spill(std::size_t next) {
    more_.reserve(std::max(2 * more_.size(), more_.size() + few_count_ + next));
    more_.insert(more_.end(), few_.begin(), few_.begin() + static_cast<std::ptrdiff_t>(few_count_));
    few_count_ = 0;
  }

  std::array<std::size_t, kFew> few_;
  std::size_t few_count_ = 0;
  std::vector<std::size_t> more_;
};

}  // namespace geom
