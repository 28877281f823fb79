#pragma once

// Expat's functions; Expat is loaded when the first is needed.

#include <expat.h>

#include "geom/base/loaded_library.h"

namespace geom {

// Every tool can be given a file of XML, and few are.
struct ExpatLibrary {
  LoadedLibrary library;
  SKYWAY_LOADED(parser_create, XML_ParserCreate);
  SKYWAY_LOADED(parser_free, XML_ParserFree);
  SKYWAY_LOADED(set_user_data, XML_SetUserData);
  SKYWAY_LOADED(set_element_handler, XML_SetElementHandler);
  SKYWAY_LOADED(set_character_data_handler, XML_SetCharacterDataHandler);
  SKYWAY_LOADED(set_start_doctype_handler, XML_SetStartDoctypeDeclHandler);
  SKYWAY_LOADED(set_unknown_encoding_handler, XML_SetUnknownEncodingHandler);
  SKYWAY_LOADED(parse, XML_Parse);
  SKYWAY_LOADED(stop_parser, XML_StopParser);
  SKYWAY_LOADED(error_code, XML_GetErrorCode);
  SKYWAY_LOADED(current_line, XML_GetCurrentLineNumber);
  SKYWAY_LOADED(input_context, XML_GetInputContext);
};

// Throws what LoadedLibrary throws, each time. Threads may call at once.
const ExpatLibrary& expat();

}  // namespace geom
