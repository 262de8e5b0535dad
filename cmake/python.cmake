# The Python module: python/fastscene with _core, an extension of the library's objects. On where pybind11 is.
option(FASTSCENE_PYTHON "Build the Python module" ON)
# Where the component `python` is installed: pip names its own folder.
set(FASTSCENE_PYTHON_DIR lib/python3/dist-packages/fastscene CACHE STRING "Folder of the Python package when installed")
# Python cannot load what is built with a sanitizer.
if(FASTSCENE_PYTHON AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  # Debian's own Python, whose numpy and headers packages bring, before others on PATH.
  if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
  endif()
  set(PYBIND11_FINDPYTHON ON)
  find_package(Python COMPONENTS Interpreter Development.Module QUIET)
  find_package(pybind11 CONFIG QUIET)
  if(NOT (Python_FOUND AND pybind11_FOUND))
    message(STATUS "Python module: left out (apt-get install pybind11-dev python3-dev python3-numpy)")
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/bindings/*.cc)
  pybind11_add_module(fastscene_python MODULE NO_EXTRAS ${sources})
  target_link_libraries(fastscene_python PRIVATE fastscene_pipeline fastscene_export fastscene_film fastscene_warnings)
  # The build tree's package: PYTHONPATH=build/release/python.
  set(package ${PROJECT_BINARY_DIR}/python/fastscene)
  set_target_properties(fastscene_python PROPERTIES OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${package})
  fastscene_loads_on_demand(fastscene_python)
  # Nothing in it is hot, and a third of its compile time is saved.
  target_compile_options(fastscene_python PRIVATE -O1)
  file(MAKE_DIRECTORY ${package})
  foreach(file __init__.py _core.pyi py.typed)
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/python/fastscene/${file} ${package}/${file} SYMBOLIC)
    install(FILES ${PROJECT_SOURCE_DIR}/python/fastscene/${file} DESTINATION ${FASTSCENE_PYTHON_DIR}
      COMPONENT python EXCLUDE_FROM_ALL)
  endforeach()
  install(TARGETS fastscene_python LIBRARY DESTINATION ${FASTSCENE_PYTHON_DIR} COMPONENT python EXCLUDE_FROM_ALL)
  get_property(parts GLOBAL PROPERTY FASTSCENE_PARTS)
  foreach(part ${parts})
    file(CREATE_LINK ${PROJECT_BINARY_DIR}/${FASTSCENE_PARTS_DIR}/${part} ${package}/${part} SYMBOLIC)
    install(FILES ${PROJECT_BINARY_DIR}/${FASTSCENE_PARTS_DIR}/${part} DESTINATION ${FASTSCENE_PYTHON_DIR}
      COMPONENT python EXCLUDE_FROM_ALL)
  endforeach()
endif()
