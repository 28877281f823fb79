#pragma once

// Memory in large pages that is given out piece after piece and released as a whole. What is asked
// all over a large map lies in more small pages than a processor knows the places of.

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <vector>

namespace geom {

class HugeArena {
 public:
  static constexpr std::size_t kAlign = 64;

  // Memory for so many bytes, at a multiple of kAlign; std::bad_alloc where there is none. Threads
  // may take at once.
  void* take(std::size_t bytes);

 private:
  struct Free {
    void operator()(std::byte* chunk) const { std::free(chunk); }
  };

  void add_chunk(std::size_t bytes);

  std::mutex mutex_;
  std::vector<std::unique_ptr<std::byte, Free>> chunks_;
  std::size_t next_size_ = std::size_t{1} << 18;  // of the next chunk; most runs ask little
  std::byte* free_ = nullptr;                     // in the last chunk
  std::size_t left_ = 0;                          // from there
};

}  // namespace geom
