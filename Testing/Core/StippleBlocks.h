// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleBlocks_h
#define hachure_StippleBlocks_h

#include "StippleDrawing.h"
#include "StippleScene.h"

#include <limits>

namespace hachure
{

// All stipples of a hierarchy as one block.
struct HierarchyBlock
{
  HierarchyBlock(const TriangleMesh& mesh, const StippleHierarchy& hierarchy)
  {
    const std::size_t count = hierarchy.points.size();
    const std::size_t padded = (count + 7) / 8 * 8;
    for (std::vector<float>& array : this->arrays)
    {
      array.resize(padded, 0.0f);
    }
    this->density.resize(padded, std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < count; ++i)
    {
      const glm::vec3 place(stipplePosition(mesh, hierarchy.points[i]));
      const glm::vec3 normal(
        glm::normalize(triangleAreaVector(mesh, hierarchy.points[i].triangle)));
      for (int axis = 0; axis < 3; ++axis)
      {
        this->arrays[axis][i] = place[axis];
        this->arrays[3 + axis][i] = normal[axis];
      }
      this->density[i] = static_cast<float>(static_cast<double>(i + 1) / hierarchy.area);
    }
    this->held = static_cast<float>(static_cast<double>(count) / hierarchy.area);
  }

  StippleBlock block() const
  {
    StippleBlock block;
    block.x = this->arrays[0].data();
    block.y = this->arrays[1].data();
    block.z = this->arrays[2].data();
    block.normalX = this->arrays[3].data();
    block.normalY = this->arrays[4].data();
    block.normalZ = this->arrays[5].data();
    block.density = this->density.data();
    block.count = static_cast<std::int32_t>(this->density.size());
    block.held = this->held;
    return block;
  }

  std::vector<float> arrays[6], density;
  float held = 0.0f;
};

} // namespace hachure

#endif
