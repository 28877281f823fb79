#pragma once

// The names that files give to others.

#include <string>
#include <string_view>

namespace geom {

bool is_data_uri(std::string_view uri);

// What a data URI (RFC 2397) holds, in base64 or percent-encoded. InputError(source, …) for
// another.
std::string data_of_uri(std::string_view uri, std::string_view source);

// The path that a relative URI names from the folder of `base`, "." and ".." resolved and
// percent-encoding undone, without a query. InputError(source, …) where it names a host or scheme,
// is absolute, or leads above the folder that `base` counts from.
std::string path_of_uri(std::string_view uri, std::string_view base, std::string_view source);

}  // namespace geom
