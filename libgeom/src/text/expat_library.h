#pragma once

// Expat's functions; Expat is loaded when the first is needed.

#include <expat.h>

namespace geom {

// Every tool can be given a file of XML, and few are.
struct ExpatLibrary {
  decltype(XML_ParserCreate)* parser_create;
  decltype(XML_ParserFree)* parser_free;
  decltype(XML_SetUserData)* set_user_data;
  decltype(XML_SetElementHandler)* set_element_handler;
  decltype(XML_SetCharacterDataHandler)* set_character_data_handler;
  decltype(XML_SetStartDoctypeDeclHandler)* set_start_doctype_handler;
  decltype(XML_SetUnknownEncodingHandler)* set_unknown_encoding_handler;
  decltype(XML_Parse)* parse;
  decltype(XML_StopParser)* stop_parser;
  decltype(XML_GetErrorCode)* error_code;
  decltype(XML_GetCurrentLineNumber)* current_line;
  decltype(XML_GetInputContext)* input_context;
};

// Throws what LoadedLibrary throws, each time. Threads may call at once.
const ExpatLibrary& expat();

}  // namespace geom
