// SPDX-License-Identifier: Apache-2.0
#include "core/export/CheckExport.h"

#include "core/export/CheckSources.h"
#include "core/export/NiftiImage.h"
#include "core/export/SourceCorners.h"

#include <QFile>

#include <algorithm>
#include <memory>

namespace core {

namespace {

NiftiPointer open(const QString& file, bool withVoxels)
{
    nifti_set_debug_level(0);
    return NiftiPointer(nifti_image_read(QFile::encodeName(file).constData(), withVoxels ? 1 : 0));
}

} // namespace

Result<QStringList> checkNiftiExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const Volume& volume = expected.volume;
    const glm::ivec3 size = volume.geometry.size;
    const auto mismatch = [&](const QString& what) {
        return failure(ErrorCode::ExportMismatch, file, what);
    };
    const NiftiPointer image = open(file, true);
    if (image == nullptr || image->data == nullptr)
        return failure(ErrorCode::FileUnreadable, file);
    if (image->nx != size.x || image->ny != size.y || image->nz != size.z
        || image->nvox != volume.geometry.voxelCount() || image->datatype != DT_UINT8)
        return mismatch(QStringLiteral("size or type of the voxels"));

    const auto corners = sourceCorners(file, volume, progress);
    if (!corners)
        return tl::unexpected(corners.error());
    const glm::dvec3 spacing = volume.geometry.spacingMm();
    const double least = std::min({spacing.x, spacing.y, spacing.z});
    // Far from the origin a 32-bit float has a step of its own; never near half a voxel, though.
    // Uneven slices stray from NIfTI's single step; by how much, the export's report says.
    const glm::dvec3 lastByStep = volume.geometry.toWorld({0.0, 0.0, size.z - 1.0});
    const double uneven =
        std::max(glm::distance(sliceOrigin(volume.geometry, 0), volume.geometry.originLps()),
            glm::distance(sliceOrigin(volume.geometry, size.z - 1), lastByStep));
    const double tolerance = positionToleranceMm(volume.geometry) + 0.1 * least + uneven;
    const auto volumeCorners = cornersOf(volume.geometry.indexToWorld, size);
    const double ofVolume = farthest(*corners, volumeCorners);
    if (ofVolume > tolerance)
        return mismatch(
            QStringLiteral("the source's own header puts a corner %1 mm away from where the volume "
                           "has it")
                .arg(ofVolume));
    if (image->sform_code <= 0)
        return mismatch(QStringLiteral("the sform is missing"));
    const double bySform =
        farthest(cornersOf(lpsFrom(image->sto_xyz, image->xyz_units), size), *corners);
    if (bySform > tolerance)
        return mismatch(QStringLiteral("the sform puts a corner %1 mm away from where the source "
                                       "has it")
                            .arg(bySform));
    double byQform = 0.0;
    if (image->qform_code > 0) {
        byQform = farthest(cornersOf(lpsFrom(image->qto_xyz, image->xyz_units), size), *corners);
        if (byQform > tolerance)
            return mismatch(QStringLiteral("the qform puts a corner %1 mm away from where the "
                                           "source has it")
                                .arg(byQform));
    }

    const auto* voxels = static_cast<const std::uint8_t*>(image->data);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < image->nvox; ++i) {
        std::uint8_t label = 0;
        for (const Segment& segment : expected.segments) {
            for (const LabelPlaneView& plane : expected.planes) {
                if (plane.plane == segment.plane && plane.labels[i] == segment.label)
                    label = segment.label;
            }
        }
        wrong += voxels[i] != label ? 1U : 0U;
    }
    if (wrong != 0)
        return mismatch(QStringLiteral("%1 voxels are not as drawn").arg(wrong));
    return QStringList{
        QStringLiteral("The eight corners land on the source's millimetres (at most %1 mm off, "
                       "source header read again).")
            .arg(std::max(bySform, byQform), 0, 'f', 4),
        QStringLiteral("All %1 voxels are as drawn.").arg(image->nvox)};
}

} // namespace core
