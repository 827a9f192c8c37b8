# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# Libraries, Python package, programs and package files for plain VTK.

# Components are named: without them VTK asks for the development files of everything it was built with.
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore
  CommonColor
  CommonDataModel
  CommonExecutionModel
  CommonMath
  CommonTransforms
  FiltersCore
  FiltersExtraction
  FiltersGeneral
  FiltersGeometry
  FiltersModeling
  FiltersSources
  FiltersTexture
  ImagingColor
  ImagingCore
  ImagingFourier
  ImagingMath
  ImagingSources
  InteractionStyle
  InteractionWidgets
  IOExodus
  IOExport
  IOGeometry
  IOImage
  IOLegacy
  IONetCDF
  IOOggTheora
  IOPLY
  IOXML
  ParallelCore
  Python
  RenderingCore
  RenderingFreeType
  RenderingOpenGL2
  TestingCore
  TestingRendering
  WrappingPythonCore
  jsoncpp
  opengl
  OPTIONAL_COMPONENTS
  glew
  glad)

set(hachure_library_suffix "${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")
set(hachure_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/Hachure")
set(hachure_headers_destination "${CMAKE_INSTALL_INCLUDEDIR}/hachure")

add_subdirectory(Filters/Core)

vtk_module_scan(
  MODULE_FILES ${hachure_module_files}
  PROVIDES_MODULES hachure_modules
  REQUIRES_MODULES hachure_required_modules
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)

vtk_module_build(
  MODULES ${hachure_modules}
  PACKAGE Hachure
  INSTALL_EXPORT Hachure
  ENABLE_WRAPPING ON
  INSTALL_HEADERS ON
  LIBRARY_NAME_SUFFIX "${hachure_library_suffix}"
  VERSION "${PROJECT_VERSION}"
  SOVERSION 1
  HEADERS_DESTINATION "${hachure_headers_destination}"
  CMAKE_DESTINATION "${hachure_cmake_destination}"
  HIERARCHY_DESTINATION "${CMAKE_INSTALL_LIBDIR}/hachure/hierarchy")

# ---- Python package ----------------------------------------------------------------------------
# Debian's interpreter reads dist-packages, everyone else's site-packages.
if (EXISTS "/etc/debian_version")
  set(hachure_python_folder "dist-packages")
else ()
  set(hachure_python_folder "site-packages")
endif ()
set(HACHURE_PYTHON_DESTINATION
  "${CMAKE_INSTALL_LIBDIR}/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/${hachure_python_folder}"
  CACHE STRING "Folder of the Python package, relative to the installation prefix")

vtk_module_wrap_python(
  MODULES ${hachure_modules}
  TARGET Hachure::Python
  WRAPPED_MODULES hachure_wrapped_modules
  PYTHON_PACKAGE hachure
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF
  MODULE_DESTINATION "${HACHURE_PYTHON_DESTINATION}"
  CMAKE_DESTINATION "${hachure_cmake_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}")

set(hachure_python_imports "")
foreach (module IN LISTS hachure_wrapped_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "library_name" VARIABLE library_name)
  string(APPEND hachure_python_imports "from .${library_name} import *\n")
endforeach ()
configure_file(Filters/__init__.py.in
  "${CMAKE_BINARY_DIR}/${HACHURE_PYTHON_DESTINATION}/hachure/__init__.py" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/${HACHURE_PYTHON_DESTINATION}/hachure/__init__.py"
  DESTINATION "${HACHURE_PYTHON_DESTINATION}/hachure" COMPONENT python)

# ---- Package files -----------------------------------------------------------------------------
include(CMakePackageConfigHelpers)
string(REPLACE "VTK::" "" hachure_required_components "${hachure_required_modules}")
list(JOIN hachure_required_components " " hachure_required_components)
configure_package_config_file(Filters/HachureConfig.cmake.in
  "${CMAKE_BINARY_DIR}/${hachure_cmake_destination}/HachureConfig.cmake"
  INSTALL_DESTINATION "${hachure_cmake_destination}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${hachure_cmake_destination}/HachureConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${hachure_cmake_destination}/HachureConfig.cmake"
  "${CMAKE_BINARY_DIR}/${hachure_cmake_destination}/HachureConfigVersion.cmake"
  DESTINATION "${hachure_cmake_destination}" COMPONENT development)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/hachure")

if (HACHURE_BUILD_EXAMPLES)
  add_subdirectory(Examples)
endif ()
