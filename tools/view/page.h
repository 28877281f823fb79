#pragma once

// The page: one HTML file that holds program, style and data, and asks for nothing else.

#include <string>
#include <string_view>

#include "bundle.h"

namespace view {

std::string page(std::string_view title, const Json& meta, const Bundle& bundle);

// The parts, joined from tools/view/page when the tool is built.
extern const std::string_view kPageHtml;  // with {{title}}, {{style}} and so on
extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;
extern const std::string_view kPageThree;  // three.js, as Debian packages it

}  // namespace view
