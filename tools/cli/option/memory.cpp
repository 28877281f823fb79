#include "memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>

#include "geom/base/text_stream.h"

namespace cli {
namespace {

constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

std::size_t number_in(const std::string& path) {
  std::ifstream file(path);
  std::size_t value = 0;
  return file >> value ? value : kUnlimited;  // no such file, or "max"
}

// A limit of a group holds for those below it.
std::size_t least_up_from(const std::string& root, std::string group, const char* name) {
  std::size_t least = number_in(root + "/" + name);
  while (group.size() > 1) {
    least = std::min(least, number_in(root + group + "/" + name));
    group.resize(group.rfind('/') == std::string::npos ? 0 : group.rfind('/'));
  }
  return least;
}

std::string own_groups() {
  geom::TextOutput out;
  out << std::ifstream("/proc/self/cgroup").rdbuf();
  return out.str();
}

}  // namespace

std::optional<std::size_t> parse_bytes(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number) || number < 0) return std::nullopt;
  const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  static constexpr std::string_view kUnits = "kKmMgG";
  if (unit.size() > 1) return std::nullopt;
  if (!unit.empty()) {
    const auto at = kUnits.find(unit.front());
    if (at == std::string_view::npos) return std::nullopt;
    number = std::ldexp(number, 10 * (static_cast<int>(at) / 2 + 1));
  }
  if (number > 0x1p62) return std::nullopt;
  return static_cast<std::size_t>(number);
}

std::optional<std::size_t> cgroup_limit(const std::string& lines, const std::string& root) {
  std::size_t least = kUnlimited;
  geom::TextInput in(lines);
  for (std::string line; std::getline(in, line);) {  // "0::/a/b" or "4:cpu,memory:/a/b"
    const auto first = line.find(':');
    const auto second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string kinds = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string group = line.substr(second + 1);
    if (kinds == ",,") least = std::min(least, least_up_from(root, group, "memory.max"));
    if (kinds.find(",memory,") != std::string::npos) {
      least = std::min(least, least_up_from(root + "/memory", group, "memory.limit_in_bytes"));
    }
  }
  if (least == kUnlimited) return std::nullopt;
  return least;
}

std::size_t fair_share() {
  std::size_t least = kUnlimited;
  const long pages = sysconf(_SC_PHYS_PAGES);
  if (pages > 0) {
    least = static_cast<std::size_t>(pages) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  }
  least = std::min(least, cgroup_limit(own_groups(), "/sys/fs/cgroup").value_or(kUnlimited));
  rlimit address{};
  if (getrlimit(RLIMIT_AS, &address) == 0 && address.rlim_cur != RLIM_INFINITY) {
    least = std::min(least, static_cast<std::size_t>(address.rlim_cur));
  }
  return least / 4;
}

}  // namespace cli
