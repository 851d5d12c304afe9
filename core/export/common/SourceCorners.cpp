// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/SourceCorners.h"

#include "core/export/common/CheckSources.h"
#include "core/export/common/NiftiImage.h"
#include "core/repair/RepairLattice.h"
#include "core/repair/WayBack.h"
#include "core/study/FileFormats.h"

#include <QFile>

#include <algorithm>
#include <cstring>
#include <memory>

namespace core {

namespace {

/// By the NIfTI C library, not by the reader that the volume came from.
NiftiPointer openNifti(const Volume& volume)
{
    nifti_set_debug_level(0);
    if (!volume.keptHeaders)
        return NiftiPointer(nifti_image_read(QFile::encodeName(volume.sourcePath).constData(), 0));
    const auto kept = volume.keptHeaders->find(volume.sourcePath);
    nifti_1_header header{};
    if (kept == volume.keptHeaders->end() || kept->second.size() != qsizetype(sizeof header))
        return nullptr;
    std::memcpy(&header, kept->second.constData(), sizeof header);
    return NiftiPointer(nifti_convert_nhdr2nim(header, nullptr));
}

/// Size and affine of a volume that was read from one file.
Result<VolumeGeometry> gridOfFile(const Volume& volume)
{
    const FileFormat* format = fileFormatNamed(volume.sourceFormat);
    if (format != nullptr && format->geometryOf != nullptr) {
        if (!volume.keptHeaders)
            return format->geometryOf(format->headerBytes(volume.sourcePath), volume.sourcePath);
        const auto kept = volume.keptHeaders->find(volume.sourcePath);
        if (kept == volume.keptHeaders->end())
            return failure(ErrorCode::FileUnreadable, volume.sourcePath);
        return format->geometryOf(kept->second, volume.sourcePath);
    }
    const NiftiPointer source = openNifti(volume);
    if (source == nullptr)
        return failure(ErrorCode::FileUnreadable, volume.sourcePath);
    const mat44& affine = source->sform_code > 0 ? source->sto_xyz : source->qto_xyz;
    return VolumeGeometry{.size = {source->nx, source->ny, source->nz},
        .indexToWorld = lpsFrom(affine, source->xyz_units),
        .slicePositions = {}};
}

} // namespace

GridCorners cornersOf(const glm::dmat4& affine, const glm::ivec3& size)
{
    GridCorners corners{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 index((corner & 1) != 0 ? size.x - 1 : 0,
            (corner & 2) != 0 ? size.y - 1 : 0, (corner & 4) != 0 ? size.z - 1 : 0);
        corners[std::size_t(corner)] = glm::dvec3(affine * glm::dvec4(index, 1.0));
    }
    return corners;
}

double farthest(const GridCorners& a, const GridCorners& b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, glm::distance(a[i], b[i]));
    return worst;
}

Result<GridCorners> sourceCorners(
    const QString& file, const Volume& volume, const Progress& progress)
{
    const glm::ivec3 size = volume.geometry.size;
    if (const std::optional<WayBack> back = WayBack::of(volume)) {
        // The images lie where their slices are; from these the lattice is laid once more.
        if (const auto headers = checkedSourceHeaders(file, back->slices(), progress); !headers)
            return tl::unexpected(headers.error());
        const VolumeGeometry lattice =
            repairedGeometry(volume.asIs->geometry, *SeriesRepair::fromText(volume.repair));
        if (lattice.size != size)
            return failure(ErrorCode::ExportMismatch, file,
                Clause::saying("the repair of the source gives another grid"));
        return cornersOf(lattice.indexToWorld, size);
    }
    if (volume.sources.empty()) {
        const Result<VolumeGeometry> source = gridOfFile(volume);
        if (!source)
            return tl::unexpected(source.error());
        if (source->size != size)
            return failure(ErrorCode::ExportMismatch, volume.sourcePath,
                Clause::saying("its size is not that of the volume that was opened"));
        // Pictures do not say how far apart their voxels are: who opened them did.
        const std::optional<SeriesRepair> given = SeriesRepair::fromText(volume.repair);
        return cornersOf(
            given ? repairedGeometry(*source, *given).indexToWorld : source->indexToWorld, size);
    }
    const auto headers = checkedSourceHeaders(file, volume, progress);
    if (!headers)
        return tl::unexpected(headers.error());
    GridCorners corners{};
    for (int corner = 0; corner < 8; ++corner) {
        const HeaderPlane& plane =
            (corner & 4) != 0 ? headers->back().plane : headers->front().plane;
        corners[std::size_t(corner)] =
            plane.at((corner & 1) != 0 ? size.x - 1 : 0, (corner & 2) != 0 ? size.y - 1 : 0);
    }
    return corners;
}

} // namespace core
