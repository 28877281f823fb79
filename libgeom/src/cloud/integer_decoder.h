#pragma once

// Integers of LAZ: how far each is from what was predicted (Isenburg 2013, section "Integer
// compression"): first the number of bits k of the difference, by context, then which of the
// numbers of k bits it is, of which the eight leading bits have models.

#include <cstdint>
#include <vector>

#include "range_decoder.h"

namespace geom {

class IntegerDecoder {
 public:
  // Of 8, 16 or 32 bits. Those of fewer than 32 are without sign and wrap around.
  explicit IntegerDecoder(unsigned bits, unsigned contexts = 1);

  // The number, `predicted` corrected; numbers of 32 bits wrap around too.
  std::int32_t next(RangeDecoder& code, std::int32_t predicted, unsigned context = 0);

  // The bits of the last correction: 0 for 0 and 1, else those of its size.
  unsigned correction_bits() const { return last_; }

 private:
  std::uint32_t correction(RangeDecoder& code, unsigned bits);

  unsigned bits_;
  unsigned last_ = 0;
  BitModel smallest_;
  std::vector<SymbolModel> sizes_;    // by context
  std::vector<SymbolModel> leading_;  // by the bits of the correction, less one
};

}  // namespace geom
