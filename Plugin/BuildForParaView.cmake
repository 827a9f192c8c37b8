# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# The plugin for ParaView, from the same modules.

# ---- Debian's split Python package -------------------------------------------------------------
# ParaView's CMake files name targets and class lists of a package that cannot be installed beside VTK.
set(HACHURE_PARAVIEW_PYTHON "${CMAKE_BINARY_DIR}/paraview-python" CACHE PATH
  "Folder with the unpacked package python3-paraview (unpacked there when it is missing)")
find_path(hachure_paraview_cmake NAMES paraview-config.cmake REQUIRED
  PATHS "${ParaView_DIR}"
  PATH_SUFFIXES "lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-5.11" "lib/cmake/paraview-5.11"
  DOC "Folder of paraview-config.cmake")
set(ParaView_DIR "${hachure_paraview_cmake}" CACHE PATH "Folder of paraview-config.cmake")

# An export file returns early when all of its targets exist, so stand-ins keep it from asking for files.
function (hachure_stand_in_for file)
  file(STRINGS "${file}" names REGEX "IN ITEMS")
  string(REGEX REPLACE ".*IN ITEMS ([^)]*)\\).*" "\\1" names "${names}")
  separate_arguments(names)
  foreach (name IN LISTS names)
    if (NOT TARGET "${name}")
      add_library("${name}" INTERFACE IMPORTED GLOBAL)
    endif ()
  endforeach ()
endfunction ()

# Points targets whose class lists are not installed at the unpacked ones.
function (hachure_use_unpacked_hierarchies)
  get_property(targets DIRECTORY PROPERTY IMPORTED_TARGETS)
  foreach (target IN LISTS targets)
    get_property(file TARGET "${target}" PROPERTY INTERFACE_vtk_module_hierarchy)
    if (file AND NOT EXISTS "${file}")
      string(REGEX REPLACE "^/usr/" "${HACHURE_PARAVIEW_PYTHON}/usr/" unpacked "${file}")
      if (EXISTS "${unpacked}")
        set_property(TARGET "${target}" PROPERTY INTERFACE_vtk_module_hierarchy "${unpacked}")
      endif ()
    endif ()
  endforeach ()
endfunction ()

if (EXISTS "/etc/debian_version" AND NOT EXISTS "/usr/bin/pvpython")
  execute_process(
    COMMAND "${PROJECT_SOURCE_DIR}/Plugin/unpack_paraview_python.sh" "${HACHURE_PARAVIEW_PYTHON}"
    RESULT_VARIABLE failed)
  if (failed)
    message(FATAL_ERROR "The Python files of ParaView are missing, see the message above.")
  endif ()
  foreach (file IN ITEMS vtk/VTKPython-targets ParaViewPython-targets ParaViewTools-targets)
    hachure_stand_in_for("${ParaView_DIR}/${file}.cmake")
  endforeach ()
endif ()

find_package(ParaView 5.11 REQUIRED COMPONENTS
  RemotingCore
  RemotingServerManager
  RemotingViews
  VTKExtensionsFiltersRendering)
find_package(VTK REQUIRED PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH COMPONENTS
  CommonColor
  CommonCore
  CommonDataModel
  CommonExecutionModel
  CommonMath
  CommonTransforms
  FiltersCore
  FiltersGeneral
  FiltersExtraction
  FiltersGeometry
  FiltersSources
  ImagingCore
  InteractionWidgets
  IOExport
  IOImage
  ParallelCore
  RenderingCore
  RenderingOpenGL2
  jsoncpp
  opengl
  OPTIONAL_COMPONENTS
  glew
  glad)
hachure_use_unpacked_hierarchies()

set(hachure_library_suffix "pv${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
list(APPEND hachure_module_files "${PROJECT_SOURCE_DIR}/Plugin/Representations/vtk.module")

add_subdirectory(Filters/Core)

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS hachure_plugins
  REQUIRES_MODULES hachure_required_modules
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)

paraview_plugin_build(
  PLUGINS ${hachure_plugins}
  PLUGINS_FILE_NAME "hachure.plugins.xml"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  DISABLE_XML_DOCUMENTATION ON)

# Where tests find the plugin of this build.
set(hachure_plugin_file
  "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${PARAVIEW_PLUGIN_SUBDIR}/Hachure/Hachure.so")
