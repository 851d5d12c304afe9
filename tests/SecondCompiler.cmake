# Target second_compiler: the product must compile with GCC and with clang 14 (clang-tidy and the
# fuzzers use that). The one that does not build it here reads core and gpu: syntax only, a folder's
# sources together (secondCompiler.sh), so that other people's headers are read once for many. A
# group is looked at again when a source or a header of it changed.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  find_program(SECOND_COMPILER NAMES g++-12 g++)
  # It warns of unnamed namespaces in included sources, which here all are.
  set(grouped "-Wno-subobject-linkage\n")
  set(first_error_only "-fmax-errors=1\n")
else()
  find_program(SECOND_COMPILER NAMES clang++-14 clang++)
  set(first_error_only "-ferror-limit=1\n")
endif()
if(NOT SECOND_COMPILER)
  add_custom_target(second_compiler
    COMMAND ${CMAKE_COMMAND} -E echo "second_compiler: neither g++ nor clang++ 14 beside the compiler of this build"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
  return()
endif()

set(most_in_group 16)
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/second)
set(script ${CMAKE_CURRENT_SOURCE_DIR}/secondCompiler.sh)
set(stamps)
foreach(room core gpu)
  set(includes $<TARGET_PROPERTY:burin_${room},INCLUDE_DIRECTORIES>)
  if(room STREQUAL core)
    set(includes $<REMOVE_DUPLICATES:${includes};$<TARGET_PROPERTY:burin_dicomweb,INCLUDE_DIRECTORIES>>)
  endif()
  # Ours with all warnings as errors, everybody else's as system headers, as in the build.
  # A folder may be named after a compiler: the signs of g++ mean themselves.
  string(REGEX REPLACE "([][+.*?^$()|])" "\\\\\\1" source "${CMAKE_SOURCE_DIR}")
  string(REGEX REPLACE "([][+.*?^$()|])" "\\\\\\1" binary "${CMAKE_BINARY_DIR}")
  set(ours "^${source}$|^${binary}/generated$")
  set(theirs $<FILTER:${includes},EXCLUDE,${ours}|^/usr/include$>)
  set(definitions $<TARGET_PROPERTY:burin_${room},COMPILE_DEFINITIONS>)
  set(arguments ${CMAKE_CURRENT_BINARY_DIR}/second-${room}.rsp)
  file(GENERATE OUTPUT ${arguments} CONTENT
    "-std=c++20\n-fPIC\n${first_error_only}-Wall\n-Wextra\n-Wpedantic\n-Wshadow\n-Wno-missing-field-initializers\n${grouped}-Werror\n-I\"${CMAKE_SOURCE_DIR}\"\n-I\"${CMAKE_BINARY_DIR}/generated\"\n-isystem\"$<JOIN:${theirs},\"\n-isystem\">\"\n-D$<JOIN:${definitions},\n-D>\n")
  # Other people's headers, read once for the whole room.
  set(headers ${CMAKE_CURRENT_BINARY_DIR}/second/${room}.h)
  list(TRANSFORM burin_precompiled PREPEND "#include " OUTPUT_VARIABLE includes_of_others)
  list(JOIN includes_of_others "\n" includes_of_others)
  file(CONFIGURE OUTPUT ${headers} CONTENT "${includes_of_others}\n" @ONLY)
  set(precompiled)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    set(precompiled ${headers}.gch)
    add_custom_command(OUTPUT ${precompiled}
      COMMAND ${SECOND_COMPILER} @${arguments} -x c++-header ${headers} -o ${precompiled}
      DEPENDS ${headers} ${arguments} COMMENT "second compiler: ${room}, headers of others" VERBATIM)
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${room}/*.cpp)
  list(SORT sources)
  list(LENGTH sources left)
  set(number 0)
  while(left GREATER 0)
    list(SUBLIST sources 0 ${most_in_group} group)
    if(left GREATER most_in_group)
      list(SUBLIST sources ${most_in_group} -1 sources)
    else()
      set(sources)
    endif()
    list(LENGTH sources left)
    set(stamp ${CMAKE_CURRENT_BINARY_DIR}/second/${room}-${number}.ok)
    add_custom_command(OUTPUT ${stamp}
      COMMAND bash ${script} ${stamp} ${SECOND_COMPILER} ${arguments} ${headers} ${group}
      DEPENDS ${group} ${arguments} ${headers} ${precompiled} ${script} DEPFILE ${stamp}.d
      COMMENT "second compiler: ${room}, group ${number}" VERBATIM)
    list(APPEND stamps ${stamp})
    math(EXPR number "${number} + 1")
  endwhile()
endforeach()
add_custom_target(second_compiler DEPENDS ${stamps})
