// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/MemoryFormula.h"

#include "gpu/fields/textures/VolumeTextures.h"

namespace gpu {

std::vector<MemoryFormula::Part> MemoryFormula::denseParts(const glm::ivec3& size)
{
    std::vector<Part> parts;
    for (const VolumeTextures::Part& part : VolumeTextures::denseParts(size))
        parts.push_back({.name = QString::fromLatin1(part.label), .bytes = part.bytes});
    return parts;
}

std::size_t MemoryFormula::denseBytes(const glm::ivec3& size)
{
    return VolumeTextures::denseBytes(size);
}

QString MemoryFormula::text()
{
    return QStringLiteral("voxels × (2 intensity + 1 labels + 1 radiation + 1 segmentation map) "
                          "+ cells of 8³ × 6 bytes + cells of 4³ × 8 bytes, dense; bricks of 16³ "
                          "that are not empty, and "
                          "at least min(4096, all) × (4 KiB per sculpt layer, 16 KiB seed words; "
                          "before-images while a stroke is open)");
}

} // namespace gpu
