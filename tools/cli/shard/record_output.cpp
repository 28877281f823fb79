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
    part_.head = text;
  }
}

void RecordOutput::add(std::string_view record) {
  if (stream_) {
    stream_->stream() << record;
  } else {
    part_.text += record;
    part_.ends.push_back(part_.text.size());
  }
}

void RecordOutput::flush() {
  if (stream_) stream_->flush();
}
void RecordOutput::pass_on() {
  if (stream_) stream_->pass_on();
}

void RecordOutput::commit(std::size_t total, Exit exit) {
  if (stream_) {
    stream_->commit();
    return;
  }
  sharding_.write(file_, name_, "records", geom::arrays_of(part_, total), exit);
}

}  // namespace cli
