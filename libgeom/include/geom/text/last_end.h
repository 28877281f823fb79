#pragma once

// Streams of lines that show when they break off.
//
// Example:
//   assert(geom::up_to_last_end("{\"id\":1}\n{\"id\":2,\"ok\":true}\n") == 16);  // before ,"ok"
//   assert(geom::up_to_last_end("a,b\n1,2\n") == 5);                          // before ,2

#include <cstddef>
#include <string_view>

namespace geom {

// How many bytes of these lines may be written while more may follow: all but the end of the last
// line, from its last comma, tab or space on; without any of them, its last character. A writer
// keeps the rest back until it has more, or is done. If it fails or is killed, its last line is
// cut, and the next reader refuses it.
std::size_t up_to_last_end(std::string_view lines);

}  // namespace geom
