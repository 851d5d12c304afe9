// SPDX-License-Identifier: Apache-2.0
#include "core/export/CheckExport.h"

#include "core/export/CheckSources.h"

#include <QFile>

#include <nifti1_io.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace core {

namespace {

struct NiftiDeleter {
    void operator()(nifti_image* image) const { nifti_image_free(image); }
};
using NiftiPointer = std::unique_ptr<nifti_image, NiftiDeleter>;

NiftiPointer open(const QString& file, bool withVoxels)
{
    nifti_set_debug_level(0);
    return NiftiPointer(nifti_image_read(QFile::encodeName(file).constData(), withVoxels ? 1 : 0));
}

/// The header of a volume that was read from one file.
NiftiPointer openSource(const Volume& volume)
{
    if (!volume.keptHeaders)
        return open(volume.sourcePath, false);
    const auto kept = volume.keptHeaders->find(volume.sourcePath);
    nifti_1_header header{};
    if (kept == volume.keptHeaders->end() || kept->second.size() != qsizetype(sizeof header))
        return nullptr;
    std::memcpy(&header, kept->second.constData(), sizeof header);
    nifti_set_debug_level(0);
    return NiftiPointer(nifti_convert_nhdr2nim(header, nullptr));
}

/// RAS in the file's unit of length → LPS mm.
glm::dmat4 lpsFrom(const mat44& ras, int units)
{
    const double scale = units == NIFTI_UNITS_METER ? 1000.0
        : units == NIFTI_UNITS_MICRON               ? 0.001
                                                    : 1.0;
    glm::dmat4 lps(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            lps[column][row] = (row < 2 ? -scale : scale) * double(ras.m[row][column]);
    }
    return lps;
}

/// Where a grid's eight outermost voxels are.
std::array<glm::dvec3, 8> cornersOf(const glm::dmat4& affine, const glm::ivec3& size)
{
    std::array<glm::dvec3, 8> corners{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 index((corner & 1) != 0 ? size.x - 1 : 0,
            (corner & 2) != 0 ? size.y - 1 : 0, (corner & 4) != 0 ? size.z - 1 : 0);
        corners[std::size_t(corner)] = glm::dvec3(affine * glm::dvec4(index, 1.0));
    }
    return corners;
}

double farthest(const std::array<glm::dvec3, 8>& a, const std::array<glm::dvec3, 8>& b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, glm::distance(a[i], b[i]));
    return worst;
}

/// The corners as the source files themselves say them.
Result<std::array<glm::dvec3, 8>> sourceCorners(
    const QString& file, const Volume& volume, const Progress& progress)
{
    const glm::ivec3 size = volume.geometry.size;
    if (!volume.sources.empty()) {
        const auto headers = checkedSourceHeaders(file, volume, progress);
        if (!headers)
            return tl::unexpected(headers.error());
        std::array<glm::dvec3, 8> corners{};
        for (int corner = 0; corner < 8; ++corner) {
            const HeaderPlane& plane =
                (corner & 4) != 0 ? headers->back().plane : headers->front().plane;
            corners[std::size_t(corner)] =
                plane.at((corner & 1) != 0 ? size.x - 1 : 0, (corner & 2) != 0 ? size.y - 1 : 0);
        }
        return corners;
    }
    const NiftiPointer source = openSource(volume);
    if (source == nullptr)
        return failure(ErrorCode::FileUnreadable, volume.sourcePath);
    if (source->nx != size.x || source->ny != size.y || source->nz != size.z)
        return failure(ErrorCode::ExportMismatch, volume.sourcePath,
            QStringLiteral("its size is not that of the volume that was opened"));
    const mat44& affine = source->sform_code > 0 ? source->sto_xyz : source->qto_xyz;
    return cornersOf(lpsFrom(affine, source->xyz_units), size);
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
