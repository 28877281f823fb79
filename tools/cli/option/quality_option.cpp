#include "quality_option.h"

#include <map>
#include <string>

#include "word_for.h"

namespace cli {

void add_quality(CLI::App& app, plan::Quality& quality) {
  const std::map<std::string, plan::Quality> names = {{"fast", plan::Quality::fast},
                                                      {"normal", plan::Quality::normal},
                                                      {"best", plan::Quality::best}};
  app.add_option("--quality", quality, "fast, normal (default) or best")
      ->transform(word_for(names))
      ->type_name("TEXT");
}

}  // namespace cli
