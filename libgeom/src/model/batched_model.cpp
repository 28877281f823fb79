#include "batched_model.h"

#include <fmt/format.h>

#include <array>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"
#include "json_members.h"
#include "little_endian.h"

namespace geom {
namespace {

constexpr std::size_t kHead = 28;

nlohmann::json table(std::string_view text, const std::string& source) {
  const std::size_t end = text.find_last_not_of(std::string_view(" \0\t\r\n", 5));
  if (end == std::string_view::npos) return nlohmann::json::object();
  return parse_json(text.substr(0, end + 1), source);
}

// RTC_CENTER stands in the table, or as three floats in its binary part.
Vec3 center_of(const nlohmann::json& features, std::string_view binary, const std::string& source) {
  const JsonMembers table(features, source, "feature table");
  if (!table.has("RTC_CENTER")) return Vec3::Zero();
  if (features.at("RTC_CENTER").is_object()) {
    const JsonMembers place(features.at("RTC_CENTER"), source, "RTC_CENTER");
    const std::uint64_t at = place.whole("byteOffset");
    if (at > binary.size() || binary.size() - at < 12)
      place.refuse({.says = "it lies outside the table"});
    Vec3 center;
    for (std::size_t i = 0; i < 3; ++i) {
      center[static_cast<Eigen::Index>(i)] = little_endian<float>(binary, at + 4 * i);
    }
    if (!center.allFinite()) place.refuse({.expected = "numbers"});
    return center;
  }
  const auto c = table.numbers("RTC_CENTER", 3);
  return {(*c)[0], (*c)[1], (*c)[2]};
}

// The first of these that is a list, as text.
std::vector<std::string> names_of(const nlohmann::json& batch) {
  if (!batch.is_object()) return {};
  for (const char* key : {"name", "Name", "id", "ID", "gml:id"}) {
    if (!batch.contains(key) || !batch.at(key).is_array()) continue;
    std::vector<std::string> out;
    for (const nlohmann::json& v : batch.at(key)) {
      out.push_back(v.is_string() ? v.get<std::string>() : v.dump());
    }
    return out;
  }
  return {};
}

}  // namespace

BatchedModel read_batched_model(std::string_view bytes, std::string_view source) {
  const std::string name(source);
  if (bytes.size() < kHead) {
    throw InputError(source,
                     {.says = fmt::format("a b3dm of {} bytes is cut short", bytes.size())});
  }
  if (const auto version = little_endian<std::uint32_t>(bytes, 4); version != 1) {
    throw InputError(source, {.expected = "a b3dm of version 1", .found = fmt::to_string(version)});
  }
  const std::size_t length = little_endian<std::uint32_t>(bytes, 8);
  std::array<std::size_t, 4> tables{};  // features and batch, each as JSON and binary
  std::size_t total = kHead;
  for (std::size_t i = 0; i < 4; ++i) {
    tables[i] = little_endian<std::uint32_t>(bytes, 12 + 4 * i);
    total += tables[i];
  }
  if (length != bytes.size() || total > length) {
    throw InputError(source,
                     {.says = fmt::format("expected a b3dm of {} bytes, as it says, of which its "
                                          "tables take {}; found {}",
                                          length, total, bytes.size())});
  }
  const std::string_view features = bytes.substr(kHead, tables[0]);
  const std::string_view binary = bytes.substr(kHead + tables[0], tables[1]);
  const std::string_view batch = bytes.substr(kHead + tables[0] + tables[1], tables[2]);
  BatchedModel out;
  out.center = center_of(table(features, name), binary, name);
  out.names = names_of(table(batch, name));
  out.gltf = bytes.substr(total);
  return out;
}

}  // namespace geom
