#include "search_pages.h"

namespace plan {

void SearchPages::clear() {
  pages_.clear();
  page_of_block_.clear();
}

NodeHandle SearchPages::handle(const Index3& node) {
  constexpr std::int64_t kSide = LatticeGrid::kSide;
  const auto block = static_cast<std::uint64_t>(
      node[0] / kSide + blocks_[0] * (node[1] / kSide + blocks_[1] * (node[2] / kSide)));
  const auto at = static_cast<std::uint64_t>(node[0] % kSide +
                                             kSide * (node[1] % kSide + kSide * (node[2] % kSide)));
  return (block * LatticeGrid::kBlock + at) << kPageBits | page_at(block);
}

std::uint32_t SearchPages::page_at(std::uint64_t block) {
  const auto [at, is_new] =
      page_of_block_.try_emplace(block, static_cast<std::uint32_t>(pages_.size()));
  if (!is_new) return at->second;
  try {
    auto page = std::make_unique<Page>();
    lattice_->read(block, page->masks);
    const Index3 low = lattice_->grid().block_low(block);
    page->low = {static_cast<std::int32_t>(low[0]), static_cast<std::int32_t>(low[1]),
                 static_cast<std::int32_t>(low[2])};
    page->block = block;
    page->near.fill(kUnknown);
    pages_.push_back(std::move(page));
  } catch (...) {
    page_of_block_.erase(block);
    throw;
  }
  return static_cast<std::uint32_t>(pages_.size() - 1);
}

}  // namespace plan
