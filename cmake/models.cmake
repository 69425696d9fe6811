# quadrille_models: tells a program where CGAL's demo models lie, as QUADRILLE_MODELS_DIR, and makes
# CGAL::data_file_path("meshes/cow.off") find them.
set(QUADRILLE_DATA_DIR "" CACHE PATH
  "Folder in which meshes/cow.off lies; if empty, it is unpacked from the Debian package libcgal-demo")
set(data_dir "${QUADRILLE_DATA_DIR}")

if(NOT data_dir)
  set(data_dir "${PROJECT_BINARY_DIR}/data")
  if(NOT EXISTS "${data_dir}/meshes")
    set(archive /usr/share/doc/libcgal-dev/data.tar.gz)
    if(NOT EXISTS "${archive}")
      message(FATAL_ERROR "No models: ${archive} is missing. Install the Debian package libcgal-demo "
        "together with its documentation files, or set QUADRILLE_DATA_DIR.")
    endif()
    message(STATUS "Unpacking models from ${archive}")
    file(ARCHIVE_EXTRACT INPUT "${archive}"
      DESTINATION "${PROJECT_BINARY_DIR}" PATTERNS "data/meshes/*")
  endif()
endif()

add_library(quadrille_models INTERFACE)
target_compile_definitions(quadrille_models INTERFACE
  CGAL_DATA_DIR="${data_dir}"
  QUADRILLE_MODELS_DIR="${data_dir}/meshes")
