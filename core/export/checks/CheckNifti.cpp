// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"

#include "core/export/common/LabelMap.h"
#include "core/export/common/NiftiImage.h"

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

Result<ReportLines> checkNiftiExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const Volume& volume = expected.volume;
    const glm::ivec3 size = volume.geometry.size;
    const auto mismatch = [&](const Clause& what) {
        return failure(ErrorCode::ExportMismatch, file, what);
    };
    const NiftiPointer image = open(file, true);
    if (image == nullptr || image->data == nullptr)
        return failure(ErrorCode::FileUnreadable, file);
    if (image->nx != size.x || image->ny != size.y || image->nz != size.z
        || image->nvox != volume.geometry.voxelCount() || image->datatype != DT_UINT8)
        return mismatch(Clause::saying("size or type of the voxels"));

    const auto place = labelMapPlace(file, volume, progress);
    if (!place)
        return tl::unexpected(place.error());
    if (image->sform_code <= 0)
        return mismatch(Clause::saying("the sform is missing"));
    const double bySform =
        farthest(cornersOf(lpsFrom(image->sto_xyz, image->xyz_units), size), place->corners);
    if (bySform > place->toleranceMm)
        return mismatch(Clause::saying("the sform puts a corner %1 mm away from where the source "
                                       "has it",
            bySform));
    double byQform = 0.0;
    if (image->qform_code > 0) {
        byQform =
            farthest(cornersOf(lpsFrom(image->qto_xyz, image->xyz_units), size), place->corners);
        if (byQform > place->toleranceMm)
            return mismatch(Clause::saying("the qform puts a corner %1 mm away from where the "
                                           "source has it",
                byQform));
    }

    const auto* voxels = static_cast<const std::uint8_t*>(image->data);
    const std::size_t wrong = wrongVoxels({voxels, image->nvox}, expected);
    if (wrong != 0)
        return mismatch(Clause::saying("%1 voxels are not as drawn", wrong));
    return ReportLines{ReportSentence{ReportCode::CornersOnSource,
                           {QString::number(std::max(bySform, byQform), 'f', 4)}},
        ReportSentence{ReportCode::VoxelsAsDrawn, {std::int64_t(image->nvox)}}};
}

} // namespace core
