#include "page.h"

#include <array>
#include <utility>

#include "geom/text/markup.h"

namespace view {
namespace {

// JSON that may stand inside <script>: no "<" can end it.
std::string script_json(const Json& meta) {
  std::string out;
  for (const char c : meta.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

}  // namespace

std::string page(std::string_view title, const Json& meta, const Bundle& bundle) {
  const std::array<std::pair<std::string_view, std::string>, 6> parts = {
      {{"{{title}}", geom::escaped_markup(title)},
       {"{{style}}", std::string(kPageStyle)},
       {"{{meta}}", script_json(meta)},
       {"{{arrays}}", bundle.base64()},
       {"{{three}}", std::string(kPageThree)},
       {"{{script}}", std::string(kPageScript)}}};
  std::string out;
  std::string_view rest = kPageHtml;
  for (const auto& [mark, text] : parts) {
    const std::size_t at = rest.find(mark);  // each stands there once, in this order
    out += rest.substr(0, at);
    out += text;
    rest.remove_prefix(at + mark.size());
  }
  return out += rest;
}

}  // namespace view
