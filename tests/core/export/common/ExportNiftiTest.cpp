// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ExportChoices.h"
#include "core/export/common/ExportMask.h"
#include "core/nifti/NiftiWriter.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/Affine.h"
#include "tests/support/series/LabelledSeries.h"
#include "tests/support/series/SmallSeries.h"
#include "tests/support/servers/Python.h"
#include "ui/texts/ReportTexts.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <glm/gtc/matrix_transform.hpp>

#include <QTest>

#include <random>

namespace exportNiftiTest {

namespace {

core::Segment segmentOf(int label, int plane = 0)
{
    core::Segment segment;
    segment.label = std::uint8_t(label);
    segment.plane = std::uint8_t(plane);
    segment.name = QStringLiteral("Part %1").arg(label);
    return segment;
}

std::vector<std::uint8_t> randomLabels(const glm::ivec3& size, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<std::uint8_t> labels(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (auto& label : labels)
        label = std::uint8_t(random() % 4);
    return labels;
}

QString messageOf(const core::Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

} // namespace

class ExportNiftiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nibabelSeesTheSame_data() { test::addPlacementRows(false); }
    void nibabelSeesTheSame();
    void aMaskOnANiftiVolume();
    void unevenSlices();
    void planes();
    void nameIsChecked();
    void choices();
};

void ExportNiftiTest::nibabelSeesTheSame()
{
    QFETCH(QString, placement);
    const test::SeriesPlacement lies = test::placementOf(placement);
    const test::LabelledSeries on(lies.series, randomLabels(lies.series.size, 3));
    const QString file = on.folder.filePath(QStringLiteral("mask.nii.gz"));
    const auto report = core::exportMask(on.volume,
        {.format = core::ExportFormat::Nifti,
            .file = file,
            .segments = {segmentOf(1), segmentOf(3)},
            .planes = on.planes},
        {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));

    const auto read = test::runScript(QStringLiteral("nifti_facts.py"), {file});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QVERIFY(test::cornerDistance(test::matrixFrom(facts["sform"]), on.volume.geometry) < 1e-3);
    QCOMPARE(facts["qform"].isNull(), lies.tilted);
    QCOMPARE(
        ui::reportTexts(report->cautions).join(QLatin1Char(' ')).contains(QStringLiteral("tilted")),
        lies.tilted);
    QByteArray expected(qsizetype(on.labels.size()), 0);
    for (std::size_t i = 0; i < on.labels.size(); ++i)
        expected[qsizetype(i)] = char(on.labels[i] == 1 || on.labels[i] == 3 ? on.labels[i] : 0);
    QCOMPARE(facts["sha256"].toString().toLatin1(),
        QCryptographicHash::hash(expected, QCryptographicHash::Sha256).toHex());
    QCOMPARE(facts["intent"].toInt(), 1002);
}

void ExportNiftiTest::aMaskOnANiftiVolume()
{
    QTemporaryDir folder;
    core::Volume volume;
    volume.sourceFormat = QStringLiteral("NIfTI");
    volume.sourcePath = folder.filePath(QStringLiteral("head.nii.gz"));
    volume.geometry.size = {9, 8, 7};
    // A left-handed grid, as NIfTI allows.
    volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(-0.9, 0.1, 0, 0),
        glm::dvec4(0.1, 0.9, 0, 0), glm::dvec4(0, 0, 1.5, 0), glm::dvec4(80, -60, 33, 1));
    const std::vector<std::int16_t> values(volume.geometry.voxelCount(), 100);
    QVERIFY(core::writeNifti(
        volume.sourcePath, {.geometry = volume.geometry, .voxels = values, .description = {}}));
    const auto labels = randomLabels(volume.geometry.size, 3);
    const std::vector<core::LabelPlaneView> views{{.plane = 0, .labels = labels}};
    const core::ExportRequest request{.format = core::ExportFormat::Nifti,
        .file = folder.filePath(QStringLiteral("mask.nii.gz")),
        .force = true,
        .segments = {segmentOf(2)},
        .planes = views};
    const auto report = core::exportMask(volume, request, {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const auto read = test::runScript(QStringLiteral("nifti_facts.py"), {request.file});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QVERIFY(test::cornerDistance(test::matrixFrom(facts["sform"]), volume.geometry) < 1e-3);
    QVERIFY(test::cornerDistance(test::matrixFrom(facts["qform"]), volume.geometry) < 1e-3);

    auto seg = request;
    seg.format = core::ExportFormat::DicomSeg;
    QCOMPARE(core::exportMask(volume, seg, {}).error().code, core::ErrorCode::UnsupportedFormat);

    // The source is exchanged for one that lies half a voxel further.
    core::VolumeGeometry moved = volume.geometry;
    moved.indexToWorld[3] += 0.5 * moved.indexToWorld[0];
    QVERIFY(core::writeNifti(
        volume.sourcePath, {.geometry = moved, .voxels = values, .description = {}}, true));
    const auto caught = core::exportMask(volume, request, {});
    QVERIFY(!caught);
    QCOMPARE(caught.error().code, core::ErrorCode::ExportMismatch);
}

void ExportNiftiTest::unevenSlices()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 2.5});
    const auto labels = randomLabels(series.size, 3);
    const std::vector<core::LabelPlaneView> views{{.plane = 0, .labels = labels}};
    core::ExportRequest request{.format = core::ExportFormat::Nifti,
        .file = folder.filePath(QStringLiteral("mask.nii.gz")),
        .segments = {segmentOf(2)},
        .planes = views};

    series.positions[3].z += 0.1;
    const core::Volume little = series.write(folder.filePath(QStringLiteral("little")));
    const auto report = core::exportMask(little, request, {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QVERIFY(ui::reportTexts(report->cautions)
                .join(QLatin1Char(' '))
                .contains(QStringLiteral("0.100 mm")));

    series.positions.back().z += 5.0;
    const core::Volume gap = series.write(folder.filePath(QStringLiteral("gap")));
    request.file = folder.filePath(QStringLiteral("gap.nii.gz"));
    const auto refused = core::exportMask(gap, request, {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY(refused.error().arguments.value(1).contains(QStringLiteral("DICOM SEG")));
    QVERIFY(!QFile::exists(request.file));
}

void ExportNiftiTest::planes()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 2.5});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    std::vector<std::uint8_t> first(volume.geometry.voxelCount(), 0);
    std::vector<std::uint8_t> second = first;
    first[10] = 1;
    second[11] = 2;
    second[12] = 1;
    const std::vector<core::LabelPlaneView> views{
        {.plane = 0, .labels = first}, {.plane = 1, .labels = second}};
    core::ExportRequest request{.format = core::ExportFormat::Nifti,
        .file = folder.filePath(QStringLiteral("mask.nii.gz")),
        .force = true,
        .segments = {segmentOf(1, 0), segmentOf(2, 1)},
        .planes = views};
    QVERIFY(core::exportMask(volume, request, {}));
    request.segments = {segmentOf(1, 0), segmentOf(1, 1)};
    QCOMPARE(
        core::exportMask(volume, request, {}).error().code, core::ErrorCode::UnsupportedFormat);
    second[10] = 2;
    request.segments = {segmentOf(1, 0), segmentOf(2, 1)};
    QCOMPARE(
        core::exportMask(volume, request, {}).error().code, core::ErrorCode::UnsupportedFormat);
    request.segments = {segmentOf(1, 2)};
    QCOMPARE(core::exportMask(volume, request, {}).error().code, core::ErrorCode::UnknownSegment);
}

void ExportNiftiTest::nameIsChecked()
{
    core::Volume volume;
    volume.geometry.size = {1, 1, 1};
    const std::vector<std::uint8_t> labels{1};
    const std::vector<core::LabelPlaneView> views{{.plane = 0, .labels = labels}};
    const auto refused = core::exportMask(volume,
        {.format = core::ExportFormat::Nifti,
            .file = QStringLiteral("mask.nrrd"),
            .segments = {segmentOf(1)},
            .planes = views},
        {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY(core::exportFormatNamed(QStringLiteral("nifti")) == core::ExportFormat::Nifti);
    QVERIFY(core::exportFormatNamed(QStringLiteral("dicom-seg")) == core::ExportFormat::DicomSeg);
    QVERIFY(!core::exportFormatNamed(QStringLiteral("3mf")));
}

void ExportNiftiTest::choices()
{
    core::Document document;
    document.volumes.resize(1);
    document.volumes[0].geometry.indexToWorld =
        glm::scale(glm::dmat4(1.0), glm::dvec3(0.5, 0.5, 2.0));
    for (int label = 1; label <= 4; ++label) {
        core::Segment segment = segmentOf(label);
        segment.voxels = label == 3 ? 0 : 1000 * label;
        segment.visible = label != 2;
        if (label == 1)
            segment.code = core::anatomicalStructure();
        document.segments.push_back(segment);
    }
    std::bitset<256> growing;
    growing.set(4);
    const auto choices = core::exportChoices(document, growing);
    QCOMPARE(choices.size(), std::size_t(4));
    QCOMPARE(choices[0].millilitres, 0.5);
    QVERIFY(choices[0].chosen && !choices[1].chosen && !choices[2].chosen && choices[3].chosen);
    using core::ExportRemark;
    using Remarks = std::vector<ExportRemark>;
    QVERIFY(choices[0].remarks.empty());
    QCOMPARE(choices[1].remarks, Remarks({ExportRemark::Hidden, ExportRemark::NotCoded}));
    QCOMPARE(choices[2].remarks, Remarks({ExportRemark::Empty, ExportRemark::NotCoded}));
    const Remarks growth{ExportRemark::GrowthNotFinished, ExportRemark::NotCoded};
    QCOMPARE(choices[3].remarks, growth);

    document.surface = core::RefinedSurface{.segment = 4, .differs = true};
    QCOMPARE(core::exportChoices(document, growing)[3].remarks,
        Remarks({ExportRemark::GrowthNotFinished, ExportRemark::SurfaceNotWrittenBack,
            ExportRemark::NotCoded}));
    QVERIFY(core::exportChoices(document, growing)[0].remarks.empty());
    document.surface->differs = false;
    QCOMPARE(core::exportChoices(document, growing)[3].remarks, growth);
}

BURIN_TEST(ExportNiftiTest)

} // namespace exportNiftiTest

#include "ExportNiftiTest.moc"
