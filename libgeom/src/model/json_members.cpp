#include "json_members.h"

#include <fmt/format.h>

#include <cmath>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

const nlohmann::json kNoList = nlohmann::json::array();
const nlohmann::json kNoObject = nlohmann::json::object();

}  // namespace

JsonMembers::JsonMembers(const nlohmann::json& object, std::string source, std::string where)
    : object_(object), source_(std::move(source)), where_(std::move(where)) {
  if (!object.is_object()) {
    throw InputError(source_, {.item = where_, .expected = "an object", .found = shown(object)});
  }
}

void JsonMembers::refuse(Fault fault) const {
  throw InputError(source_, within(where_, std::move(fault)));
}

void JsonMembers::refuse_type(const char* key, const char* expected) const {
  refuse({.expected = fmt::format("{} as \"{}\"", expected, key),
          .found = has(key) ? shown(object_.at(key)) : "none"});
}

std::optional<std::uint64_t> JsonMembers::find_whole(const char* key) const {
  const auto at = object_.find(key);
  if (at == object_.end()) return std::nullopt;
  if (!at->is_number_unsigned()) refuse_type(key, "a whole number");
  return at->get<std::uint64_t>();
}

std::uint64_t JsonMembers::whole(const char* key) const {
  const auto found = find_whole(key);
  if (!found) refuse_type(key, "a whole number");
  return *found;
}

std::uint64_t JsonMembers::whole(const char* key, std::uint64_t fallback) const {
  return find_whole(key).value_or(fallback);
}

std::optional<std::string> JsonMembers::find_text(const char* key) const {
  const auto at = object_.find(key);
  if (at == object_.end()) return std::nullopt;
  if (!at->is_string()) refuse_type(key, "text");
  return at->get<std::string>();
}

std::string JsonMembers::text(const char* key) const {
  const auto found = find_text(key);
  if (!found) refuse_type(key, "text");
  return *found;
}

bool JsonMembers::truth(const char* key) const {
  const auto at = object_.find(key);
  if (at == object_.end()) return false;
  if (!at->is_boolean()) refuse_type(key, "true or false");
  return at->get<bool>();
}

std::optional<std::vector<double>> JsonMembers::numbers(const char* key, std::size_t count) const {
  const auto at = object_.find(key);
  if (at == object_.end()) return std::nullopt;
  const std::string expected = fmt::format("{} numbers", count);
  if (!at->is_array() || at->size() != count) refuse_type(key, expected.c_str());
  std::vector<double> out;
  for (const nlohmann::json& v : *at) {
    if (!v.is_number() || !std::isfinite(v.get<double>())) refuse_type(key, expected.c_str());
    out.push_back(v.get<double>());
  }
  return out;
}

const nlohmann::json& JsonMembers::list(const char* key) const {
  const auto at = object_.find(key);
  if (at == object_.end()) return kNoList;
  if (!at->is_array()) refuse_type(key, "a list");
  return *at;
}

const nlohmann::json& JsonMembers::members(const char* key) const {
  const auto at = object_.find(key);
  if (at == object_.end()) return kNoObject;
  if (!at->is_object()) refuse_type(key, "an object");
  return *at;
}

JsonMembers JsonMembers::at(const char* key, std::uint64_t i, const std::string& what) const {
  const nlohmann::json& all = list(key);
  if (i >= all.size())
    refuse({.says = fmt::format("there is no {} {}, but {} of them", what, i, all.size())});
  return {all[i], source_, fmt::format("{} {}", what, i)};
}

}  // namespace geom
