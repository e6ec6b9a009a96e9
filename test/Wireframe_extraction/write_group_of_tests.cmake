# Writes to `output` one program of the tests `sources`, which runs the one that its argument names. Each is in a namespace of
# its own, so all that they include is included before; what depends on the configuration goes on doing so.
set(includes)
set(tests)
set(calls)
foreach(source IN LISTS sources)
  get_filename_component(name "${source}" NAME_WE)
  file(STRINGS "${source}" lines REGEX "^#(include|if|elif|else|endif|define)")
  list(JOIN lines "\n" lines)
  string(REGEX REPLACE "#define .*" "" lines "${lines}") # what comes then is not for the others
  string(APPEND includes "${lines}\n")
  string(APPEND tests "namespace ${name} {\n#include \"${source}\"\n} // namespace ${name}\n")
  string(APPEND calls "  if (name == \"${name}\")\n    return ${name}::main();\n")
endforeach()
file(WRITE "${output}" "${includes}#include <iostream>
#include <string>

${tests}
int main(int argc, char** argv)
{
  const std::string name = argc == 2 ? argv[1] : \"\";
${calls}  std::cerr << \"There is no test of the name '\" << name << \"'\\n\";
  return 2;
}
")
