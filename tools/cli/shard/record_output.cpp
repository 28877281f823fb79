#include "record_output.h"

namespace cli {

RecordOutput::RecordOutput(const std::string& file, std::string name, const Sharding& sharding)
    : sharding_(sharding), file_(file), name_(std::move(name)) {
  if (!sharding.asked()) stream_.emplace(file, OutputKind::text);
}

void RecordOutput::head(std::string_view text) {
  if (stream_) {
    stream_->stream() << text;
  } else {
    head_ = text;
  }
}

void RecordOutput::add(std::string_view record) {
  if (stream_) {
    stream_->stream() << record;
  } else {
    text_ += record;
    ends_.push_back(text_.size());
  }
}

void RecordOutput::flush() {
  if (stream_) stream_->flush();
}

void RecordOutput::commit(std::size_t total, Exit exit) {
  if (stream_) {
    stream_->commit();
    return;
  }
  const nlohmann::json content = {{"head", head_}, {"total", total}};
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text_.data()), text_.size());
  const geom::NamedArray arrays[] = {geom::named_array<std::uint8_t>("text", bytes),
                                     geom::named_array<std::uint64_t>("ends", ends_)};
  sharding_.write(file_, name_, "records", content.dump(), arrays, exit);
}

}  // namespace cli
