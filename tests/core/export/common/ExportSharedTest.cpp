// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ExportMask.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/servers/Python.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>

namespace exportSharedTest {

/// Masks on real studies, written, checked by Burin, and read by pydicom, dciodvfy and nibabel.
class ExportSharedTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aMaskByAnotherProgram();
    void everyVolumeOfACase_data();
    void everyVolumeOfACase();
    void imagesWithoutUids();
};

namespace {

core::Segment skull()
{
    core::Segment segment;
    segment.label = 1;
    segment.name = QStringLiteral("Skull");
    segment.rgb = 0xf0e0c0;
    segment.code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("89546000"),
        .meaning = QStringLiteral("Skull")};
    return segment;
}

QString folderOf(const test::SharedCase& shared)
{
    return shared.unpacked.isEmpty() ? shared.source : shared.unpacked;
}

QString sha256Of(const std::vector<std::uint8_t>& labels)
{
    const QByteArray bytes = QByteArray::fromRawData(
        reinterpret_cast<const char*>(labels.data()), qsizetype(labels.size()));
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

QString messageOf(const core::Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

/// The upper half of the values, in the middle third of the slices.
std::vector<std::uint8_t> brightVoxels(const core::LoadedVolume& loaded)
{
    std::vector<std::uint16_t> sorted = loaded.codes;
    const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const glm::ivec3 size = loaded.volume.geometry.size;
    const std::size_t slice = std::size_t(size.x) * std::size_t(size.y);
    std::vector<std::uint8_t> labels(loaded.codes.size(), 0);
    const int first = size.z / 3;
    const int last = std::max(first + 1, 2 * size.z / 3);
    for (std::size_t i = slice * std::size_t(first); i < slice * std::size_t(last); ++i)
        labels[i] = loaded.codes[i] > *middle ? 1 : 0;
    return labels;
}

void exportSeg(const core::Volume& volume, core::ExportRequest request, const QString& sha256)
{
    QTemporaryDir folder;
    request.format = core::ExportFormat::DicomSeg;
    request.file = folder.filePath(QStringLiteral("seg.dcm"));
    const auto report = core::exportMask(volume, request, {});
    if (!core::dicomSegObstacle(volume).isEmpty()) {
        QVERIFY(!report);
        QCOMPARE(report.error().code, core::ErrorCode::UnsupportedFormat);
        return;
    }
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const auto verified = test::runProgram(QStringLiteral("dciodvfy"), {request.file});
    QVERIFY2(
        verified.exitCode == 0 && !verified.output.contains("Error"), verified.output.constData());
    const auto read =
        test::runScript(QStringLiteral("seg_facts.py"), {request.file, volume.sourcePath});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QCOMPARE(facts["sha256"].toArray(), (QJsonArray{sha256}));
}

void exportNifti(const core::Volume& volume, core::ExportRequest request, const QString& sha256)
{
    QTemporaryDir folder;
    request.format = core::ExportFormat::Nifti;
    request.file = folder.filePath(QStringLiteral("seg.nii.gz"));
    const auto report = core::exportMask(volume, request, {});
    if (!report && !volume.geometry.slicePositions.empty()) {
        QCOMPARE(report.error().code, core::ErrorCode::UnsupportedFormat);
        return;
    }
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const auto read = test::runScript(QStringLiteral("nifti_facts.py"), {request.file});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QCOMPARE(facts["sha256"].toString(), sha256);
}

void exportSegNrrd(const core::Volume& volume, core::ExportRequest request)
{
    QTemporaryDir folder;
    request.format = core::ExportFormat::SegNrrd;
    request.file = folder.filePath(QStringLiteral("mask.seg.nrrd"));
    const auto report = core::exportMask(volume, request, {});
    if (!report && !volume.geometry.slicePositions.empty()) {
        QCOMPARE(report.error().code, core::ErrorCode::UnsupportedFormat);
        return;
    }
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const auto read = core::loadVolume(request.file);
    QVERIFY2(read.has_value(), qPrintable(read ? QString() : messageOf(read.error())));
    const auto labels = request.planes.front().labels;
    QVERIFY(read->codes.size() == labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (read->volume.encoding.value(read->codes[i]) != double(labels[i]))
            QFAIL(qPrintable(QStringLiteral("voxel %1").arg(i)));
    }
}

void exportAndCompare(const core::Volume& volume, const std::vector<std::uint8_t>& labels)
{
    if (std::find(labels.begin(), labels.end(), 1) == labels.end())
        return;
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    const core::ExportRequest request{.segments = {skull()}, .planes = planes};
    exportSeg(volume, request, sha256Of(labels));
    exportNifti(volume, request, sha256Of(labels));
    exportSegNrrd(volume, request);
}

} // namespace

void ExportSharedTest::aMaskByAnotherProgram()
{
    const test::SharedCase shared = test::sharedCase(QStringLiteral("ct_cranium_inv3"));
    if (shared.source.isEmpty())
        QSKIP("there are no shared data");
    const auto loaded = core::loadVolume(folderOf(shared));
    QVERIFY2(loaded.has_value(), qPrintable(loaded ? QString() : messageOf(loaded.error())));
    const auto mask =
        core::loadVolume(QDir(shared.source).filePath(QStringLiteral("mask_bone_226_3071.nii.gz")));
    QVERIFY2(mask.has_value(), qPrintable(mask ? QString() : messageOf(mask.error())));
    QVERIFY(mask->volume.geometry.size == loaded->volume.geometry.size);
    std::vector<std::uint8_t> labels(mask->codes.size());
    for (std::size_t i = 0; i < labels.size(); ++i)
        labels[i] = mask->volume.encoding.value(mask->codes[i]) > 0.0 ? 1 : 0;
    // The README beside the data: the mask is 226 … 3071 exactly, column i, row j, slice k.
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const double value = loaded->volume.encoding.value(loaded->codes[i]);
        QCOMPARE(labels[i] != 0, value >= 226.0 && value <= 3071.0);
    }
    exportAndCompare(loaded->volume, labels);
}

void ExportSharedTest::everyVolumeOfACase_data()
{
    QTest::addColumn<QString>("name");
    const auto add = [](const char* name) { QTest::newRow(name) << QString::fromLatin1(name); };
    add("ct_cranium_inv3");
    add("mr_t1_sag_mprage");
    add("ct_tilt_study_philips");
    if (qEnvironmentVariableIsSet("BURIN_LONG")) {
        add("ct_lidc0314_lower");
        add("ct_ibsi_lung_rtstruct");
        add("ct_mr_pet_sts001");
        add("ct_totalseg_body_3mm");
        add("edge_charsets");
        add("mr_4d_fmri_ge");
        add("mr_brain_mricrop_itksnap");
        add("mr_multifragment_jpegll");
        add("mr_patient_position_hfs_hfp");
        add("mr_prostate_localizer_missing");
        add("pet_headneck_seg");
        add("seg_dcmqi_liver");
    }
}

void ExportSharedTest::everyVolumeOfACase()
{
    QFETCH(QString, name);
    const test::SharedCase shared = test::sharedCase(name);
    if (shared.source.isEmpty())
        QSKIP("there are no shared data");
    const auto listing = core::scanStudies(folderOf(shared));
    QVERIFY2(listing.has_value(), qPrintable(listing ? QString() : messageOf(listing.error())));
    int volumes = 0;
    for (const core::SeriesEntry* entry : listing->candidates()) {
        if (!entry->isVolume())
            continue;
        const auto loaded = core::loadVolume(listing->path, entry->key);
        QVERIFY2(loaded.has_value(), qPrintable(loaded ? QString() : messageOf(loaded.error())));
        exportAndCompare(loaded->volume, brightVoxels(*loaded));
        ++volumes;
    }
    QVERIFY(volumes > 0);
}

void ExportSharedTest::imagesWithoutUids()
{
    const test::SharedCase shared = test::sharedCase(QStringLiteral("ct_abdomen_j2k_organs"));
    if (shared.source.isEmpty())
        QSKIP("there are no shared data");
    const auto loaded = core::loadVolume(QDir(shared.source).filePath(QStringLiteral("dicom")));
    QVERIFY2(loaded.has_value(), qPrintable(loaded ? QString() : messageOf(loaded.error())));
    QTemporaryDir folder;
    const auto labels = brightVoxels(*loaded);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    core::ExportRequest request{.format = core::ExportFormat::DicomSeg,
        .file = folder.filePath(QStringLiteral("seg.dcm")),
        .segments = {skull()},
        .planes = planes};
    const auto refused = core::exportMask(loaded->volume, request, {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY(messageOf(refused.error()).contains(QStringLiteral("UID")));
    QVERIFY(messageOf(refused.error()).contains(QStringLiteral("NIfTI")));
    request.format = core::ExportFormat::Nifti;
    request.file = folder.filePath(QStringLiteral("seg.nii.gz"));
    const auto report = core::exportMask(loaded->volume, request, {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const auto read = test::runScript(QStringLiteral("nifti_facts.py"), {request.file});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QCOMPARE(facts["sha256"].toString(), sha256Of(labels));
}

BURIN_TEST(ExportSharedTest)

} // namespace exportSharedTest

#include "ExportSharedTest.moc"
