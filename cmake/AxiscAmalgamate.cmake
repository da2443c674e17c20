# cmake -DROOT=... -DSOURCES=a.cpp,b.cpp -DOUTPUT=... -P AxiscAmalgamate.cmake
# Writes the runtime as one source: every header of its own where it is first included, tables (.inc) each
# time. The public header stays next to it.
cmake_minimum_required(VERSION 3.25)
set(seen "")

function(expand path result)
  file(READ "${ROOT}/${path}" rest)
  string(REPLACE "#pragma once\n" "" rest "${rest}")
  set(text "")
  while(TRUE)
    string(FIND "${rest}" "#include \"" begin)
    if(begin EQUAL -1)
      break()
    endif()
    string(SUBSTRING "${rest}" 0 ${begin} before)
    string(SUBSTRING "${rest}" ${begin} -1 rest)
    string(FIND "${rest}" "\n" end)
    string(SUBSTRING "${rest}" 0 ${end} line)
    math(EXPR end "${end} + 1")
    string(SUBSTRING "${rest}" ${end} -1 rest)
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" name "${line}")
    string(APPEND text "${before}")
    if(name MATCHES "\\.inc$" OR NOT name IN_LIST seen)
      list(APPEND seen "${name}")
      if(name STREQUAL "axisrt.h")
        string(APPEND text "${line}\n")
      else()
        expand("${name}" inner)
        string(APPEND text "${inner}")
      endif()
    endif()
  endwhile()
  set(seen "${seen}" PARENT_SCOPE)
  set(${result} "${text}${rest}" PARENT_SCOPE)
endfunction()

file(READ "${ROOT}/LICENSE" licence)
set(all "// axisrt, the runtime of axisc, in one source: C++20, level portable, needs axisrt.h and nothing but memory functions.
//
// Multiplications and additions must not become one instruction: outputs would depend on the processor. The lines below say so to
// GCC, Clang and MSVC; give other compilers their option for it. No -ffast-math.
/*
${licence}*/
#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__GNUC__)
#pragma GCC optimize(\"fp-contract=off\")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

")
string(REPLACE "," ";" SOURCES "${SOURCES}")
foreach(source IN LISTS SOURCES)
  expand("runtime/${source}" text)
  string(APPEND all "${text}\n")
endforeach()
file(WRITE "${OUTPUT}" "${all}")
