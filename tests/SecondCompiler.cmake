# Target second_compiler: the product must compile with GCC and with clang 14 (clang-tidy and the
# fuzzers use that). The one that does not build it here reads core and gpu: syntax only, a folder's
# sources together (secondCompiler.sh), so that other people's headers are read once for many. A
# group is looked at again when a source or a header of it changed.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  find_program(SECOND_COMPILER NAMES g++-12 g++)
  # It warns of unnamed namespaces in included sources, which here all are.
  set(grouped "-Wno-subobject-linkage\n")
else()
  find_program(SECOND_COMPILER NAMES clang++-14 clang++)
endif()
if(NOT SECOND_COMPILER)
  add_custom_target(second_compiler
    COMMAND ${CMAKE_COMMAND} -E echo "second_compiler: neither g++ nor clang++ 14 beside the compiler of this build"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
  return()
endif()

set(most_in_group 16)
set(script ${CMAKE_CURRENT_SOURCE_DIR}/secondCompiler.sh)
set(stamps)
foreach(room core gpu)
  set(includes $<TARGET_PROPERTY:burin_${room},INCLUDE_DIRECTORIES>)
  if(room STREQUAL core)
    set(includes $<REMOVE_DUPLICATES:${includes};$<TARGET_PROPERTY:burin_dicomweb,INCLUDE_DIRECTORIES>>)
  endif()
  # Ours with all warnings as errors, everybody else's as system headers, as in the build.
  set(ours "^${CMAKE_SOURCE_DIR}$|^${CMAKE_BINARY_DIR}/generated$")
  set(theirs $<FILTER:${includes},EXCLUDE,${ours}|^/usr/include$>)
  set(definitions $<TARGET_PROPERTY:burin_${room},COMPILE_DEFINITIONS>)
  set(arguments ${CMAKE_CURRENT_BINARY_DIR}/second-${room}.rsp)
  file(GENERATE OUTPUT ${arguments} CONTENT
    "-std=c++20\n-fPIC\n-fsyntax-only\n-Wall\n-Wextra\n-Wpedantic\n-Wshadow\n-Wno-missing-field-initializers\n${grouped}-Werror\n-I\"${CMAKE_SOURCE_DIR}\"\n-I\"${CMAKE_BINARY_DIR}/generated\"\n-isystem\"$<JOIN:${theirs},\"\n-isystem\">\"\n-D$<JOIN:${definitions},\n-D>\n")
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
      COMMAND bash ${script} ${stamp} ${SECOND_COMPILER} ${arguments} ${group}
      DEPENDS ${group} ${arguments} ${script} DEPFILE ${stamp}.d
      COMMENT "second compiler: ${room}, group ${number}" VERBATIM)
    list(APPEND stamps ${stamp})
    math(EXPR number "${number} + 1")
  endwhile()
endforeach()
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/second)
add_custom_target(second_compiler DEPENDS ${stamps})
