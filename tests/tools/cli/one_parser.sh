#!/bin/bash
# one_parser.sh SOURCE_DIR: JSON and XML are parsed in one place each, which refuses what must not be believed.
cd "$1" || exit 2
calls=$(grep -rnE "(json|Json)::(parse|sax_parse|accept|from_[a-z]+)\(|>> *json" --include=*.cpp --include=*.h \
          libgeom libplan libtraj tools | grep -v "^libgeom/src/text/worded_json.cpp:")
fast=$(grep -rnE "simdjson(\.h>|::|_value\()" --include=*.cpp --include=*.h libgeom libplan libtraj tools \
         | grep -vE "^libgeom/src/text/(simdjson_value\.(cpp|h)|parse_json\.cpp):")
words=$(grep -rnE -A3 "catch \(const .*(json|Json)::exception& [a-z]+\)" --include=*.cpp libgeom libplan libtraj tools)
xml=$(grep -rnE "<(expat|libxml/[a-z]+|tinyxml2?|pugixml|cpl_minixml)\.(h|hpp)>" --include=*.cpp --include=*.h libgeom libplan libtraj tools \
        | grep -v "^libgeom/src/text/expat_library.h:")
if [[ $calls ]]; then echo "parse JSON by geom::parse_json:"; echo "$calls"; fi
if [[ $fast ]]; then echo "what simdjson reads, parse_json alone gives:"; echo "$fast"; fi
if [[ $words ]]; then echo "say it in our words, not in the library's:"; echo "$words"; fi
if [[ $xml ]]; then echo "read XML by geom::parse_xml or geom::read_xml:"; echo "$xml"; fi
[[ ! $calls && ! $fast && ! $words && ! $xml ]]
