#pragma once

// What becomes of a tool whose mapped file somebody cuts while it is read.

namespace cli {

// From now on reading what is gone of a mapped file, in whatever thread, ends the process with exit
// 4 and a line that names the file. Any other SIGBUS does what it did. `tool` must live on.
void end_where_a_file_is_cut(const char* tool);

}  // namespace cli
