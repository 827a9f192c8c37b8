#!/bin/bash
# SPDX-FileCopyrightText: Hachure contributors
# SPDX-License-Identifier: BSD-3-Clause

# selftest.sh: every check refuses a tree that breaks its rule, and accepts one that does not.
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0

fresh_tree()
{
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/Filters/Core/Kernels "$tree"/Rendering
  cp "$here"/../../.clang-format "$here"/../../.codespellrc "$tree"
  licence='// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause'
  printf '%s\nint number();\n' "$licence" >"$tree/Filters/Core/Number.h"
  printf 'float one()\n{\n  return 1.0;\n}\n' >"$tree/Filters/Core/Kernels/One.glsl"
  printf '%s\n' "$licence" | tee "$tree/vtkObject.h" >"$tree/Rendering/HachureRenderingModule.h"
  printf '%s\nconst char* tag = "//VTK::TCoord::Impl";\n' "$licence" >"$tree/Rendering/Tag.cxx"
}

# expect CODE CHECK WHAT: the check ends with that code on the tree as it is.
expect()
{
  local wanted=$1 check=$2 what=$3 code=0
  HACHURE_NEWER_VTK_INCLUDE=$tree "$here/$check" "$tree" "$tree" >"$tree/output" 2>&1 || code=1
  if [ $code -ne "$wanted" ]; then
    echo "$check: expected $wanted but got $code for: $what"
    cat "$tree/output"
    failed=1
  fi
  fresh_tree
}

fresh_tree
for check in format.sh spelling.sh walls.sh shaders.py newer_vtk.sh; do
  expect 0 $check "a clean tree"
done
echo 'int   number() { return 1 ; }' >>"$tree/Filters/Core/Number.h"
expect 1 format.sh "another layout"
echo '// The length' | sed 's/th$/ht/' >>"$tree/Filters/Core/Number.h"
expect 1 spelling.sh "a misspelling"
echo '#include <vtkPolyData.h>' >>"$tree/Filters/Core/Number.h"
expect 1 walls.sh "VTK in the core"
echo '#pragma omp parallel for' >>"$tree/Rendering/Tag.cxx"
expect 1 walls.sh "OpenMP elsewhere"
echo 'const char* text = "uniform float tone;";' >>"$tree/Rendering/Tag.cxx"
expect 1 walls.sh "a uniform in a string"
echo 'const char* text = "  gl_FragDepth = 0.0;";' >>"$tree/Rendering/Tag.cxx"
expect 1 walls.sh "a statement in a string"
echo 'uniform float tone;' >>"$tree/Filters/Core/Kernels/One.glsl"
expect 1 walls.sh "a uniform in a kernel"
echo 'int bare();' >"$tree/Filters/Core/Bare.h"
expect 1 walls.sh "no licence"
echo 'float two() { return undefined; }' >>"$tree/Filters/Core/Kernels/One.glsl"
expect 1 shaders.py "an undefined name in a kernel"
printf '//VTK::System::Dec\n//VTK::Output::Dec\nvoid main()\n{\n  gl_FragData[0] = vec3(1.0);\n}\n' >"$tree/Rendering/WrongFS.glsl"
expect 1 shaders.py "a wrong type in a fragment shader"
echo '#include "vtkCompositePolyDataMapper2.h"' >>"$tree/Rendering/Tag.cxx"
expect 1 newer_vtk.sh "a header that the other VTK has not"
rm "$tree/vtkObject.h"
expect 1 newer_vtk.sh "a folder without VTK's headers"
exit $failed
