// parse_table FILE: what a table of numbers takes that are read and dropped: the file by read(),
// and then its numbers by std::from_chars and by our read_number. CPU seconds, the best of five.

#include <algorithm>
#include <charconv>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>

#include "geom/text/number.h"

namespace {

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The sum of all numbers that begin a field; what is none is passed over up to the next separator.
template <class Read>
double sum_of(const std::string& text, const Read& read) {
  double sum = 0;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    double value = 0;
    at = read(at, end, value).ptr;
    sum += value;
    while (at != end && *at != ',' && *at != '\n') ++at;
    if (at != end) ++at;
  }
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  double read = 1e9;
  double standard = 1e9;
  double ours = 1e9;
  double sum = 0;
  for (int turn = 0; turn < 5; ++turn) {
    double start = seconds();
    std::ifstream file(argv[1], std::ios::binary | std::ios::ate);
    std::string text(static_cast<std::size_t>(file.tellg()), '\0');
    file.seekg(0);
    start = seconds();
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    read = std::min(read, seconds() - start);
    start = seconds();
    sum = sum_of(text, [](const char* first, const char* last, double& value) {
      return std::from_chars(first, last, value);
    });
    standard = std::min(standard, seconds() - start);
    start = seconds();
    sum -= sum_of(text, geom::read_number);
    ours = std::min(ours, seconds() - start);
  }
  std::cout << "read " << read << " s, parsed by std::from_chars " << standard
            << " s, by read_number " << ours << " s of CPU\n";
  return sum == 0 ? 0 : 1;
}
