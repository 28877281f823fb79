#pragma once

// stdin, stdout and stderr as a tool finds them: closed, full, or with nobody at the other end.
//
// Work that is finished is never lost because nobody hears of it: what goes to stderr may vanish.
// What goes to stdout is an output, and failing to write it is a failure.

#include <string>
#include <string_view>

namespace cli {

// Call before anything is opened. Holds the places of descriptors 0 to 2 that are closed, so that
// no file gets one of these numbers and then what is meant for a terminal: reading a closed stdin
// and writing to a closed stdout fail, what goes to a closed stderr vanishes. From here on a write
// to a pipe without a reader, or beyond the largest file allowed, fails instead of killing us.
void prepare_standard_streams();

// Ends the process as SIGPIPE does: its reader wants no more of stdout. Returns, having done
// nothing, where prepare_standard_streams() was not called: the signal is then another's affair.
void end_as_by_sigpipe();

// A message as it may reach a terminal: one line of at most 2,000 bytes. No file can write its own
// lines there, or steer it.
std::string shown_message(std::string_view message);

// Whether text that goes to a descriptor may have colours: it is a terminal that knows them, and
// the environment does not say NO_COLOR (no-color.org).
bool takes_colour(int descriptor);

// Writes to stderr as much as it takes. Never throws.
void say(std::string_view text) noexcept;

// Writes to stdout at once. Throws std::system_error where it does not take all.
void print(std::string_view text);

}  // namespace cli
