// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"

#include "core/base/ParallelFor.h"
#include "core/base/files/StagedFolder.h"
#include "core/demo/HeadPhantom.h"
#include "core/demo/Noise.h"
#include "core/dicom/write/CtSeriesWriter.h"
#include "core/nifti/NiftiWriter.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace core {

namespace {

constexpr float noiseHu = 5.5F;

VolumeGeometry demoGeometry()
{
    VolumeGeometry geometry;
    geometry.size = {256, 256, 200};
    const glm::dvec3 spacing(0.9, 0.9, 1.0);
    geometry.indexToWorld = glm::dmat4(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        geometry.indexToWorld[axis][axis] = spacing[axis];
        geometry.indexToWorld[3][axis] = -0.5 * (geometry.size[axis] - 1) * spacing[axis];
    }
    return geometry;
}

void fillSlice(DemoStudy& study, const HeadPhantom& head, int k)
{
    const glm::ivec3 size = study.geometry.size;
    std::size_t index = static_cast<std::size_t>(k) * static_cast<std::size_t>(size.x)
        * static_cast<std::size_t>(size.y);
    for (int j = 0; j < size.y; ++j) {
        for (int i = 0; i < size.x; ++i, ++index) {
            const HeadPhantom::Sample sample =
                head.at(glm::vec3(study.geometry.toWorld(glm::dvec3(i, j, k))));
            const float noisy = sample.hounsfield + noiseHu * demo::gaussian(demo::hash(i, j, k));
            study.hounsfield[index] =
                static_cast<std::int16_t>(std::lround(std::clamp(noisy, -1024.0F, 3071.0F)));
            study.parts[index] = static_cast<std::uint8_t>(sample.part);
        }
    }
}

/// 2.25 and the decimal of a UUID (PS3.5 B.2) whose last four digits count.
QString demoUid(int number)
{
    return QStringLiteral("2.25.16327913548419753801469212217495276%1")
        .arg(number, 4, 10, QLatin1Char('0'));
}

CtSeries demoSeries(const DemoStudy& study)
{
    CtSeries series;
    series.identity.patientName = QStringLiteral("DOE^DEMO");
    series.identity.patientId = QStringLiteral("BURIN-DEMO");
    series.identity.birthDate = QStringLiteral("1970-01-01");
    series.identity.sex = QStringLiteral("O");
    series.identity.studyUid = demoUid(1);
    series.identity.studyDate = QStringLiteral("2026-01-01");
    series.identity.studyDescription = QStringLiteral("Burin demonstration head");
    series.identity.accessionNumber = QStringLiteral("DEMO1");
    series.identity.seriesUid = demoUid(2);
    series.identity.seriesNumber = QStringLiteral("1");
    series.identity.seriesDescription = QStringLiteral("Burin demonstration head");
    series.identity.modality = QStringLiteral("CT");
    series.identity.frameOfReferenceUid = demoUid(3);
    series.identity.patientPosition = QStringLiteral("HFS");
    series.geometry = study.geometry;
    series.hounsfield = study.hounsfield;
    series.window = {.centre = 40.0, .width = 80.0};
    series.bodyPart = QStringLiteral("HEAD");
    series.manufacturer = QStringLiteral("Burin");
    series.comments = QStringLiteral("Made by formulas; no patient");
    series.instanceUid = [](int k) { return demoUid(1000 + k); };
    return series;
}

Result<void> writeInto(const QString& folder, const DemoStudy& study)
{
    const Result<void> written = writeCtSeries(folder, demoSeries(study));
    if (!written)
        return written;
    const NiftiImage labels{.geometry = study.geometry,
        .voxels = std::span<const std::uint8_t>(study.parts),
        .description = QStringLiteral("Burin demonstration head, parts")};
    const auto truth = writeNifti(folder + QStringLiteral("/labels.nii.gz"), labels);
    if (!truth)
        return tl::unexpected(truth.error());
    QByteArray text;
    for (const HeadPartName& part : headPartNames())
        text += QByteArray::number(static_cast<int>(part.part)) + ' ' + part.name + '\n';
    QFile names(folder + QStringLiteral("/labels.txt"));
    if (!names.open(QIODevice::WriteOnly) || names.write(text) != text.size() || !names.flush())
        return failure(ErrorCode::FileUnwritable, names.fileName(), names.errorString());
    return {};
}

} // namespace

Result<DemoStudy> makeDemoStudy(const Progress& progress)
{
    DemoStudy study;
    study.geometry = demoGeometry();
    study.hounsfield.resize(study.geometry.voxelCount());
    study.parts.resize(study.geometry.voxelCount());
    const HeadPhantom head;
    std::atomic<int> done = 0;
    const int slices = study.geometry.size.z;
    parallelFor(slices, [&](int k) {
        if (progress.cancelled())
            return;
        fillSlice(study, head, k);
        progress.report(ProgressStep::MakingDemonstration, ++done, slices);
    });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return study;
}

Result<void> writeDemoStudy(const QString& folder, const DemoStudy& study)
{
    const QString target = QDir::cleanPath(QDir(folder).absolutePath());
    if (!QDir().mkpath(QFileInfo(target).path()))
        return failure(ErrorCode::FileUnwritable, folder);
    Result<StagedFolder> staged = StagedFolder::create(target);
    if (!staged && staged.error().code == ErrorCode::FileExists)
        return failure(
            ErrorCode::FileUnwritable, folder, Clause::saying("it is not an empty folder"));
    if (!staged)
        return tl::unexpected(staged.error());
    if (const Result<void> written = writeInto(staged->path(), study); !written) {
        Error error = written.error();
        error.arguments.replace(staged->path(), target);
        return tl::unexpected(error);
    }
    return staged->commit();
}

} // namespace core
