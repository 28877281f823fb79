#include "geom/base/error.h"

#include <utility>

namespace geom {
namespace {

std::string place(std::string_view source, std::size_t line) {
  return std::string(source) + (line ? ":" + std::to_string(line) : "");
}

std::string expectation(const Fault& fault) {
  return (fault.key.empty() ? "expected " : fault.key + " must be ") + fault.expected;
}

}  // namespace

std::string sentence(const Fault& fault) {
  std::string out = fault.item;
  const auto add = [&](std::string_view between, std::string_view text) {
    if (text.empty()) return;
    if (!out.empty()) out += between;
    out += text;
  };
  add(": ", fault.says);
  if (!fault.expected.empty()) add(": ", expectation(fault));
  if (!fault.found.empty()) add(", ", "found " + fault.found);
  add(": ", fault.advice);
  return out;
}

Fault within(std::string_view item, Fault fault) {
  fault.item = std::string(item) + (fault.item.empty() ? "" : ": " + fault.item);
  return fault;
}

std::string in_quotes(std::string_view text) { return '"' + std::string(text) + '"'; }

InputError::InputError(std::string_view source, std::size_t line, Fault fault)
    : std::runtime_error(place(source, line) + ": " + sentence(fault)),
      fields_(std::make_shared<const Fields>(Fields{std::string(source), line, std::move(fault)})) {
}

Fault InputError::as_item() const { return within(place(source(), line()), fault()); }

}  // namespace geom
