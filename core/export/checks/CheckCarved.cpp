// SPDX-License-Identifier: Apache-2.0
#include "core/export/checks/CheckCarved.h"

#include "core/dicom/header/ImageHeaderReader.h"
#include "core/export/common/CheckSources.h"
#include "core/study/StudyLoader.h"

#include <QFile>

#include <nifti1_io.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace core {

namespace {

tl::unexpected<Error> mismatch(const QString& file, const Clause& what)
{
    return failure(ErrorCode::ExportMismatch, file, what);
}

/// How far the outermost voxels of two grids of one size lie apart.
double farthestCorner(const glm::dmat4& a, const glm::dmat4& b, const glm::ivec3& size)
{
    double worst = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 index((corner & 1) != 0 ? size.x - 1 : 0,
            (corner & 2) != 0 ? size.y - 1 : 0, (corner & 4) != 0 ? size.z - 1 : 0, 1.0);
        worst = std::max(worst, glm::distance(glm::dvec3(a * index), glm::dvec3(b * index)));
    }
    return worst;
}

glm::dmat4 lpsFrom(const mat44& ras)
{
    glm::dmat4 lps(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            lps[column][row] = (row < 2 ? -1.0 : 1.0) * double(ras.m[row][column]);
    }
    return lps;
}

ReportSentence cornersAgree(double apart)
{
    return {ReportCode::CornersOnStudy, {QString::number(apart, 'f', 4)}};
}

} // namespace

Result<ReportLines> checkNiftiValues(
    const QString& file, const Volume& volume, const ExpectedValue& expected)
{
    nifti_set_debug_level(0);
    const std::unique_ptr<nifti_image, decltype(&nifti_image_free)> image(
        nifti_image_read(QFile::encodeName(file).constData(), 1), &nifti_image_free);
    if (!image || !image->data)
        return failure(ErrorCode::FileUnreadable, file);
    const glm::ivec3 size = volume.geometry.size;
    if (image->nx != size.x || image->ny != size.y || image->nz != size.z
        || image->nvox != volume.geometry.voxelCount() || image->sform_code <= 0
        || image->xyz_units != NIFTI_UNITS_MM)
        return mismatch(file, Clause::saying("the size or the sform"));
    const glm::dvec3 spacing = volume.geometry.spacingMm();
    const double apart =
        farthestCorner(lpsFrom(image->sto_xyz), volume.geometry.indexToWorld, size);
    if (apart > 0.1 * std::min({spacing.x, spacing.y, spacing.z}))
        return mismatch(file, Clause::saying("the sform puts a corner %1 mm off", apart));
    std::size_t wrong = 0;
    const auto compare = [&](const auto* voxels) {
        using Voxel = std::decay_t<decltype(*voxels)>;
        for (std::size_t i = 0; i < image->nvox; ++i)
            wrong += voxels[i] == Voxel(expected(i)) ? 0U : 1U;
    };
    if (image->datatype == DT_UINT8)
        compare(static_cast<const std::uint8_t*>(image->data));
    else if (image->datatype == DT_INT16)
        compare(static_cast<const std::int16_t*>(image->data));
    else if (image->datatype == DT_FLOAT32)
        compare(static_cast<const float*>(image->data));
    else
        return mismatch(file, Clause::saying("the type of the voxels"));
    if (wrong != 0)
        return mismatch(file, Clause::saying("%1 voxels are not as they should be", wrong));
    return ReportLines{cornersAgree(apart),
        ReportSentence{ReportCode::VoxelsAsTheyShould, {std::int64_t(image->nvox)}}};
}

Result<ReportLines> checkCarvedSeries(const QString& folder, const Volume& volume,
    const ExpectedValue& expected, double tolerance, const Progress& progress)
{
    const Result<LoadedVolume> read = loadVolume(folder, QString(), progress);
    if (!read)
        return tl::unexpected(read.error());
    const Volume& made = read->volume;
    if (made.geometry.size != volume.geometry.size)
        return mismatch(folder, Clause::saying("the size of the volume"));
    const double apart = farthestCorner(
        made.geometry.indexToWorld, volume.geometry.indexToWorld, volume.geometry.size);
    if (apart > positionToleranceMm(volume.geometry))
        return mismatch(folder, Clause::saying("a corner lies %1 mm off", apart));
    if (made.identity.studyUid != volume.identity.studyUid
        || made.identity.frameOfReferenceUid != volume.identity.frameOfReferenceUid
        || made.identity.patientId != volume.identity.patientId)
        return mismatch(folder, Clause::saying("patient, study or frame of reference"));
    if (made.identity.seriesUid == volume.identity.seriesUid)
        return mismatch(folder, Clause::saying("the series is not a new one"));
    for (std::size_t k = 0; k < made.sources.size(); ++k) {
        const Result<ImageHeader> header = readImageHeader(made.sources[k].file);
        if (!header)
            return tl::unexpected(header.error());
        if (header->sopInstanceUid == volume.sources[k].sopInstanceUid
            || header->sopClassUid != volume.sources[k].sopClassUid
            || header->imageType.value(0) != QLatin1String("DERIVED"))
            return mismatch(made.sources[k].file, Clause::saying("what it says it is"));
    }
    std::size_t wrong = 0;
    const double allowed = tolerance + made.encoding.maxError;
    for (std::size_t i = 0; i < read->codes.size(); ++i) {
        const double value = made.encoding.value(read->codes[i]);
        wrong += std::abs(value - expected(i)) <= allowed ? 0U : 1U;
    }
    if (wrong != 0)
        return mismatch(folder, Clause::saying("%1 voxels are not as they should be", wrong));
    return ReportLines{cornersAgree(apart),
        ReportSentence{ReportCode::SeriesAsItShould, {std::int64_t(read->codes.size())}}};
}

} // namespace core
