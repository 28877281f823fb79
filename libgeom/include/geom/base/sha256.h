#pragma once

// SHA-256, for the identity of maps and inputs.
//
// Example:
//   geom::Sha256 sum;
//   sum.update(std::as_bytes(std::span(std::string_view("abc"))));
//   assert(sum.hex().starts_with("ba7816bf"));

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace geom {

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void update(std::span<const std::byte> bytes);
  std::string hex();  // 64 hexadecimal digits; ends the sum

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace geom
