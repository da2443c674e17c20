# One function per kind of target, so that every folder's CMakeLists.txt is a list of files and neighbours.

# Checkouts in other places share what was compiled before, and so do build trees that differ in what they
# link. What a source depends on is known from its last compilation: none is read twice.
find_program(AXISC_CCACHE ccache)
if("$ENV{CCACHE_DIR}" STREQUAL "" AND NOT EXISTS "$ENV{HOME}/.cache/ccache" AND NOT EXISTS "$ENV{HOME}/.ccache")
  set(AXISC_CCACHE "")
endif()
if(AXISC_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT MSVC AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(launcher "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1
    CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros "${AXISC_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()

function(axisc_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF C_STANDARD 11 C_EXTENSIONS OFF)
  if(MSVC)
    target_compile_options(${target} PRIVATE /permissive- /W4 $<$<BOOL:${AXISC_DEVELOPER}>:/WX> $<$<COMPILE_LANGUAGE:CXX>:/GR->)
    return()
  endif()
  # Contracted multiply-adds would make images and filtered setpoints depend on the processor.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  # g++ collects garbage from 128 MB on, which takes a tenth of its time; half a gigabyte is there.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=524288)
  endif()
  if(AXISC_DEVELOPER)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
  endif()
  if(AXISC_BUILD_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(AXISC_SANITIZE)
    # Null, object sizes and types of objects cost a third of the compile time and find what the address
    # sanitizer or the processor reports anyway; alignment concerns the runtime alone, which reads numbers
    # where they lie.
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize=null,alignment,vptr,object-size
      -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# Targets in which no run spends its time, because they word what others have computed: optimised for those who
# wait for the compiler, they compile in half the time and run 2 % slower. Only for targets with
# precompiled headers of their own, or of another such target: g++ must not read those of another level.
function(axisc_lightly_optimised target)
  if(CMAKE_CXX_FLAGS_RELEASE MATCHES "-O2")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)
  endif()
endfunction()

# Sources that calculate and read no foreign bytes: extended precision costs most under sanitizers, to compile
# and to run, and the tests of every build compare its results with independent figures.
function(axisc_without_sanitizers)
  if(AXISC_SANITIZE)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fno-sanitize=all SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# What a shared library contains: position-independent, and its names stay inside unless a header shows them.
# Programs link the same objects, so that nothing is compiled twice; the static one, too: a compiler cache then
# fills its tree.
function(axisc_shareable target)
  if(AXISC_SHARED OR AXISC_STATIC)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden
      CXX_VISIBILITY_PRESET hidden)
  endif()
endfunction()

# The shared library libNAME.so.ABI of objects that are a target already; it shows the names in the version script.
function(axisc_shared_library target name abi script)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} VERSION ${abi}.${PROJECT_VERSION} SOVERSION ${abi}
    LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib" LINK_DEPENDS "${script}")
  if(NOT APPLE)
    target_link_options(${target} PRIVATE "LINKER:--version-script=${script}" LINKER:--no-undefined,-Bsymbolic-functions)
  endif()
endfunction()

# The standard headers, read once for all libraries: half of what most sources cost to compile. No source
# relies on it: the tidy preset and the cross-built runtime compile without.
set(AXISC_STANDARD_HEADERS <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map>
  <memory> <optional> <span> <string> <string_view> <tuple> <utility> <variant> <vector>)
function(axisc_standard_headers)
  set(source "${CMAKE_BINARY_DIR}/standard_headers.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "// Nothing: its target precompiles the standard headers.\n")
  add_library(axisc_standard_headers OBJECT "${source}")
  axisc_compile_options(axisc_standard_headers)
  axisc_shareable(axisc_standard_headers)
  target_precompile_headers(axisc_standard_headers PRIVATE ${AXISC_STANDARD_HEADERS})
endfunction()

# With AXISC_BATCHES the compiler reads up to ten sources of a folder at once, and instantiates once what they
# share: more than half of what they cost one by one. `list` of sources becomes one of files that include them,
# by paths that are the same in every checkout, as a compiler cache needs it (UNITY_BUILD has others). A second
# argument names the batches of sources that lie in several folders and are compiled together.
function(axisc_batches list)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE library)
  set(batches "")
  foreach(source IN LISTS ${list})
    cmake_path(SET path "${library}/${source}")
    cmake_path(GET path PARENT_PATH batch)
    if(ARGC GREATER 1)
      set(batch "${ARGV1}")
    endif()
    string(MAKE_C_IDENTIFIER "${batch}" batch)
    math(EXPR part "0${size_${batch}} / 10 + 1")
    math(EXPR size_${batch} "0${size_${batch}} + 1")
    list(APPEND batches "${batch}_${part}")
    string(APPEND includes_${batch}_${part} "#include \"${path}\"\n")
  endforeach()
  list(REMOVE_DUPLICATES batches)
  set(files "")
  foreach(batch IN LISTS batches)
    set(file "${CMAKE_CURRENT_BINARY_DIR}/batches/${batch}.cpp")
    file(CONFIGURE OUTPUT "${file}" CONTENT "${includes_${batch}}" @ONLY)
    list(APPEND files "${file}")
  endforeach()
  set(${list} "${files}" PARENT_SCOPE)
endfunction()

# axisc_library(grammar DEPENDS diagnostics PRIVATE_DEPENDS Boost::headers)
# makes the target axisc_grammar of all sources in the folder and below it, except those under EXCEPT (paths
# relative to the folder); SOURCES adds sources that the build writes. DEPENDS without "::" are folders of
# this project. OF_PROGRAM: no part of libaxisc. HEADERS are included by nearly all of its sources: read once,
# together with the standard ones; HEADERS_OF: those that another library has read, which
# is compiled as this one is, with the same definitions.
# IN_BATCHES: names in unnamed namespaces and sentences differ within a folder, so that its sources may be
# compiled together; those of the folders ALONE, and sources ALONE that have options of their own, are not.
function(axisc_library folder)
  cmake_parse_arguments(ARG "OF_PROGRAM;IN_BATCHES" "HEADERS_OF" "SOURCES;EXCEPT;ALONE;DEPENDS;PRIVATE_DEPENDS;HEADERS" ${ARGN})
  set(target axisc_${folder})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "*.cpp")
  foreach(except IN LISTS ARG_EXCEPT)
    list(FILTER sources EXCLUDE REGEX "^${except}")
  endforeach()
  if(ARG_IN_BATCHES AND AXISC_BATCHES)
    set(alone "")
    foreach(each IN LISTS ARG_ALONE)
      set(found ${sources})
      list(FILTER found INCLUDE REGEX "^${each}")
      list(FILTER sources EXCLUDE REGEX "^${each}")
      list(APPEND alone ${found})
    endforeach()
    axisc_batches(sources)
    list(APPEND sources ${alone})
  endif()
  add_library(${target} STATIC ${sources} ${ARG_SOURCES})
  add_library(axisc::${folder} ALIAS ${target})
  axisc_compile_options(${target})
  axisc_shareable(${target})
  if(NOT ARG_OF_PROGRAM)
    set_property(GLOBAL APPEND PROPERTY AXISC_LIBRARIES ${target})
  endif()
  if(ARG_HEADERS)
    # In angle brackets CMake leaves a path as it is: the same in every checkout.
    list(TRANSFORM ARG_HEADERS REPLACE "^([a-z_/]+[.]hpp)$" "<\\1>")
    target_precompile_headers(${target} PRIVATE ${AXISC_STANDARD_HEADERS} ${ARG_HEADERS})
  elseif(ARG_HEADERS_OF)
    target_precompile_headers(${target} REUSE_FROM axisc_${ARG_HEADERS_OF})
  else()
    target_precompile_headers(${target} REUSE_FROM axisc_standard_headers)
  endif()
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>")
  foreach(neighbour IN LISTS ARG_DEPENDS)
    if(neighbour MATCHES "::")
      target_link_libraries(${target} PUBLIC ${neighbour})
    else()
      target_link_libraries(${target} PUBLIC axisc_${neighbour})
    endif()
  endforeach()
  if(ARG_PRIVATE_DEPENDS)
    target_link_libraries(${target} PRIVATE ${ARG_PRIVATE_DEPENDS})
  endif()
endfunction()

# Sources of tests: the code under test is optimised, its callers need not be, and Catch2 is read once.
function(axisc_test_options target)
  axisc_compile_options(${target})
  target_compile_options(${target} PRIVATE -O0)
  target_precompile_headers(${target} REUSE_FROM axisc_test_support)
endfunction()

# The header that is read once was read for sources that are not optimised.
function(axisc_test_optimised)
  if(ARGN)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -O2 SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# axisc_test(grammar DEPENDS axisc_grammar) makes the program test_grammar of all sources in the folder and in
# those directly below it, and the test "grammar". SOURCES adds others; with ONLY these are all. With SHARDS n
# the test is run in n parts, "grammar_1" and so on, so that all processors have work: every n-th source each.
# OPTIMISED names sources that compute for longer than it takes to compile them so.
function(axisc_test name)
  cmake_parse_arguments(ARG "ONLY" "SHARDS" "SOURCES;EXCEPT;DEPENDS;OPTIMISED" ${ARGN})
  set(target test_${name})
  set(sources "")
  if(NOT ARG_ONLY)
    file(GLOB sources CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "*.cpp" "*/*.cpp")
    foreach(except IN LISTS ARG_EXCEPT)
      list(FILTER sources EXCLUDE REGEX "^${except}")
    endforeach()
  endif()
  set(alone ${sources})
  set(batched "")
  if(AXISC_BATCHES)
    # What serves them is compiled alone: several programs have some of it.
    set(batched ${sources})
    list(FILTER batched INCLUDE REGEX "[.]test[.]cpp$")
    list(FILTER alone EXCLUDE REGEX "[.]test[.]cpp$")
    axisc_batches(batched)
  endif()
  add_executable(${target} ${batched} ${alone} ${ARG_SOURCES})
  axisc_test_options(${target})
  axisc_test_optimised(${ARG_OPTIMISED})
  target_link_libraries(${target} PRIVATE axisc_test_support ${ARG_DEPENDS})
  # Sanitizers take ten times as long, and a busy machine doubles that.
  set(limit 600)
  if(AXISC_SANITIZE)
    set(limit 2400)
  endif()
  set(tests "")
  if(ARG_SHARDS)
    math(EXPR last "${ARG_SHARDS} - 1")
    foreach(shard RANGE ${last})
      set(filter_${shard} "")
    endforeach()
    set(shard 0)
    foreach(source IN LISTS sources)
      if(NOT source MATCHES "[.]test[.]cpp$")
        continue()
      endif()
      cmake_path(GET source STEM LAST_ONLY file)
      # Without those that are hidden, which naming their file would show.
      list(APPEND filter_${shard} "[#${file}]~[.]")
      math(EXPR shard "(${shard} + 1) % ${ARG_SHARDS}")
    endforeach()
    foreach(shard RANGE ${last})
      math(EXPR number "${shard} + 1")
      list(JOIN filter_${shard} "," filter)
      add_test(NAME ${name}_${number} COMMAND ${target} --filenames-as-tags "${filter}")
      list(APPEND tests ${name}_${number})
    endforeach()
  else()
    add_test(NAME ${name} COMMAND ${target})
    set(tests ${name})
  endif()
  set_tests_properties(${tests} PROPERTIES TIMEOUT ${limit})
endfunction()
