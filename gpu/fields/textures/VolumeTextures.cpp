// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/VolumeTextures.h"

#include "core/base/LargePages.h"
#include "core/volume/MemoryLimit.h"
#include "gpu/gl/SoftwareDriver.h"

#include <algorithm>
#include <utility>

namespace gpu {

core::Result<void> VolumeTextures::checkSize(const glm::ivec3& size, std::size_t besides)
{
    GLint largest = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
    if (size.x > largest || size.y > largest || size.z > largest)
        return core::failure(core::ErrorCode::OutOfMemory,
            core::Clause::saying("the volume has %1 × %2 × %3 voxels, and the graphics processor "
                                 "takes at most %4 along a side",
                size.x, size.y, size.z, largest));
    // Such a driver is given memory that the system does not have; the system then ends the program
    // when it writes there.
    if (!isSoftwareDriver())
        return {};
    return core::checkBytes(double(besides) + double(denseBytes(size)),
        core::Clause::saying("the volume with its textures"));
}

void VolumeTextures::fill(const glm::ivec3& size, std::span<const std::uint16_t> codes,
    const std::function<void(std::span<const std::uint16_t> codes)>& there)
{
    MacroCells cells(size, codes);
    MaximumCells maximumCells(size, codes);
    Texture3D intensity({.label = "intensity", .size = size, .format = GL_R16, .linear = true});
    const std::size_t slice = std::size_t(size.x) * std::size_t(size.y);
    constexpr int atOnce = core::BrickGrid::side;
    for (int z = 0; z < size.z; z += atOnce) {
        const int count = std::min(atOnce, size.z - z);
        const auto part = codes.subspan(std::size_t(z) * slice, std::size_t(count) * slice);
        intensity.upload({0, 0, z}, {size.x, size.y, count}, std::as_bytes(part));
        there(part);
    }
    // The others come when codes may have made room for them.
    Texture3D labels({.label = "labels 0", .size = size, .format = GL_R8UI});
    Texture3D radiation({.label = "radiation", .size = size, .format = GL_R8, .linear = true});
    Texture3D segmentation(
        {.label = "segmentation map", .size = size, .format = GL_R8, .linear = true});
    m_intensityCodes = intensity.view(GL_R16UI, "intensity codes");
    labels.clear();
    radiation.clear();
    segmentation.clear();
    m_intensity = std::move(intensity);
    m_labels = std::move(labels);
    m_radiation = std::move(radiation);
    m_segmentation = std::move(segmentation);
    m_cells = std::move(cells);
    m_maximumCells = std::move(maximumCells);
    m_dirty = {};
    m_touched = {};
}

core::Result<void> VolumeTextures::open(
    const glm::ivec3& size, std::span<const std::uint16_t> codes)
{
    close(); // both at once may not fit
    if (const core::Result<void> fits = checkSize(size, codes.size_bytes()); !fits)
        return fits;
    fill(size, codes, [](std::span<const std::uint16_t>) {});
    return {};
}

core::Result<void> VolumeTextures::take(const glm::ivec3& size, std::vector<std::uint16_t> codes)
{
    close();
    if (const core::Result<void> fits = checkSize(size, 0); !fits)
        return fits;
    fill(size, codes, [&codes](std::span<const std::uint16_t> part) {
        core::giveBackPages(codes.data() + (part.data() - codes.data()), part.size_bytes());
    });
    return {};
}

void VolumeTextures::close()
{
    m_intensity = {};
    m_intensityCodes = {};
    m_labels = {};
    m_radiation = {};
    m_segmentation = {};
    m_cells = {};
    m_maximumCells = {};
    m_pieces = {};
    m_replaced = true;
    ++m_revision;
}

void VolumeTextures::setGeometry(
    const core::VolumeGeometry& geometry, const core::VoxelEncoding& encoding)
{
    m_geometry = geometry;
    m_encoding = encoding;
    m_replaced = true;
    ++m_revision;
}

std::vector<const Texture3D*> VolumeTextures::labelPlanes() const
{
    std::vector<const Texture3D*> planes{&m_labels};
    planes.insert(planes.end(), m_furtherPlanes.begin(), m_furtherPlanes.end());
    return planes;
}

void VolumeTextures::setFurtherPlanes(std::vector<const Texture3D*> planes, const Texture3D* shown)
{
    m_furtherPlanes = std::move(planes);
    m_shownLabels = shown;
}

void VolumeTextures::markDirty(VolumeField field, const core::VoxelBox& box)
{
    core::VoxelBox& dirty = m_dirty[std::size_t(field)];
    dirty = dirty.united(box);
    m_touched[std::size_t(field)] = true;
}

core::VoxelBox VolumeTextures::takeDirty(VolumeField field)
{
    core::VoxelBox dirty = std::exchange(m_dirty[std::size_t(field)], {});
    m_revision += dirty.empty() ? 0 : 1;
    return dirty;
}

bool VolumeTextures::takeReplaced()
{
    return std::exchange(m_replaced, false);
}

std::vector<VolumeTextures::Part> VolumeTextures::denseParts(const glm::ivec3& size)
{
    const std::size_t voxels = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    return {{"intensity", 2 * voxels}, {"labels", voxels}, {"radiation", voxels},
        {"segmentation map", voxels}, {"macro-cells", MacroCells::bytesFor(size)},
        {"maximum cells", MaximumCells::bytesFor(size)}};
}

std::size_t VolumeTextures::denseBytes(const glm::ivec3& size)
{
    std::size_t bytes = 0;
    for (const Part& part : denseParts(size))
        bytes += part.bytes;
    return bytes;
}

} // namespace gpu
