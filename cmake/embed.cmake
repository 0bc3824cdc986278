# gapcheck_embed(TARGET SYMBOL FILES file…): compiles text files into a target as
#   namespace gapcheck::embedded { extern const std::span<const Text> SYMBOL; }   (see base/embedded.hpp)
# one entry per file, in the order given, named by the file's base name.
function(gapcheck_embed target symbol)
  cmake_parse_arguments(EMBED "" "" "FILES" ${ARGN})
  set(texts "")
  set(entries "")
  foreach(file ${EMBED_FILES})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(base ${file} NAME_WE)
    file(READ ${file} content)
    string(MAKE_C_IDENTIFIER "text_${base}" text)
    # Arrays, since their length is known without counting: compilers refuse to count long texts.
    string(APPEND texts "constexpr char ${text}[] = R\"=gapcheck=(${content})=gapcheck=\";\n")
    string(APPEND entries "    {\"${base}\", {${text}, sizeof ${text} - 1}},\n")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_${symbol}.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
"#include \"base/embedded.hpp\"
namespace gapcheck::embedded {
extern const std::span<const Text> ${symbol};
namespace {
${texts}constexpr Text table_${symbol}[] = {
${entries}};
}
const std::span<const Text> ${symbol}{table_${symbol}};
}  // namespace gapcheck::embedded
")
  set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
  target_sources(${target} PRIVATE ${source})
endfunction()
