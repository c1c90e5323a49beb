# SPDX-License-Identifier: MIT
# Writes 60_clearpipe.json at the time of installation, when the prefix is known. libglvnd tries manifests in the order of their
# names: Mesa's 50_mesa.json stays the first, since a display of ours offers OpenGL ES 1 alone. Takes `libraries`, `manifests` and
# `template` from packaging/CMakeLists.txt.
set(CLEARPIPE_VENDOR_LIBRARY libEGL_clearpipe.so.0)
# Under /usr the loader finds the library by its name, in a copy of such a tree too; elsewhere it does not look.
if(NOT CMAKE_INSTALL_PREFIX MATCHES "/usr$")
  set(CLEARPIPE_VENDOR_LIBRARY ${CMAKE_INSTALL_PREFIX}/${libraries}/${CLEARPIPE_VENDOR_LIBRARY})
endif()
set(manifest ${CMAKE_INSTALL_PREFIX}/${manifests}/60_clearpipe.json)
message(STATUS "Installing: $ENV{DESTDIR}${manifest}")
configure_file(${template} $ENV{DESTDIR}${manifest} @ONLY)
list(APPEND CMAKE_INSTALL_MANIFEST_FILES ${manifest})
