#pragma once

// A test's own malloc (failing_sqlite.cpp, which the test must link), that can fail for SQLite.

namespace support {

// While it lives, allocation number `number` of SQLite from now on (0: the next one) fails. One at
// a time.
class FailingSqlite {
 public:
  explicit FailingSqlite(long number);
  ~FailingSqlite();
  FailingSqlite(const FailingSqlite&) = delete;
  FailingSqlite& operator=(const FailingSqlite&) = delete;

  static bool works_here();  // false where a sanitizer has its own malloc
  static bool any_failed();  // since the last one began
};

}  // namespace support
