#include "geom/base/skipped.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace geom {
namespace {

constexpr std::size_t kNamed = 3;       // of each kind
constexpr std::size_t kManyKinds = 12;  // of more kinds one each, so that none falls off a message

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

std::string Skipped::text() const {
  std::string out;
  for (const auto& [name, kind] : kinds_) {
    const std::size_t named = std::min(kind.first.size(), kinds_.size() > kManyKinds ? 1 : kNamed);
    const std::span<const std::string> first(kind.first.data(), named);
    out += fmt::format("{}{} x {} ({}{})", out.empty() ? "" : ", ", kind.count, name,
                       fmt::join(first, ", "), kind.count > named ? ", …" : "");
  }
  return out;
}

}  // namespace geom
