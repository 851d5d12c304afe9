// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/PacsObjects.h"

#include "core/export/common/ExportMask.h"
#include "tests/support/series/SmallSeries.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <string>
#include <vector>

namespace test {

QStringList filesBelow(const QString& folder)
{
    QStringList paths;
    QDirIterator walk(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext())
        paths.append(walk.next());
    return paths;
}

TwoStudies::TwoStudies(const QString& folder)
{
    first.size = {8, 8, 3};
    first.studyUid = QStringLiteral("2.25.71");
    first.seriesUid = QStringLiteral("2.25.72");
    first.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
        set.putAndInsertString(DCM_PatientName, "M\xc3\xbcller^J\xc3\xb6rg");
        set.putAndInsertString(DCM_PatientID, "A1");
        set.putAndInsertString(DCM_StudyDate, "20200304");
        set.putAndInsertString(DCM_SOPInstanceUID, ("2.25.73" + std::to_string(k)).c_str());
    };
    second = first;
    second.studyUid = QStringLiteral("2.25.81");
    second.seriesUid = QStringLiteral("2.25.82");
    second.modality = QStringLiteral("MR");
    second.adjust = [](DcmDataset& set, int k) {
        set.putAndInsertString(DCM_PatientName, "Doe^Jane");
        set.putAndInsertString(DCM_PatientID, "B2");
        set.putAndInsertString(DCM_StudyDate, "20210506");
        set.putAndInsertString(DCM_SOPInstanceUID, ("2.25.83" + std::to_string(k)).c_str());
    };
    files = writeSeries(first, QDir(folder).filePath(QStringLiteral("1")));
    files += writeSeries(second, QDir(folder).filePath(QStringLiteral("2")));
}

SmallMask::SmallMask(const QString& folder)
    : file(QDir(folder).filePath(QStringLiteral("mask.dcm")))
{
    SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(QDir(folder).filePath(QStringLiteral("images")));
    std::vector<std::uint8_t> labels(volume.geometry.voxelCount());
    for (std::size_t i = 0; i < labels.size(); ++i)
        labels[i] = std::uint8_t(i % 7 < 3);
    const std::vector<core::LabelPlaneView> planes{{0, labels}};
    core::Segment segment;
    segment.label = 1;
    segment.name = QStringLiteral("Schädel");
    segment.code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("89546000"),
        .meaning = QStringLiteral("Skull")};
    const auto written = core::exportMask(
        volume, {.file = file, .segments = {segment}, .planes = planes}, core::Progress());
    if (!written) {
        problem = ui::errorText(written.error());
        return;
    }
    sha256 = written->sha256;
    DcmFileFormat sent;
    OFString study;
    if (sent.loadFile(QFile::encodeName(file).constData()).bad()
        || sent.getDataset()->findAndGetOFString(DCM_StudyInstanceUID, study).bad())
        problem = QStringLiteral("the mask cannot be read");
    studyUid = QString::fromLatin1(study.c_str());
}

} // namespace test
