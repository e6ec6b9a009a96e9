# Makes the page of --html, without data, of the files in this folder, and C++ that holds it.
# cmake -Dscript=BUNDLE.js -Dfolder=THIS_FOLDER -Doutput=OUT.cpp -P make_page.cmake

file(READ "${folder}/page.html" page)
file(READ "${folder}/page.css" style)
file(READ "${script}" program)
string(REPLACE "@WIREFRAME_STYLE@" "${style}" page "${page}")
string(REPLACE "@WIREFRAME_SCRIPT@" "${program}" page "${page}")
set(page_file "${output}.html")
file(WRITE "${page_file}" "${page}")
file(READ "${page_file}" bytes HEX)
string(LENGTH "${bytes}" size)
math(EXPR size "${size} / 2")
string(REGEX REPLACE "(................................................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${output}" "#include <cstddef>\n
namespace tool {\n
extern const unsigned char page_template[];
extern const std::size_t page_template_size;
const unsigned char page_template[] = {\n${bytes}\n};
const std::size_t page_template_size = ${size};\n
} // namespace tool\n")
