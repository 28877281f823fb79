#include "expat_library.h"

#include "geom/base/loaded_library.h"

namespace geom {
namespace {

ExpatLibrary load() {
  const LoadedLibrary library(SKYWAY_EXPAT_SONAME, "libexpat1");
  return {.parser_create = library.function("XML_ParserCreate"),
          .parser_free = library.function("XML_ParserFree"),
          .set_user_data = library.function("XML_SetUserData"),
          .set_element_handler = library.function("XML_SetElementHandler"),
          .set_character_data_handler = library.function("XML_SetCharacterDataHandler"),
          .set_start_doctype_handler = library.function("XML_SetStartDoctypeDeclHandler"),
          .set_unknown_encoding_handler = library.function("XML_SetUnknownEncodingHandler"),
          .parse = library.function("XML_Parse"),
          .stop_parser = library.function("XML_StopParser"),
          .error_code = library.function("XML_GetErrorCode"),
          .current_line = library.function("XML_GetCurrentLineNumber"),
          .input_context = library.function("XML_GetInputContext")};
}

}  // namespace

const ExpatLibrary& expat() {
  static const ExpatLibrary library = load();
  return library;
}

}  // namespace geom
