# Target clang_syntax: core and gpu must also compile with clang 14 (clang-tidy and the fuzzers use
# it). Syntax only; a source is looked at again when it or a header of it changed.
find_program(CLANG NAMES clang++-14 clang++)
if(NOT CLANG)
  add_custom_target(clang_syntax
    COMMAND ${CMAKE_COMMAND} -E echo "clang_syntax: no clang++ 14 here"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
  return()
endif()

set(stamps)
foreach(room core gpu)
  set(includes $<TARGET_PROPERTY:burin_${room},INCLUDE_DIRECTORIES>)
  if(room STREQUAL core)
    set(includes $<REMOVE_DUPLICATES:${includes};$<TARGET_PROPERTY:burin_dicomweb,INCLUDE_DIRECTORIES>>)
  endif()
  # Ours with all warnings as errors, everybody else's as system headers, as with GCC.
  set(ours "^${CMAKE_SOURCE_DIR}$|^${CMAKE_BINARY_DIR}/generated$")
  set(theirs $<FILTER:${includes},EXCLUDE,${ours}|^/usr/include$>)
  set(definitions $<TARGET_PROPERTY:burin_${room},COMPILE_DEFINITIONS>)
  set(arguments ${CMAKE_CURRENT_BINARY_DIR}/clang-${room}.rsp)
  file(GENERATE OUTPUT ${arguments} CONTENT
    "-std=c++20\n-fPIC\n-fsyntax-only\n-Wall\n-Wextra\n-Wpedantic\n-Wshadow\n-Werror\n-I\"${CMAKE_SOURCE_DIR}\"\n-I\"${CMAKE_BINARY_DIR}/generated\"\n-isystem\"$<JOIN:${theirs},\"\n-isystem\">\"\n-D$<JOIN:${definitions},\n-D>\n")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${room}/*.cpp)
  foreach(source IN LISTS sources)
    file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR} ${source})
    string(REPLACE "/" "-" name ${name})
    set(stamp ${CMAKE_CURRENT_BINARY_DIR}/clang/${name}.ok)
    add_custom_command(OUTPUT ${stamp}
      COMMAND ${CLANG} @${arguments} -MD -MF ${stamp}.d -MQ ${stamp} ${source}
      COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
      DEPENDS ${source} ${arguments} DEPFILE ${stamp}.d
      COMMENT "clang syntax ${name}" VERBATIM)
    list(APPEND stamps ${stamp})
  endforeach()
endforeach()
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/clang)
add_custom_target(clang_syntax DEPENDS ${stamps})
