# cmake -DOUT=FILE.cpp "-DSCRIPTS=a.py|b.py" -P embed_scripts.cmake: scripts as string constants.
string(REPLACE "|" ";" paths "${SCRIPTS}")
set(rows "")
foreach(path IN LISTS paths)
  file(READ "${path}" text)
  get_filename_component(name "${path}" NAME)
  # A literal holds 64 kB at most by the standard's own minimum, so long ones are joined of parts.
  set(literal "")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 16000 part)
    string(APPEND literal "R\"skyway_py(${part})skyway_py\" ")
    math(EXPR at "${at} + 16000")
  endwhile()
  string(APPEND rows "  {\"${name}\", ${literal}},\n")
endforeach()
file(WRITE "${OUT}" "// Made of scripts in tests/tools: do not edit.\n#include \"traj/submit/verify_scripts.h\"\n\n"
  "namespace traj {\nnamespace {\nconstexpr VerifyScript kScripts[] = {\n${rows}};\n}  // namespace\n\n"
  "std::span<const VerifyScript> verify_scripts() { return kScripts; }\n}  // namespace traj\n")
