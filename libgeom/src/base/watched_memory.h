#pragma once

// Whether memory ran out inside a library that does not say so.
//
// GDAL and PROJ catch std::bad_alloc, and go on with less than there is: without the reference
// system of a file, or with a way to places that is metres off.

namespace geom {

// While one lives, failed allocations of C++ code are counted, of all threads. Those of C code are
// counted where the library tells of them (note_failed_allocation).
class WatchedMemory {
 public:
  WatchedMemory();
  ~WatchedMemory();
  WatchedMemory(const WatchedMemory&) = delete;
  WatchedMemory& operator=(const WatchedMemory&) = delete;

  // Throws std::bad_alloc where an allocation failed since it was made.
  void require_enough() const;

 private:
  unsigned long failed_before_;
};

// Counts an allocation that failed in C code.
void note_failed_allocation() noexcept;

}  // namespace geom
