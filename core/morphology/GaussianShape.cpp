// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/GaussianShape.h"

#include "core/brick/LabelBox.h"
#include "core/morphology/GaussianFilter.h"
#include "core/morphology/GridGaussian.h"
#include "core/volume/MemoryLimit.h"

namespace core {

namespace {

/// The rows of a box in a volume, x fastest in both.
class BoxRows {
public:
    BoxRows(const VoxelBox& box, const glm::ivec3& size)
        : m_box(box)
        , m_size(size)
    {
    }

    [[nodiscard]] glm::ivec3 boxSize() const { return m_box.maximum - m_box.minimum; }
    [[nodiscard]] std::size_t voxels() const
    {
        const glm::ivec3 its = boxSize();
        return std::size_t(its.x) * std::size_t(its.y) * std::size_t(its.z);
    }
    [[nodiscard]] ImageEnds ends() const
    {
        return {.before = glm::equal(m_box.minimum, glm::ivec3(0)),
            .behind = glm::equal(m_box.maximum, m_size)};
    }
    /// Calls @p visit(index in the volume, index in the box, width).
    template <class Visit> void forEach(const Visit& visit) const
    {
        const auto width = std::size_t(boxSize().x);
        std::size_t in = 0;
        for (int z = m_box.minimum.z; z < m_box.maximum.z; ++z) {
            for (int y = m_box.minimum.y; y < m_box.maximum.y; ++y, in += width) {
                const std::size_t row = std::size_t(z) * std::size_t(m_size.y) + std::size_t(y);
                visit(row * std::size_t(m_size.x) + std::size_t(m_box.minimum.x), in, width);
            }
        }
    }

private:
    VoxelBox m_box;
    glm::ivec3 m_size;
};

BoxMask maskOf(std::span<const std::uint8_t> labels, const BoxRows& rows, std::uint8_t label)
{
    BoxMask mask{.size = rows.boxSize(), .voxels = std::vector<std::uint8_t>(rows.voxels())};
    rows.forEach([&](std::size_t of, std::size_t in, std::size_t width) {
        for (std::size_t x = 0; x < width; ++x)
            mask.voxels[in + x] = labels[of + x] == label ? 1 : 0;
    });
    return mask;
}

} // namespace

Result<ShapeChange> gaussianChange(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, const GridGaussian& gaussian, const Progress& progress)
{
    const VoxelBox own = boxOfLabel(labels, size, label);
    if (own.empty())
        return ShapeChange();
    const BoxRows rows(own, size);
    if (const Result<void> enough =
            checkBytes(gaussianBytes(rows.boxSize()), QStringLiteral("the segment"));
        !enough)
        return tl::unexpected(enough.error());
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    const Result<BoxValues> blurry =
        blurred(maskOf(labels, rows, label), gaussian, rows.ends(), {.progress = progress});
    if (!blurry)
        return tl::unexpected(blurry.error());
    ShapeChange change;
    rows.forEach([&](std::size_t of, std::size_t in, std::size_t width) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint16_t value = blurry->values[in + x];
            if (labels[of + x] == 0 && value > BoxValues::half)
                change.given.append(of + x, 1);
            else if (labels[of + x] == label && value < BoxValues::half)
                change.taken.append(of + x, 1);
        }
    });
    return change;
}

} // namespace core
