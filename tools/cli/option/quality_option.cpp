#include "quality_option.h"

#include "word_for.h"

namespace cli {

void add_quality(CLI::App& app, plan::Quality& quality) {
  add_word(app, "--quality", quality, plan::kQualityWords, "fast, normal (default) or best");
}

}  // namespace cli
