#pragma once

// A heap of four children a node in a vector: shallower than a binary one, with fewer cache misses.
// `earlier(a, b)` is a strict order; with a total one the order of taking does not depend on that
// of pushing.

#include <algorithm>
#include <vector>

namespace plan {

template <class T, class Earlier>
void heap_push(std::vector<T>& heap, const T& entry, const Earlier& earlier) {
  std::size_t at = heap.size();
  heap.push_back(entry);
  while (at > 0) {
    const std::size_t parent = (at - 1) / 4;
    if (!earlier(entry, heap[parent])) break;
    heap[at] = heap[parent];
    at = parent;
  }
  heap[at] = entry;
}

// Takes the earliest entry of a heap that is not empty.
template <class T, class Earlier>
T heap_pop(std::vector<T>& heap, const Earlier& earlier) {
  const T first = heap.front();
  const T last = heap.back();
  heap.pop_back();
  const std::size_t n = heap.size();
  if (n == 0) return first;
  std::size_t at = 0;
  for (std::size_t child = 1; child < n; child = 4 * at + 1) {
    std::size_t least = child;
    for (std::size_t c = child + 1; c < std::min(child + 4, n); ++c) {
      if (earlier(heap[c], heap[least])) least = c;
    }
    if (!earlier(heap[least], last)) break;
    heap[at] = heap[least];
    at = least;
  }
  heap[at] = last;
  return first;
}

}  // namespace plan
