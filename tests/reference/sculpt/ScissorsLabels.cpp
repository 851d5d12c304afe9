// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "tests/reference/sculpt/ElementPlane.h"
#include "tests/reference/sculpt/LayerWrites.h"

#include <array>
#include <cstdlib>
#include <map>
#include <optional>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

/// One run of core::LabelScissors over all voxels.
class ScissorsRun {
public:
    ScissorsRun(const DenseArray<std::uint16_t>& codes, const DenseArray<std::uint8_t>& labels,
        const core::LabelScissors& edit)
        : m_codes(codes)
        , m_labels(labels)
        , m_edit(edit)
    {
    }

    /// Rules 2 to 4.
    [[nodiscard]] bool chooses(const glm::ivec3& voxel)
    {
        if (!hasCode(voxel) || hidesVoxel(m_edit.frame.hidden, voxel))
            return false;
        const std::array<std::int64_t, 3> place = placeOf(voxel);
        const ElementPlane::Place element{
            floorDivide(place[0], m_edit.frame.pitch), floorDivide(place[1], m_edit.frame.pitch)};
        const bool isUnder = m_edit.mask.at({int(element.first), int(element.second)}) >= 128;
        if (!m_edit.fromSurface)
            return isUnder != m_edit.outside;
        if (!isUnder)
            return false;
        const std::optional<std::int64_t> surface = surfaceOf(element);
        return surface && place[2] - *surface <= m_edit.frame.maxDepth;
    }

private:
    [[nodiscard]] static std::int64_t rounded(std::int64_t value)
    {
        return (value + (1 << 13)) >> 14;
    }
    [[nodiscard]] bool hasCode(const glm::ivec3& voxel) const
    {
        const int code = m_codes.at(voxel);
        return code >= m_edit.lowCode && code <= m_edit.highCode;
    }
    /// The first voxel of the brick is rounded, and so is each step from there.
    [[nodiscard]] std::array<std::int64_t, 3> placeOf(const glm::ivec3& voxel) const
    {
        const core::CutFrame& frame = m_edit.frame;
        const glm::ivec3 brick = voxel / 16 * 16;
        const glm::ivec3 within = voxel - brick;
        std::array<std::int64_t, 3> place;
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] = rounded(frame.planeOrigin[axis] + brick.x * frame.planePerI[axis]
                              + brick.y * frame.planePerJ[axis] + brick.z * frame.planePerK[axis])
                + within.x * rounded(frame.planePerI[axis])
                + within.y * rounded(frame.planePerJ[axis])
                + within.z * rounded(frame.planePerK[axis]);
        return place;
    }
    [[nodiscard]] std::optional<std::int64_t> surfaceOf(const ElementPlane::Place& element)
    {
        const auto [known, isNew] = m_surfaces.try_emplace(element);
        if (isNew)
            known->second = cast(element);
        return known->second;
    }
    [[nodiscard]] std::optional<std::int64_t> cast(const ElementPlane::Place& element) const
    {
        const core::CutFrame& frame = m_edit.frame;
        Index16 start;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            start[axis] = rounded(frame.rayOrigin[axis] + element.first * frame.rayPerA[axis]
                + element.second * frame.rayPerB[axis]);
            if (std::abs(start[axis]) > std::int64_t(1) << 30)
                return std::nullopt;
        }
        bool wasSeen = false;
        for (int n = 0; n < frame.sampleCount; ++n) {
            Index16 position;
            for (std::size_t axis = 0; axis < 3; ++axis)
                position[axis] = start[axis] + n * rounded(frame.rayPerSample[axis]);
            const bool isSeen = !hidesPosition(frame.hidden, position);
            if (wasSeen && !isSeen)
                break; // what is hidden behind stays so
            wasSeen = isSeen;
            if (isSeen && meets(position))
                return frame.zStart + std::int64_t(n) * frame.zPerSample;
        }
        return std::nullopt;
    }
    [[nodiscard]] bool meets(const Index16& position) const
    {
        glm::ivec3 voxel;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t nearest = (position[std::size_t(axis)] + 32768) >> 16;
            if (nearest < 0 || nearest >= m_codes.size[axis])
                return false;
            voxel[axis] = int(nearest);
        }
        return hasCode(voxel) && (!m_edit.erases() || m_edit.erased[m_labels.at(voxel)]);
    }

    const DenseArray<std::uint16_t>& m_codes;
    const DenseArray<std::uint8_t>& m_labels; ///< as they were when the edit began
    const core::LabelScissors& m_edit;
    std::map<ElementPlane::Place, std::optional<std::int64_t>> m_surfaces;
};

} // namespace

void labelScissors(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::LabelScissors& edit)
{
    const DenseArray<std::uint8_t> before = fields.labels(edit.target.plane);
    ScissorsRun run(codes, before, edit);
    DenseArray<std::uint8_t>& labels = fields.labels(edit.target.plane);
    DenseArray<std::uint32_t>& words = fields.seedWords(edit.target.plane);
    for (int z = 0; z < codes.size.z; ++z) {
        for (int y = 0; y < codes.size.y; ++y) {
            for (int x = 0; x < codes.size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                if (!run.chooses(voxel) || !isEditable(edit.editable, codes, fields, voxel))
                    continue;
                std::uint8_t& held = labels.at(voxel);
                std::uint32_t& word = words.at(voxel);
                const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
                if (edit.erases()) {
                    if (edit.erased[held])
                        held = 0;
                    if (bears && edit.erased[seedWord::label(word)])
                        word = seedWord::unvisited;
                } else if (held == 0 || held == edit.target.label
                    || edit.target.overwritable[held]) {
                    held = edit.target.label;
                    if (bears && seedWord::label(word) != edit.target.label)
                        word = seedWord::unvisited;
                }
            }
        }
    }
}

} // namespace reference
