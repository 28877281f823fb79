#include "traj/mission/ulog/ulog_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"

namespace traj {
namespace {

constexpr std::size_t kMostText = std::size_t{16} << 20;
constexpr std::size_t kMostBytes = 65535;  // of a message
constexpr std::size_t kDeepest = 20;       // formats within formats
constexpr std::size_t kLongest = 200;      // characters of a field's name, with what it is within

struct NamedType {
  std::string_view name;
  UlogType type;
  std::size_t bytes;
};

constexpr std::array kTypes = {
    NamedType{"int8_t", UlogType::int8, 1},   NamedType{"uint8_t", UlogType::uint8, 1},
    NamedType{"int16_t", UlogType::int16, 2}, NamedType{"uint16_t", UlogType::uint16, 2},
    NamedType{"int32_t", UlogType::int32, 4}, NamedType{"uint32_t", UlogType::uint32, 4},
    NamedType{"int64_t", UlogType::int64, 8}, NamedType{"uint64_t", UlogType::uint64, 8},
    NamedType{"float", UlogType::float32, 4}, NamedType{"double", UlogType::float64, 8},
    NamedType{"bool", UlogType::boolean, 1},  NamedType{"char", UlogType::character, 1}};

std::optional<UlogType> type_of(std::string_view name) {
  for (const NamedType& type : kTypes) {
    if (type.name == name) return type.type;
  }
  return std::nullopt;
}

// "float[3] q": a type, how many of it, and a name.
struct Declaration {
  std::string_view type;
  std::size_t count = 1;
  std::string_view name;
};

// Nothing for what is not one.
std::optional<Declaration> declaration_of(std::string_view text) {
  const std::size_t blank = text.find(' ');
  if (blank == text.npos || blank == 0 || blank + 1 == text.size()) return std::nullopt;
  Declaration out{text.substr(0, blank), 1, text.substr(blank + 1)};
  if (out.name.find(' ') != out.name.npos) return std::nullopt;
  if (!out.type.ends_with(']')) return out;
  const std::size_t open = out.type.find('[');
  if (open == out.type.npos || open == 0) return std::nullopt;
  const std::string_view digits = out.type.substr(open + 1, out.type.size() - open - 2);
  out.type = out.type.substr(0, open);
  out.count = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    out.count = out.count * 10 + static_cast<std::size_t>(c - '0');
    if (out.count > kMostBytes) return std::nullopt;
  }
  return out.count > 0 ? std::optional(out) : std::nullopt;
}

std::string_view next_of(std::string_view& fields) {
  const std::size_t end = std::min(fields.find(';'), fields.size());
  const std::string_view field = fields.substr(0, end);
  fields.remove_prefix(std::min(end + 1, fields.size()));
  return field;
}

// Lays one format out, with all that it contains.
class Layer {
 public:
  using Formats = std::map<std::string, std::string, std::less<>>;
  Layer(const Formats& formats, const std::string& source) : formats_(formats), source_(source) {}

  void add(std::string_view name, const std::string& prefix, std::size_t depth) {
    const auto format = formats_.find(name);
    if (format == formats_.end()) {
      refuse(
          {.expected = "a format or a basic type", .found = geom::in_quotes(geom::excerpt(name))});
    }
    if (depth > kDeepest) {
      refuse({.says = fmt::format("the format {} contains itself, or {} others one in the other",
                                  geom::excerpt(name), kDeepest)});
    }
    std::string_view fields = format->second;
    while (!fields.empty()) add_field(next_of(fields), name, prefix, depth);
  }

  UlogLayout take() && { return std::move(out_); }

 private:
  void add_field(std::string_view text, std::string_view format, const std::string& prefix,
                 std::size_t depth) {
    const auto field = declaration_of(text);
    if (!field) {
      refuse({.item = fmt::format("format {}", geom::excerpt(format)),
              .expected = "fields such as \"float[3] name\"",
              .found = geom::in_quotes(geom::excerpt(text))});
    }
    const std::string name = prefix + std::string(field->name);
    if (name.size() > kLongest) {
      refuse({.expected = fmt::format("names of fields of at most {} characters", kLongest),
              .found = geom::in_quotes(geom::excerpt(name))});
    }
    if (const auto type = type_of(field->type)) return add_values(*type, *field, name);
    for (std::size_t i = 0; i < field->count; ++i) {
      add(field->type, field->count == 1 ? name + '.' : fmt::format("{}[{}].", name, i), depth + 1);
    }
  }

  void add_values(UlogType type, const Declaration& field, const std::string& name) {
    const bool padding = field.name.starts_with("_padding");
    if (!padding && !out_.fields.emplace(name, UlogField{type, out_.size, field.count}).second) {
      refuse({.says = fmt::format("the field {} comes twice in a format", geom::excerpt(name))});
    }
    out_.size += size_of(type) * field.count;
    if (!padding) out_.least = out_.size;
    if (out_.size > kMostBytes) {
      refuse({.expected = fmt::format("a format of at most {} bytes", kMostBytes),
              .found = "a larger one"});
    }
  }

  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source_, std::move(fault));
  }

  const Formats& formats_;
  const std::string& source_;
  UlogLayout out_;
};

}  // namespace

std::size_t size_of(UlogType type) {
  const auto found = std::find_if(kTypes.begin(), kTypes.end(),
                                  [&](const NamedType& one) { return one.type == type; });
  return found->bytes;
}

void UlogFormats::add(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == text.npos || colon == 0 || colon + 1 == text.size()) {
    throw geom::InputError(source_, {.expected = "a format such as \"name:float x;\"",
                                     .found = geom::in_quotes(geom::excerpt(text))});
  }
  bytes_ += text.size();
  if (bytes_ > kMostText) {
    throw geom::InputError(source_, {.expected = "at most 16 MiB of formats", .found = "more"});
  }
  const std::string name(text.substr(0, colon));
  const auto [known, fresh] = formats_.emplace(name, text.substr(colon + 1));
  if (!fresh && known->second != text.substr(colon + 1)) {
    throw geom::InputError(source_, {.says = fmt::format("the format {} comes twice, and differs",
                                                         geom::excerpt(name))});
  }
}

UlogLayout UlogFormats::layout(std::string_view name) const {
  Layer layer(formats_, source_);
  layer.add(name, "", 0);
  return std::move(layer).take();
}

}  // namespace traj
