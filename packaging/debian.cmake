# SPDX-License-Identifier: MIT
# Debian packages: cpack --config build/CPackConfig.cmake, or scripts/package. By who needs them: `clearpipe` runs programs,
# `clearpipe-dev` builds them, `clearpipe-tools` are the commands, and `clearpipe-validate` compares with Mesa. Takes `packages`.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME clearpipe)
set(CPACK_PACKAGE_VENDOR clearpipe)
set(CPACK_PACKAGE_CONTACT "clearpipe's maintainers <maintainers@clearpipe.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL ${packages})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME clearpipe)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "OpenGL ES 1.1 and EGL 1.5 in software
An EGL vendor library for libglvnd, and libraries for direct linking.
Mesa remains the first choice of programs; clearpipe-run chooses this.")
# The loader through which programs find it; then what is opened when a program asks for windows.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libegl1, libgles1")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS
  "libxcb1, libxcb-shm0, libxcb-present0, libx11-xcb1, libwayland-client0")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_DEV_PACKAGE_NAME clearpipe-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEV_DEPENDS library)
set(CPACK_COMPONENT_DEV_DESCRIPTION "OpenGL ES 1.1 and EGL 1.5 in software, to build with
libclearpipe.a, a CMake package and pkg-config files. The headers are
Khronos's, of libegl-dev and libgles-dev.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libegl-dev, libgles-dev, libhwy-dev")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME clearpipe-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION utils)
set(CPACK_COMPONENT_TOOLS_DEPENDS library)
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "OpenGL ES 1.1 and EGL 1.5 in software, the commands
clearpipe-run runs a program on clearpipe, clearpipe-gears draws gears.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_VALIDATE_PACKAGE_NAME clearpipe-validate)
set(CPACK_DEBIAN_VALIDATE_PACKAGE_SECTION utils)
set(CPACK_COMPONENT_VALIDATE_DEPENDS library)
set(CPACK_COMPONENT_VALIDATE_DESCRIPTION "OpenGL ES 1.1 and EGL 1.5 in software, compared with Mesa
clearpipe-validate runs a program on clearpipe and on Mesa, compares the
frames, and writes a page that shows them.")
set(CPACK_DEBIAN_VALIDATE_PACKAGE_DEPENDS "libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_VALIDATE_PACKAGE_SHLIBDEPS ON)

include(CPack)
