# What the functions of this folder share: checks of a call, compiled tables, and the generator that compiles them.

# articam_check_call(function Name REQUIRED...): refuses what cmake_parse_arguments(arg ...) has left over or missed.
function(articam_check_call function name)
  set(usage "${function}(${name}):")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${usage} unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  foreach(keyword IN LISTS arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "${usage} ${keyword} has no value")
  endforeach()
  foreach(keyword IN LISTS ARGN)
    if(NOT arg_${keyword})
      message(FATAL_ERROR "${usage} ${keyword} is missing")
    endif()
  endforeach()
endfunction()

# articam_find_generator(usage): the target articam::generator, an articam-modelgen that runs on this machine. A build
# of articam and a native package have made it; otherwise it is ARTICAM_MODELGEN, or found in PATH.
function(articam_find_generator usage)
  if(TARGET articam::generator)
    return()
  endif()
  # Not where CMake looks for what belongs to the board.
  find_program(ARTICAM_MODELGEN NAMES articam-modelgen NO_PACKAGE_ROOT_PATH NO_CMAKE_PATH NO_CMAKE_ENVIRONMENT_PATH
    NO_CMAKE_SYSTEM_PATH NO_CMAKE_FIND_ROOT_PATH DOC "The articam-modelgen of this machine")
  get_target_property(version articam::core ARTICAM_VERSION)
  set(remedy "Install articam ${version} on this machine, or set ARTICAM_MODELGEN to its articam-modelgen")
  if(NOT ARTICAM_MODELGEN)
    message(FATAL_ERROR "${usage} no articam-modelgen that runs on this machine. ${remedy}")
  endif()
  execute_process(COMMAND ${ARTICAM_MODELGEN} --version
    OUTPUT_VARIABLE answer ERROR_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${usage} ${ARTICAM_MODELGEN} does not run on this machine (${result}). ${remedy}")
  endif()
  if(NOT answer STREQUAL "articam-modelgen ${version}")
    message(FATAL_ERROR "${usage} ${ARTICAM_MODELGEN} says '${answer}', the libraries are ${version}. ${remedy}")
  endif()
  add_executable(articam::generator IMPORTED)
  set_target_properties(articam::generator PROPERTIES IMPORTED_LOCATION ${ARTICAM_MODELGEN})
endfunction()

# articam_add_table(KIND Name SYMBOL symbol INPUTS f ... OPTIONS o ... [BYPRODUCTS f ...]): what a model and a camera
# are to the build. Makes articam::KINDs::Name with the header KINDs/name.hpp, which defines SYMBOL.
function(articam_add_table kind name)
  cmake_parse_arguments(arg "" "SYMBOL" "INPUTS;OPTIONS;BYPRODUCTS" ${ARGN})
  set(usage "articam_add_${kind}(${name}):")
  if(NOT name MATCHES "^[A-Z][A-Za-z0-9]*$")
    message(FATAL_ERROR "${usage} the name must be CamelCase letters and digits")
  endif()
  if(TARGET articam::${kind}s::${name})
    message(FATAL_ERROR "${usage} there is a ${kind} of that name already")
  endif()
  foreach(input IN LISTS arg_INPUTS)
    get_source_file_property(generated ${input} GENERATED)  # by xacro, for example, when the project is built
    if(NOT EXISTS ${input} AND NOT generated)
      message(FATAL_ERROR "${usage} there is no ${input}")
    endif()
  endforeach()
  articam_find_generator(${usage})

  articam_snake_case(${name} snake)
  set(root ${CMAKE_CURRENT_BINARY_DIR}/articam_${kind}s/${name})  # of its own: a target sees only what it links
  set(header ${root}/${kind}s/${snake}.hpp)
  file(MAKE_DIRECTORY ${root}/${kind}s)
  add_custom_command(
    OUTPUT ${header}
    BYPRODUCTS ${arg_BYPRODUCTS}
    COMMAND articam::generator ${arg_OPTIONS} --name ${name} -o ${header}
    DEPENDS ${arg_INPUTS} articam::generator
    COMMENT "Compiling the ${kind} ${name}"
    VERBATIM)
  add_custom_target(articam_${kind}_${name} DEPENDS ${header})

  set(library articam_${kind}s_${name})
  add_library(${library} INTERFACE)
  add_library(articam::${kind}s::${name} ALIAS ${library})
  add_dependencies(${library} articam_${kind}_${name})
  set_target_properties(${library} PROPERTIES ARTICAM_HEADER ${kind}s/${snake}.hpp ARTICAM_NAME ${arg_SYMBOL})
  target_include_directories(${library} INTERFACE ${root})
  target_link_libraries(${library} INTERFACE articam::core)
endfunction()

# articam_use_table(usage KIND Name): sets KIND, KIND_header and KIND_symbol for the template of a program.
function(articam_use_table usage kind name)
  set(target articam::${kind}s::${name})
  if(NOT TARGET ${target})
    message(FATAL_ERROR "${usage} no ${kind} '${name}'; articam_add_${kind} makes one")
  endif()
  get_target_property(header ${target} ARTICAM_HEADER)
  get_target_property(symbol ${target} ARTICAM_NAME)
  set(${kind} ${name} PARENT_SCOPE)
  set(${kind}_header ${header} PARENT_SCOPE)
  set(${kind}_symbol ${symbol} PARENT_SCOPE)
endfunction()

# articam_need_component(usage component): the library articam::component is there, or the reason why not is said.
function(articam_need_component usage component)
  if(NOT TARGET articam::${component})
    set(reason "${articam_${component}_NOT_FOUND_MESSAGE}")
    if(NOT reason)
      set(reason "find_package(articam COMPONENTS ${component}) gives it")
    endif()
    message(FATAL_ERROR "${usage} there is no articam::${component}. ${reason}")
  endif()
endfunction()
