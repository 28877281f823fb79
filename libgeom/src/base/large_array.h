#pragma once

// A large array that is written once, part by part, by all threads.

#include <cstddef>
#include <memory>
#include <span>

namespace geom {

// Elements have no value until they are written, so that no thread writes them in vain. Move-only.
template <class T>
class LargeArray {
 public:
  explicit LargeArray(std::size_t size = 0)
      : size_(size), items_(std::make_unique_for_overwrite<T[]>(size)) {}

  std::span<T> all() { return {items_.get(), size_}; }
  std::span<const T> all() const { return {items_.get(), size_}; }

 private:
  std::size_t size_;
  std::unique_ptr<T[]> items_;
};

}  // namespace geom
