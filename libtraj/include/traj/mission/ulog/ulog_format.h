#pragma once

// What the format messages of a ULog say: where the fields of a logged message are.
//
// Example:
//   traj::UlogFormats formats("hop.ulg");
//   formats.add("battery:uint64_t timestamp;float remaining;");
//   const traj::UlogLayout layout = formats.layout("battery");
//   assert(layout.fields.at("remaining").at == 8);

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace traj {

enum class UlogType {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  boolean,
  character
};

std::size_t size_of(UlogType type);  // bytes

// A field, or an array of `count` values side by side, from byte `at` of a message on.
struct UlogField {
  UlogType type = UlogType::uint8;
  std::size_t at = 0;
  std::size_t count = 1;
};

// Fields of a nested format are named "outer.inner", of an array of formats "outer[2].inner".
struct UlogLayout {
  std::map<std::string, UlogField, std::less<>> fields;  // without padding
  std::size_t size = 0;                                  // bytes, with padding at the end
  std::size_t least = 0;                                 // without: that padding may not be logged
};

// The formats of a log. What a name means is looked up only when it is asked for, as a format may
// name one that comes after it.
class UlogFormats {
 public:
  explicit UlogFormats(std::string_view source) : source_(source) {}

  // The text of a format message, "name:type field;type[3] field;". Throws geom::InputError for one
  // that is not, for a second one of that name that differs, and beyond 16 MiB of them.
  void add(std::string_view text);

  bool has(std::string_view name) const { return formats_.find(name) != formats_.end(); }

  // Throws geom::InputError where there is no such format, and for a type that is not known, a
  // field that comes twice, formats that contain themselves, and ones larger than a message.
  UlogLayout layout(std::string_view name) const;

 private:
  std::string source_;
  std::map<std::string, std::string, std::less<>> formats_;  // fields by name
  std::size_t bytes_ = 0;
};

}  // namespace traj
