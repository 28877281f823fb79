#pragma once

// ULog files, put together message by message.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace traj {

template <class Value>
std::string bytes_of(Value value) {
  std::string out(sizeof value, '\0');
  std::memcpy(out.data(), &value, sizeof value);
  return out;
}

inline std::string ulog_head(std::uint8_t version = 1, std::uint64_t start = 0) {
  return std::string("ULog\x01\x12\x35", 7) + bytes_of(version) + bytes_of(start);
}

inline std::string ulog_message(char kind, std::string_view body) {
  return bytes_of(static_cast<std::uint16_t>(body.size())) + kind + std::string(body);
}

inline std::string ulog_topic(std::string_view name, std::uint16_t id, std::uint8_t multi = 0) {
  return ulog_message('A', bytes_of(multi) + bytes_of(id) + std::string(name));
}

inline std::string ulog_data(std::uint16_t id, std::string_view body) {
  return ulog_message('D', bytes_of(id) + std::string(body));
}

}  // namespace traj
