// replay READER FILE…: feeds each file to the reader whole, cut short at 64 places, and with 2,000
// seeded changes of up to 4 bytes. The stand-in for libFuzzer's main where clang is not at hand.

#include <fstream>
#include <iostream>
#include <random>

#include "fuzz/reader.h"

namespace {

void feed_around(const fuzz::Reader& reader, const std::string& whole) {
  fuzz::takes(whole, reader.read);
  for (std::size_t k = 0; k < 64; ++k)
    fuzz::takes(whole.substr(0, whole.size() * k / 64), reader.read);
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000 && !whole.empty(); ++k) {
    std::string changed = whole;
    for (std::uint64_t n = random() % 4; n < 4; ++n)
      changed[random() % changed.size()] = static_cast<char>(random());
    fuzz::takes(changed, reader.read);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t inputs = 0;
  for (const fuzz::Reader& reader : fuzz::readers()) {
    if (argc < 2 || std::string(argv[1]) != reader.name) continue;
    for (int i = 2; i < argc; ++i, ++inputs) {
      std::ifstream in(argv[i], std::ios::binary);
      if (!in.is_open()) return 2;
      feed_around(reader, fuzz::rest_of(in));
    }
  }
  std::cout << inputs << " inputs replayed\n";
  return inputs > 0 ? 0 : 2;
}
