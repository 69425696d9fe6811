# Debian packages: `cmake --build build --target debian_packages` builds what is in them, and them.
#   quadrille          the program, where it is built
#   libquadrille-dev   the library
#   python3-quadrille  the Python module, where it is built
set(CPACK_PACKAGE_NAME quadrille)
set(CPACK_PACKAGE_VENDOR Quadrille)
set(CPACK_PACKAGE_CONTACT "The developers of Quadrille <quadrille@localhost>")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_SOURCE_DIR}/cmake/package_tools.cmake")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENTS_ALL development)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libquadrille-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libboost-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libnanoflann-dev, libtbb-dev, libzstd-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "simplification of triangle surfaces for C++20\n Header-only, in the manner of CGAL.")

if(TARGET quadrille_program)
  list(APPEND CPACK_COMPONENTS_ALL program)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME quadrille)
  set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "simplifies triangle surfaces by quadric error metrics\n Reads and writes OFF, OBJ, PLY, STL, GOCAD and glTF; writes pages of HTML.")
endif()

if(TARGET quadrille_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-quadrille)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  get_target_property(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS quadrille_python DEBIAN_DEPENDS)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "simplification of triangle surfaces for Python\n Arrays of numpy in and out.")
endif()

include(CPack)

add_custom_target(debian_packages
  COMMAND "${CMAKE_CPACK_COMMAND}" -G DEB WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" VERBATIM)
foreach(target IN ITEMS quadrille_program quadrille_man_page quadrille_python)
  if(TARGET ${target})
    add_dependencies(debian_packages ${target})
  endif()
endforeach()
