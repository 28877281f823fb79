# cmake -DOUT=FILE.cpp -DHTML=… -DTHREE=… "-DSTYLES=a.css|b.css" "-DSCRIPTS=a.js|b.js" -P embed.cmake
# Joins the sources of the page into string constants. The scripts share one function's scope.

function(joined out paths)
  string(REPLACE "|" ";" paths "${paths}")
  set(text "")
  foreach(path IN LISTS paths)
    file(READ "${path}" part)
    string(APPEND text "${part}")
  endforeach()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

joined(style "${STYLES}")
joined(script "${SCRIPTS}")
file(READ "${HTML}" html)
file(READ "${THREE}" three)
set(begin "R\"skyway_page(")
set(end ")skyway_page\"")
file(WRITE "${OUT}" "// Joined from tools/view/page and three.js: do not edit.\n#include \"view/page.h\"\n\n"
  "namespace view {\nconst std::string_view kPageHtml = ${begin}${html}${end};\n"
  "const std::string_view kPageStyle = ${begin}${style}${end};\n"
  "const std::string_view kPageScript = ${begin}(() => {\n\"use strict\";\n${script}})();\n${end};\n"
  "const std::string_view kPageThree = ${begin}")
file(APPEND "${OUT}" "${three}" "${end};\n}  // namespace view\n")
