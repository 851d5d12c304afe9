// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ExportMask.h"
#include "tests/peers/readers/ItkNrrd.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/Affine.h"
#include "tests/support/series/LabelledSeries.h"

#include <QTest>

#include <random>

namespace exportSegNrrdItkTest {

/// A mask for 3D Slicer as the library that it reads with sees it.
class ExportSegNrrdItkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itkSeesTheSame_data() { test::addPlacementRows(false); }
    void itkSeesTheSame();
};

void ExportSegNrrdItkTest::itkSeesTheSame()
{
    QFETCH(QString, placement);
    const test::SeriesPlacement lies = test::placementOf(placement);
    const glm::ivec3 size = lies.series.size;
    std::mt19937 random(3);
    std::vector<std::uint8_t> some(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (auto& label : some)
        label = std::uint8_t(random() % 3);
    const test::LabelledSeries on(lies.series, some);
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
        .file = on.folder.filePath(QStringLiteral("mask.seg.nrrd")),
        .segments = {first, second},
        .planes = on.planes};
    const auto report = core::exportMask(on.volume, request, {});
    QVERIFY2(report.has_value(),
        qPrintable(report ? QString() : report.error().arguments.join(QStringLiteral(" | "))));

    const peer::ItkNrrd read = peer::readItkNrrd(request.file.toStdString());
    QVERIFY2(read.error.empty(), read.error.c_str());
    QVERIFY(read.size == on.volume.geometry.size);
    QVERIFY(test::cornerDistance(read.indexToWorld, on.volume.geometry) < 1e-6);
    QVERIFY(read.voxels == on.labels);
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

BURIN_TEST(ExportSegNrrdItkTest)

} // namespace exportSegNrrdItkTest

#include "ExportSegNrrdItkTest.moc"
