#include "geom/base/skipped.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <utility>

namespace geom {
namespace {

constexpr std::size_t kNamed = 3;  // of each kind
constexpr std::size_t kMany = 12;  // of more kinds the most frequent alone,
constexpr std::size_t kShown = 8;  // so many, with one name each

}  // namespace

void Skipped::add(const std::string& kind, std::string which) {
  Kind& known = kinds_[kind];
  ++known.count;
  if (known.first.size() < kNamed) known.first.push_back(std::move(which));
}

void Skipped::add(const Skipped& other) {
  for (const auto& [name, kind] : other.kinds_) {
    Kind& known = kinds_[name];
    known.count += kind.count;
    for (const std::string& which : kind.first) {
      if (known.first.size() < kNamed) known.first.push_back(which);
    }
  }
}

void Skipped::add_of(std::string_view file, const Skipped& other) {
  Skipped named = other;
  for (auto& [name, kind] : named.kinds_) {
    for (std::string& which : kind.first) which = fmt::format("{}: {}", file, which);
  }
  add(named);
}

std::size_t Skipped::count() const {
  std::size_t count = 0;
  for (const auto& [name, kind] : kinds_) count += kind.count;
  return count;
}

std::map<std::string, std::size_t> Skipped::by_kind() const {
  std::map<std::string, std::size_t> out;
  for (const auto& [name, kind] : kinds_) out[name] = kind.count;
  return out;
}

std::string Skipped::text() const {
  std::vector<std::pair<std::string, Kind>> kinds(kinds_.begin(), kinds_.end());
  const bool many = kinds.size() > kMany;
  if (many) {
    std::stable_sort(kinds.begin(), kinds.end(),
                     [](const auto& a, const auto& b) { return a.second.count > b.second.count; });
    kinds.resize(kShown);
  }
  std::size_t left = count();
  std::string out;
  for (const auto& [name, kind] : kinds) {
    const std::size_t named = std::min(kind.first.size(), many ? 1 : kNamed);
    const std::span<const std::string> first(kind.first.data(), named);
    out += fmt::format("{}{} x {} ({}{})", out.empty() ? "" : ", ", kind.count, name,
                       fmt::join(first, ", "), kind.count > named ? ", …" : "");
    left -= kind.count;
  }
  if (many) out += fmt::format(" and {} of {} more kinds", left, kinds_.size() - kShown);
  return out;
}

}  // namespace geom
