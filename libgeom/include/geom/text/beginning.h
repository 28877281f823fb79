#pragma once

// How files begin: the conditions that tables of formats are made of (geom/base/format.h).
//
// Example:
//   constexpr geom::Format kParquet{.what = "a Parquet table",
//                                   .begins = geom::begins_with<"PAR1">};
//   assert(kParquet.begins("PAR1..."));

#include <cstddef>
#include <string_view>

namespace geom {

// A text as the argument of a template. Zeros inside it belong to it.
template <std::size_t N>
struct Letters {
  char text[N]{};
  constexpr Letters(const char (&from)[N]) {
    for (std::size_t i = 0; i < N; ++i) text[i] = from[i];
  }
  constexpr std::string_view view() const { return {text, N - 1}; }
};

// The text behind a byte order mark and blanks.
std::string_view text_of(std::string_view head);

// The first line that holds more than blanks and is no comment (#), from its first letter on;
// empty where there is none.
std::string_view first_line(std::string_view head);

// Whether a text that begins with < holds `part` anywhere.
bool is_xml_with(std::string_view head, std::string_view part);

// Whether a text that begins with { or [ holds `part` anywhere, once it has no blanks.
bool is_json_with(std::string_view head, std::string_view part);

// Whether the first "type" of a text that begins with { has this value.
bool is_json_of_type(std::string_view head, std::string_view type);

// Whether it is a ZIP archive; whether the name of its first entry holds `part`.
bool is_zip(std::string_view head);
std::string_view first_zip_entry(std::string_view head);  // its name; empty where there is none

// Whether it is an archive of arrays (geom/archive) whose meta.json says this format, for itself or
// for a part.
bool is_archive_of(std::string_view head, std::string_view format);

// The same as values of Format::begins.
template <Letters kBytes, std::size_t kAt = 0>
bool begins_with(std::string_view head) {
  return head.size() >= kAt && head.substr(kAt).starts_with(kBytes.view());
}
template <Letters kStart>
bool text_begins_with(std::string_view head) {
  return text_of(head).starts_with(kStart.view());
}
template <Letters kPart>
bool xml_with(std::string_view head) {
  return is_xml_with(head, kPart.view());
}
template <Letters kPart>
bool json_with(std::string_view head) {
  return is_json_with(head, kPart.view());
}
template <Letters kType>
bool json_of_type(std::string_view head) {
  return is_json_of_type(head, kType.view());
}
template <Letters kPart>
bool zip_with(std::string_view head) {
  return first_zip_entry(head).find(kPart.view()) != std::string_view::npos;
}
template <Letters kFormat>
bool archive_of(std::string_view head) {
  return is_archive_of(head, kFormat.view());
}

// Whether one of several conditions holds.
template <bool (*... kConditions)(std::string_view)>
bool any_of(std::string_view head) {
  return (kConditions(head) || ...);
}

}  // namespace geom
