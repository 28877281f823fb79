#include "line_blocks.h"

#include <algorithm>

#include "geom/base/file_error.h"

namespace geom {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 17;

// Line feeds are few among the bytes, so a search for each is faster than a look at every byte.
std::size_t line_feeds(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; ++at) ++count;
  return count;
}

}  // namespace

// What was read behind the bytes that are used already; nothing at the end.
std::string_view LineBlocks::read_more(std::vector<char>& memory, std::size_t used) {
  if (memory.size() < used + kBlock) memory.resize(used + kBlock);
  in_.read(memory.data() + used, static_cast<std::streamsize>(kBlock));
  if (in_.bad()) throw FileError(FileUse::reading, source_, EIO);
  return {memory.data() + used, static_cast<std::size_t>(in_.gcount())};
}

bool LineBlocks::next(LineBlock& block) {
  std::size_t used = rest_.size();
  block.memory.resize(std::max(block.memory.size(), used));
  std::copy(rest_.begin(), rest_.end(), block.memory.begin());
  rest_.clear();
  std::size_t end = 0;  // of the last whole line
  while (end == 0) {
    const std::string_view more = read_more(block.memory, used);
    const std::size_t feed = more.rfind('\n');
    if (feed != more.npos) end = used + feed + 1;
    used += more.size();
    if (more.empty()) end = used;
    if (used == 0) return false;
  }
  rest_.assign(block.memory.data() + end, used - end);
  block.text = {block.memory.data(), end};
  block.before = lines_;
  block.lines = line_feeds(block.text) + (block.text.back() != '\n');
  lines_ += block.lines;
  return true;
}

}  // namespace geom
