// SPDX-License-Identifier: Apache-2.0
#include "core/export/ExportMask.h"
#include "tests/peers/ItkNrrd.h"
#include "tests/support/Affine.h"
#include "tests/support/SmallSeries.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QTemporaryDir>
#include <QTest>

#include <random>

/// A mask for 3D Slicer as the library that it reads with sees it.
class ExportSegNrrdItkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itkSeesTheSame_data();
    void itkSeesTheSame();
};

void ExportSegNrrdItkTest::itkSeesTheSame_data()
{
    QTest::addColumn<glm::dmat3>("directions");
    QTest::addColumn<glm::dvec3>("shear");
    QTest::addColumn<int>("slices");
    const auto row = [](const char* name, const glm::dmat3& directions,
                         const glm::dvec3& shear = glm::dvec3(0),
                         int slices = 6) { QTest::newRow(name) << directions << shear << slices; };
    row("supine", glm::dmat3(1.0));
    row("prone", glm::dmat3(-1, 0, 0, 0, -1, 0, 0, 0, 1));
    row("coronal", glm::dmat3(1, 0, 0, 0, 0, -1, 0, 1, 0));
    row("sagittal", glm::dmat3(0, 1, 0, 0, 0, -1, -1, 0, 0));
    row("oblique",
        glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -0.5)))));
    row("tilted", glm::dmat3(1.0), glm::dvec3(0, 0.8, 0));
    row("one slice", glm::dmat3(1.0), glm::dvec3(0), 1);
}

void ExportSegNrrdItkTest::itkSeesTheSame()
{
    QFETCH(glm::dmat3, directions);
    QFETCH(glm::dvec3, shear);
    QFETCH(int, slices);
    QTemporaryDir folder;
    test::SmallSeries series;
    series.size = {11, 7, slices};
    series.rowDirection = directions[0];
    series.columnDirection = directions[1];
    series.placeEvenly({-40.25, -31.5, 812.125}, directions[2] * 2.5 + shear);
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    std::mt19937 random(3);
    std::vector<std::uint8_t> labels(volume.geometry.voxelCount());
    for (auto& label : labels)
        label = std::uint8_t(random() % 3);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    core::Segment first;
    first.label = 1;
    first.name = QStringLiteral("Schädel 頭蓋\nC:\\new");
    first.rgb = 0xff8000;
    first.code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("89546000"),
        .meaning = QStringLiteral("Skull")};
    core::Segment second;
    second.label = 2;
    second.name = QStringLiteral("Part");
    const core::ExportRequest request{.format = core::ExportFormat::SegNrrd,
        .file = folder.filePath(QStringLiteral("mask.seg.nrrd")),
        .segments = {first, second},
        .planes = planes};
    const auto report = core::exportMask(volume, request, {});
    QVERIFY2(report.has_value(),
        qPrintable(report ? QString() : report.error().arguments.join(QStringLiteral(" | "))));

    const peer::ItkNrrd read = peer::readItkNrrd(request.file.toStdString());
    QVERIFY2(read.error.empty(), read.error.c_str());
    QVERIFY(read.size == volume.geometry.size);
    QVERIFY(test::cornerDistance(read.indexToWorld, volume.geometry) < 1e-6);
    QVERIFY(read.voxels == labels);
    const auto word = [&](const char* key) {
        const auto found = read.words.find(key);
        return found == read.words.end() ? QStringLiteral("(none)")
                                         : QString::fromStdString(found->second);
    };
    QCOMPARE(word("Segment0_Name"), first.name);
    QCOMPARE(word("Segment0_ID"), QStringLiteral("Segment_1"));
    QCOMPARE(word("Segment0_Color"), QStringLiteral("1 0.501961 0"));
    QCOMPARE(word("Segment0_LabelValue"), QStringLiteral("1"));
    QVERIFY(word("Segment0_Tags").contains(QStringLiteral("~SCT^89546000^Skull~")));
    QCOMPARE(word("Segment1_Name"), second.name);
    QCOMPARE(word("Segment1_Tags"), QStringLiteral("(none)"));
    QCOMPARE(word("Segmentation_MasterRepresentation"), QStringLiteral("Binary labelmap"));
    QCOMPARE(word("Segmentation_ReferenceImageExtentOffset"), QStringLiteral("0 0 0"));
}

QTEST_GUILESS_MAIN(ExportSegNrrdItkTest)
#include "ExportSegNrrdItkTest.moc"
