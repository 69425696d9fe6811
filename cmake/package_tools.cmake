# Read by cpack: without this tool it would make packages that depend on nothing, and say so in a remark only.
if(CPACK_GENERATOR STREQUAL "DEB")
  find_program(QUADRILLE_SHLIBDEPS dpkg-shlibdeps)
  if(NOT QUADRILLE_SHLIBDEPS)
    message(FATAL_ERROR "Debian packages take dpkg-shlibdeps, of the package dpkg-dev, to tell what they depend on")
  endif()
endif()
