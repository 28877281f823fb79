#include "expat_library.h"

#include "geom/base/loaded_library.h"

namespace geom {
namespace {

ExpatLibrary load() {
  const LoadedLibrary library(SKYWAY_EXPAT_SONAME, "libexpat1");
  return {.parser_create = SKYWAY_FUNCTION(library, XML_ParserCreate),
          .parser_free = SKYWAY_FUNCTION(library, XML_ParserFree),
          .set_user_data = SKYWAY_FUNCTION(library, XML_SetUserData),
          .set_element_handler = SKYWAY_FUNCTION(library, XML_SetElementHandler),
          .set_character_data_handler = SKYWAY_FUNCTION(library, XML_SetCharacterDataHandler),
          .set_start_doctype_handler = SKYWAY_FUNCTION(library, XML_SetStartDoctypeDeclHandler),
          .set_unknown_encoding_handler = SKYWAY_FUNCTION(library, XML_SetUnknownEncodingHandler),
          .parse = SKYWAY_FUNCTION(library, XML_Parse),
          .stop_parser = SKYWAY_FUNCTION(library, XML_StopParser),
          .error_code = SKYWAY_FUNCTION(library, XML_GetErrorCode),
          .current_line = SKYWAY_FUNCTION(library, XML_GetCurrentLineNumber),
          .input_context = SKYWAY_FUNCTION(library, XML_GetInputContext)};
}

}  // namespace

const ExpatLibrary& expat() {
  static const ExpatLibrary library = load();
  return library;
}

}  // namespace geom
