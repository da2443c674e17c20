# Coefficient images as targets of a CMake project.
#
#   find_package(axisc REQUIRED)
#   axisc_add_image(mill machine.json)                                # mill.axim in the current binary folder
#   axisc_add_image(x_axis axes/x.lis OUTPUT images/x.axim CYCLE_TIME 1ms OPTIONS --strip --werror)
#
#   axisc_add_image(<target> <list or machine file>
#     [OUTPUT <file>]        default <target>.axim; relative to the current binary folder
#     [CYCLE_TIME <time>]    1ms, 250us; a list alone needs it
#     [OPTIONS <option>...]  further options of `axisc compile`
#     [NOT_IN_ALL])          only built when something needs it
#
# The image is made again when one of the files changes that it was made from: lists, default lists, NC
# programs, settings and schema files, which the program itself names. An image that would be the same is not
# touched; with Ninja nothing that depends on it is built then. The target's property AXISC_IMAGE is the
# image's path.
include_guard()

function(axisc_add_image target input)
  cmake_parse_arguments(PARSE_ARGV 2 ARG "NOT_IN_ALL" "OUTPUT;CYCLE_TIME" "OPTIONS")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "axisc_add_image: what is \"${ARG_UNPARSED_ARGUMENTS}\"?")
  endif()
  if(NOT ARG_OUTPUT)
    set(ARG_OUTPUT "${target}.axim")
  endif()
  cmake_path(ABSOLUTE_PATH input BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
  cmake_path(ABSOLUTE_PATH ARG_OUTPUT BASE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}" NORMALIZE)
  cmake_path(GET ARG_OUTPUT PARENT_PATH folder)
  file(MAKE_DIRECTORY "${folder}")

  set(options --quiet ${ARG_OPTIONS})
  if(ARG_CYCLE_TIME)
    list(APPEND options --cycle-time "${ARG_CYCLE_TIME}")
  endif()
  set(after "")
  if(NOT CMAKE_GENERATOR MATCHES "Ninja")
    # Only Ninja notices that an image stayed as it was; make would run this command for ever.
    set(after COMMAND "${CMAKE_COMMAND}" -E touch "${ARG_OUTPUT}")
  endif()
  add_custom_command(OUTPUT "${ARG_OUTPUT}"
    COMMAND axisc::axisc compile "${input}" -o "${ARG_OUTPUT}" --depfile "${ARG_OUTPUT}.d" ${options}
    ${after}
    DEPENDS "${input}" axisc::axisc
    DEPFILE "${ARG_OUTPUT}.d"
    COMMENT "Compiling the image ${target}" VERBATIM)
  if(ARG_NOT_IN_ALL)
    add_custom_target(${target} DEPENDS "${ARG_OUTPUT}")
  else()
    add_custom_target(${target} ALL DEPENDS "${ARG_OUTPUT}")
  endif()
  set_target_properties(${target} PROPERTIES AXISC_IMAGE "${ARG_OUTPUT}")
endfunction()
