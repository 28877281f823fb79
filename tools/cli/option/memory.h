#pragma once

// --memory: how much the collision trees of a tool may take.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace cli {

// Bytes of "4096", "64k", "512M" or "1.5G" (powers of 1024, either case); nothing where it is none
// of these.
std::optional<std::size_t> parse_bytes(std::string_view text);

// A quarter of what this process may have: the least of the machine's memory, the limits of its
// control groups (versions 1 and 2), and its limit on address space (RLIMIT_AS).
std::size_t fair_share();

// The least limit that the lines of /proc/self/cgroup lead to below `root` ("/sys/fs/cgroup");
// nothing where there is none.
std::optional<std::size_t> cgroup_limit(const std::string& lines, const std::string& root);

}  // namespace cli
