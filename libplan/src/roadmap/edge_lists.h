#pragma once

// Edges of bends that are numbered one after the other, whatever their tiles.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace plan {

struct EdgeLists {
  std::vector<std::uint64_t> first{0};  // those of bend i begin there; one more than bends
  std::vector<std::uint32_t> to;
  std::vector<std::uint32_t> split;  // how many of each are on the first side, once sorted

  std::span<const std::uint32_t> of(std::size_t bend) const {
    return std::span(to).subspan(first[bend], first[bend + 1] - first[bend]);
  }
};

// Each list is freed once it was copied.
inline EdgeLists flat(std::vector<std::vector<std::uint32_t>> lists) {
  EdgeLists out;
  std::size_t edges = 0;
  for (const auto& list : lists) edges += list.size();
  out.to.reserve(edges);
  for (auto& list : lists) {
    out.to.insert(out.to.end(), list.begin(), list.end());
    out.first.push_back(out.to.size());
    std::vector<std::uint32_t>().swap(list);
  }
  return out;
}

}  // namespace plan
