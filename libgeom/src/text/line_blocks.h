#pragma once

// A long text as blocks of whole lines, which threads can parse at the same time.

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace geom {

// Move-only, because `text` shows what is in `memory`.
struct LineBlock {
  LineBlock() = default;
  LineBlock(LineBlock&&) = default;
  LineBlock& operator=(LineBlock&&) = default;

  std::vector<char> memory;
  std::string_view text;   // ends with a line; the last of a source may lack its line feed
  std::size_t before = 0;  // lines of the source that stand before it
  std::size_t lines = 0;   // at least one
};

// Blocks of about 128 KiB; a line that is longer makes a longer block.
class LineBlocks {
 public:
  // Reads on in `in`, of which `before` lines were read. `in` must outlive this object.
  LineBlocks(std::istream& in, std::size_t before, std::string_view source)
      : in_(in), source_(source), lines_(before) {}

  // Reads the next block into `block`, whose memory is used again. False at the end. Throws
  // FileError where reading fails.
  bool next(LineBlock& block);

  std::size_t lines() const { return lines_; }  // of the source, up to the end of the last block

 private:
  std::string_view read_more(std::vector<char>& memory, std::size_t used);

  std::istream& in_;
  std::string source_;
  std::string rest_;  // of the last block: the beginning of a line
  std::size_t lines_;
};

}  // namespace geom
