#pragma once

// Names of outputs end in what is written.

#include <initializer_list>
#include <string>
#include <string_view>

namespace cli {

// Throws UsageError, which ends in `advice`, where `name` has an ending that is none of `endings`
// (".svg"). Names without an ending are fine: pipes, devices, "-".
void require_ending(std::string_view option, const std::string& name,
                    std::initializer_list<std::string_view> endings, std::string_view advice);

}  // namespace cli
