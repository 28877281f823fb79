#pragma once

// Where the fast reader of JSON and the one that words refusals differ.

#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "geom/base/error.h"
#include "text/simdjson_value.h"
#include "text/worded_json.h"

namespace support {

// The same kinds, keys, texts and numbers to the bit: a zero with a sign is another than one
// without.
inline bool same_json(const nlohmann::json& a, const nlohmann::json& b) {
  if (a.type() != b.type()) return false;
  if (a.is_number_float()) {
    return std::bit_cast<std::uint64_t>(a.get<double>()) ==
           std::bit_cast<std::uint64_t>(b.get<double>());
  }
  if (!a.is_structured()) return a == b;
  if (a.size() != b.size()) return false;
  for (auto i = a.begin(), j = b.begin(); i != a.end(); ++i, ++j) {
    if (a.is_object() && i.key() != j.key()) return false;
    if (!same_json(*i, *j)) return false;
  }
  return true;
}

// Empty where simdjson_value leaves the text alone, or says of it what worded_json says.
inline std::string json_disagreement(std::string_view text) {
  const auto fast = geom::simdjson_value(text);
  if (!fast) return "";
  try {
    const nlohmann::json worded = geom::worded_json(text, "f");
    return same_json(*fast, worded) ? "" : "values differ: " + fast->dump() + ", " + worded.dump();
  } catch (const geom::InputError& error) {
    return std::string("read, but refused as ") + error.what();
  }
}

}  // namespace support
