# fastscene_on_demand(module): programs with the property FASTSCENE_ON_DEMAND load the module at its first call.
#
# libtorch and what Debian's is linked with take a second to load, and most commands need none of it. Such a program
# links fastscene_<module>_on_demand in place of the module: a function of the same name for each of the module's public
# ones (those of namespace fastscene itself), which loads fastscene-<module>.so and goes on there (base/on_demand.h), as
# MSVC's /DELAYLOAD does. The module is compiled once, and neither its callers nor its own sources know. It takes what it needs
# of the modules below from the program, so that there is one of each: the program links and exports them whole.
#
# The program and Python's module do. The unit tests and the libraries link the module itself, and so does everything on
# other processors than x86-64.
include(GNUInstallDirs)
set(FASTSCENE_PARTS_DIR ${CMAKE_INSTALL_LIBDIR}/fastscene)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  enable_language(ASM)
  set(FASTSCENE_CAN_LOAD_ON_DEMAND ON)
endif()
define_property(TARGET PROPERTY FASTSCENE_ON_DEMAND BRIEF_DOCS "Loads some modules at their first call")

# What a target links to use a module.
function(fastscene_link_of_module module out)
  set(link fastscene_${module})
  get_property(modules GLOBAL PROPERTY FASTSCENE_MODULES_ON_DEMAND)
  if(module IN_LIST modules)
    set(link $<IF:$<BOOL:$<TARGET_PROPERTY:FASTSCENE_ON_DEMAND>>,fastscene_${module}_on_demand,fastscene_${module}>)
  endif()
  set(${out} ${link} PARENT_SCOPE)
endfunction()

function(fastscene_on_demand module)
  if(NOT FASTSCENE_CAN_LOAD_ON_DEMAND)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY FASTSCENE_MODULES_ON_DEMAND ${module})
  get_target_property(uses fastscene_${module} FASTSCENE_USES)
  get_target_property(linked fastscene_${module} INTERFACE_LINK_LIBRARIES)
  list(FILTER linked EXCLUDE REGEX "fastscene_")
  get_target_property(others fastscene_${module} FASTSCENE_OBJECTS)

  add_library(fastscene_${module}_part MODULE $<TARGET_OBJECTS:fastscene_${module}>)
  if(others)
    target_sources(fastscene_${module}_part PRIVATE ${others})
  endif()
  target_link_libraries(fastscene_${module}_part PRIVATE ${linked})
  set_target_properties(fastscene_${module}_part PROPERTIES LINKER_LANGUAGE CXX PREFIX "" OUTPUT_NAME fastscene-${module}
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${FASTSCENE_PARTS_DIR})
  install(TARGETS fastscene_${module}_part LIBRARY DESTINATION ${FASTSCENE_PARTS_DIR} COMPONENT program)

  set_property(GLOBAL APPEND PROPERTY FASTSCENE_PARTS fastscene-${module}.so)

  set(source ${PROJECT_BINARY_DIR}/${module}_on_demand.S)
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DARCHIVE=$<TARGET_FILE:fastscene_${module}> -DMODULE=${module} -DOUTPUT=${source}
      -P ${PROJECT_SOURCE_DIR}/cmake/on_demand_functions.cmake
    DEPENDS fastscene_${module} ${PROJECT_SOURCE_DIR}/cmake/on_demand_functions.cmake VERBATIM)
  add_library(fastscene_${module}_on_demand STATIC ${source})
  set_target_properties(fastscene_${module}_on_demand PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(fastscene_${module}_on_demand INTERFACE
    $<TARGET_PROPERTY:fastscene_${module},INTERFACE_INCLUDE_DIRECTORIES>)
  foreach(other ${uses})
    fastscene_link_of_module(${other} link)
    target_link_libraries(fastscene_${module}_on_demand INTERFACE ${link})
    get_target_property(type fastscene_${other} TYPE)
    if(type STREQUAL "STATIC_LIBRARY")
      set_property(GLOBAL APPEND PROPERTY FASTSCENE_BELOW_ON_DEMAND fastscene_${other})
    endif()
  endforeach()
  add_dependencies(fastscene_${module}_on_demand fastscene_${module}_part)
endfunction()

# fastscene_loads_on_demand(target): a program, or a module of Python's.
function(fastscene_loads_on_demand program)
  if(NOT FASTSCENE_CAN_LOAD_ON_DEMAND)
    return()
  endif()
  get_property(below GLOBAL PROPERTY FASTSCENE_BELOW_ON_DEMAND)
  list(REMOVE_DUPLICATES below)
  set_target_properties(${program} PROPERTIES FASTSCENE_ON_DEMAND ON ENABLE_EXPORTS ON
    LINK_LIBRARY_OVERRIDE "WHOLE_ARCHIVE,$<JOIN:${below},$<COMMA>>")
endfunction()
