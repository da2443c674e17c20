# Parts of other projects in what is installed: axisc.spdx.json, a bill of materials (SPDX 2.3), and the licences
# in one text. Libraries that are linked dynamically are not contained. Both files are the same bytes for the
# same inputs.

# axisc_part(NAME VERSION LICENCE SOURCE FILE): LICENCE as SPDX writes it, FILE with its text.
function(axisc_part name version licence source file)
  string(MAKE_C_IDENTIFIER "${name}" identifier)
  string(REPLACE "_" "-" identifier "SPDXRef-${identifier}")
  set(part "{\"licenseDeclared\": \"${licence}\", \"copyrightText\": \"NOASSERTION\", \"downloadLocation\": \"${source}\",
    \"filesAnalyzed\": false, \"licenseConcluded\": \"${licence}\", \"name\": \"${name}\", \"versionInfo\": \"${version}\"}")
  string(JSON part SET "${part}" SPDXID "\"${identifier}\"")
  string(JSON relationship SET "{}" spdxElementId "\"SPDXRef-axisc\"")
  string(JSON relationship SET "${relationship}" relationshipType "\"CONTAINS\"")
  string(JSON relationship SET "${relationship}" relatedSpdxElement "\"${identifier}\"")
  string(JSON count LENGTH "${bom}" packages)
  string(JSON bom SET "${bom}" packages ${count} "${part}")
  string(JSON count LENGTH "${bom}" relationships)
  string(JSON bom SET "${bom}" relationships ${count} "${relationship}")
  set(bom "${bom}" PARENT_SCOPE)
  set(text "See ${source}.\n")
  if(EXISTS "${file}")
    file(READ "${file}" text)
  endif()
  set(licences "${licences}==== ${name} ${version}: ${licence}\n\n${text}\n" PARENT_SCOPE)
endfunction()

# axisc_bill(FOLDER NAME PURPOSE shared|embedded|static): both files, of the program axisc or the library libaxisc,
# PURPOSE as SPDX has it. Which libraries it contains: those that are headers, all but the C library, all.
function(axisc_bill folder name purpose libraries)
  set(licences "")
  string(UUID namespace NAMESPACE 6ba7b811-9dad-11d1-80b4-00c04fd430c8 NAME "${name} ${PROJECT_VERSION} ${AXISC_ORIGIN} ${libraries}"
    TYPE SHA1)
  string(CONFIGURE [[{
    "spdxVersion": "SPDX-2.3",
    "dataLicense": "CC0-1.0",
    "SPDXID": "SPDXRef-DOCUMENT",
    "name": "@name@-@PROJECT_VERSION@",
    "documentNamespace": "urn:uuid:@namespace@",
    "creationInfo": {"created": "@AXISC_DATE@T00:00:00Z", "creators": ["Tool: axisc-@PROJECT_VERSION@", "Organization: The axisc authors"]},
    "packages": [{
      "SPDXID": "SPDXRef-axisc", "name": "@name@", "versionInfo": "@PROJECT_VERSION@", "downloadLocation": "NOASSERTION",
      "filesAnalyzed": false, "licenseConcluded": "MIT", "licenseDeclared": "MIT", "copyrightText": "Copyright (c) 2026 The axisc authors",
      "primaryPackagePurpose": "@purpose@", "comment": "@AXISC_ORIGIN@"
    }],
    "relationships": [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-axisc"}]
  }]] bom @ONLY)

  if(AXISC_HOMEPAGE)
    string(JSON bom SET "${bom}" packages 0 homepage "\"${AXISC_HOMEPAGE}\"")
  endif()

  # Debian keeps the licence of each package there; elsewhere the text refers to the project.
  set(debian /usr/share/doc)
  file(STRINGS "${PROJECT_SOURCE_DIR}/presentation/pictures/uplot/refresh" uplot REGEX "^version=")
  string(REPLACE "version=" "" uplot "${uplot}")
  axisc_part(uPlot ${uplot} MIT "https://github.com/leeoniya/uPlot" "${PROJECT_SOURCE_DIR}/presentation/pictures/uplot/LICENSE")
  axisc_part(Boost ${Boost_VERSION_STRING} BSL-1.0 "https://www.boost.org" "${PROJECT_SOURCE_DIR}/cmake/licences/boost/LICENSE")
  axisc_part(fmt ${fmt_VERSION} MIT "https://github.com/fmtlib/fmt" "${debian}/libfmt-dev/copyright")
  axisc_part("JSON for Modern C++" ${nlohmann_json_VERSION} MIT "https://github.com/nlohmann/json" "${debian}/nlohmann-json3-dev/copyright")
  if("${name}" STREQUAL "axisc")
    axisc_part(CLI11 ${CLI11_VERSION} BSD-3-Clause "https://github.com/CLIUtils/CLI11" "${debian}/libcli11-dev/copyright")
  endif()
  if(NOT "${libraries}" STREQUAL "shared")
    axisc_part(libsodium ${sodium_VERSION} ISC "https://libsodium.org" "${debian}/libsodium-dev/copyright")
    axisc_part(pugixml ${pugixml_VERSION} MIT "https://pugixml.org" "${debian}/libpugixml-dev/copyright")
    axisc_part(zlib ${ZLIB_VERSION_STRING} Zlib "https://zlib.net" "${debian}/zlib1g-dev/copyright")
    string(REGEX MATCH "^[0-9]+" gcc "${CMAKE_CXX_COMPILER_VERSION}")
    axisc_part("GCC runtime libraries" ${CMAKE_CXX_COMPILER_VERSION} "GPL-3.0-or-later WITH GCC-exception-3.1" "https://gcc.gnu.org"
      "${debian}/libstdc++-${gcc}-dev/copyright")
    if(WIN32)
      axisc_debian_version(mingw mingw-w64-x86-64-dev)
      axisc_part(mingw-w64 "${mingw}" "ZPL-2.1" "https://www.mingw-w64.org" "${debian}/mingw-w64-x86-64-dev/copyright")
    elseif("${libraries}" STREQUAL "static")
      execute_process(COMMAND getconf GNU_LIBC_VERSION OUTPUT_VARIABLE glibc OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
      string(REPLACE "glibc " "" glibc "${glibc}")
      axisc_part(glibc "${glibc}" LGPL-2.1-or-later "https://sourceware.org/glibc" "${debian}/libc6-dev/copyright")
    endif()
  endif()
  file(CONFIGURE OUTPUT "${folder}/axisc.spdx.json" CONTENT "${bom}\n" @ONLY)
  file(CONFIGURE OUTPUT "${folder}/third-party-licences.txt" CONTENT "${licences}" @ONLY)
endfunction()

set(libraries_of_program shared)
if(AXISC_STATIC OR AXISC_COMPILE_LIBRARIES)
  set(libraries_of_program static)
endif()
axisc_bill("${AXISC_NOTICES}" axisc APPLICATION ${libraries_of_program})
if(TARGET libaxisc)
  axisc_bill("${AXISC_NOTICES}/libaxisc" libaxisc LIBRARY shared)
  axisc_bill("${AXISC_NOTICES}/self_contained" libaxisc LIBRARY embedded)
endif()
