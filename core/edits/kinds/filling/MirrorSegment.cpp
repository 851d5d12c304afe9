// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/MirrorSegment.h"

#include "core/base/ParallelFor.h"
#include "core/brick/LabelBox.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/edits/open/OpenStroke.h"
#include "core/morphology/SidedBall.h"

#include <cmath>
#include <vector>

namespace core {

using namespace rowWords;

namespace {

/// A mirror plane: the index of a voxel along the axis and that of its mirror image add up to
/// `sum`.
struct MirrorPlane {
    int axis = 0;
    int sum = 0;

    [[nodiscard]] glm::ivec3 imageOf(glm::ivec3 voxel) const
    {
        voxel[axis] = sum - voxel[axis];
        return voxel;
    }
};

Result<MirrorPlane> mirrorPlane(const MirrorSegment& edit, const VolumeGeometry& geometry)
{
    const int axis = axesOfPatient(geometry).at(std::size_t(edit.sides));
    if (!edit.placeLps)
        return MirrorPlane{axis, geometry.size[axis] - 1};
    const double index = geometry.toIndex(*edit.placeLps)[axis];
    const double cell = 0.5; // what a voxel reaches from its centre
    if (!(index >= -cell && index <= double(geometry.size[axis]) - cell))
        return failure(ErrorCode::InvalidField, QStringLiteral("mirrorSegment.placeLps"),
            Clause::saying("lies outside the volume"));
    return MirrorPlane{axis, int(std::floor(2.0 * index + 0.5))};
}

/// Compares a segment with its mirror image.
struct Mirrored {
    struct Changes {
        VoxelRuns given; ///< free voxels of the image
        VoxelRuns taken; ///< the segment's that are not the image's
    };

    MirrorPlane plane;
    glm::ivec3 size{0};
    std::span<const std::uint8_t> labels; ///< of the volume, x fastest
    std::uint8_t label = 0;
    bool keep = false; ///< nothing is taken

    /// @param box what is compared @param z the slice of it
    [[nodiscard]] Changes changesIn(const VoxelBox& box, int z) const
    {
        Changes changes;
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            compareRow(box.minimum.x, box.maximum.x, y, z, changes);
        return changes;
    }

private:
    [[nodiscard]] std::size_t rowAt(int y, int z) const
    {
        return (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
    }
    void compareRow(int first, int end, int y, int z, Changes& changes) const
    {
        const std::size_t row = rowAt(y, z);
        const glm::ivec3 image = plane.imageOf({first, y, z});
        const bool hasImage = image.y >= 0 && image.y < size.y && image.z >= 0 && image.z < size.z;
        const std::size_t imageRow = hasImage ? rowAt(image.y, image.z) : 0;
        const int step = plane.axis == 0 ? -1 : 1;
        for (int x = first, there = image.x; x < end; ++x, there += step) {
            const std::size_t voxel = row + std::size_t(x);
            const bool isImage = hasImage && there >= 0 && there < size.x
                && labels[imageRow + std::size_t(there)] == label;
            if (isImage == (labels[voxel] == label))
                continue;
            if (!isImage && !keep)
                changes.taken.append(voxel, 1);
            else if (isImage && labels[voxel] == 0)
                changes.given.append(voxel, 1);
        }
    }
};

} // namespace

Result<void> check(const MirrorSegment& edit, const Document& document)
{
    if (const Result<MirrorPlane> plane = mirrorPlane(edit, document.volumes.front().geometry);
        !plane)
        return tl::unexpected(plane.error());
    return checkEditable(edit.segment, edit.editable, document, "mirrorSegment");
}

Result<bool> apply(const MirrorSegment&, Document&)
{
    return false;
}

EditEffects effects(const MirrorSegment& edit)
{
    return workedOutEffects(edit.segment, edit.placeLps.has_value() || namesPlaces(edit.editable),
        opens<MirrorSegment>());
}

/// A preview, for the user to decide.
OpenManner openManner(const MirrorSegment&)
{
    return {.withoutPen = true, .endsIfRefused = true};
}

RowTitle rowTitle(const MirrorSegment& edit, const RowFacts& row)
{
    return segmentChanged(RowTitleCode::MirrorSegment, edit.segment, row);
}

/// Every voxel of the plane may be the mirror image of one that decides.
EditDependencies dependencies(const MirrorSegment& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

Result<RelabelListed> relabelListed(const MirrorSegment& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    Result<LabelTarget> target = segmentTarget(edit.segment, false, document);
    if (!target)
        return tl::unexpected(target.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const Result<MirrorPlane> plane = mirrorPlane(edit, geometry);
    if (!plane)
        return tl::unexpected(plane.error());
    const glm::ivec3& size = geometry.size;
    const VoxelBox own = boxOfLabel(labels, size, target->label);
    ListedRuns listed(size);
    if (own.empty())
        return listed.relabel(*std::move(target));
    // The box of both: one corner's image is not that corner of the image's box.
    const glm::ivec3 one = plane->imageOf(own.minimum);
    const glm::ivec3 other = plane->imageOf(own.maximum - 1);
    const VoxelBox both = own.united(
        {glm::max(glm::min(one, other), glm::ivec3(0)), glm::min(glm::max(one, other) + 1, size)});
    const Mirrored mirrored{
        .plane = *plane, .size = size, .labels = labels, .label = target->label, .keep = edit.keep};
    std::vector<Mirrored::Changes> slices(std::size_t(both.maximum.z - both.minimum.z));
    parallelFor(int(slices.size()), [&](int slice) {
        if (!progress.cancelled())
            slices[std::size_t(slice)] = mirrored.changesIn(both, both.minimum.z + slice);
    });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    for (const Mirrored::Changes& slice : slices) {
        listed.add(slice.given, RelabelListed::give);
        listed.add(slice.taken, RelabelListed::take);
    }
    return keepingTo(edit.editable, document, "mirrorSegment", listed.relabel(*std::move(target)));
}

} // namespace core
