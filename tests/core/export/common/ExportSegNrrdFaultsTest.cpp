// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckExport.h"
#include "core/nrrd/NrrdHeader.h"
#include "core/nrrd/NrrdReader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SmallSeries.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <random>

namespace exportSegNrrdFaultsTest {

/// Faults put into a written .seg.nrrd: each must be named by the check, as those of
/// ExportFaultsTest.
class ExportSegNrrdFaultsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void faultInTheFileIsCaught_data();
    void faultInTheFileIsCaught();

private:
    QTemporaryDir m_folder;
    core::Volume m_volume;
    std::vector<std::uint8_t> m_labels;
    std::vector<core::LabelPlaneView> m_planes;
    std::vector<core::Segment> m_segments;
};

namespace {

using Alter = std::function<void(QByteArray& header, QByteArray& voxels)>;

/// Alters a header and its voxels; the latter are left unpacked.
void alter(const QString& file, const Alter& change)
{
    const auto header = core::readNrrdHeader(file);
    const auto grid = core::readNrrd(file);
    QVERIFY(header && grid);
    const auto read = core::readVoxels(grid->voxels, {});
    QVERIFY(read);
    QByteArray words = header->bytes;
    QByteArray voxels(read->data.get(), qsizetype(read->size));
    words.replace("encoding: gzip", "encoding: raw");
    change(words, voxels);
    QFile opened(file);
    QVERIFY(opened.open(QIODevice::WriteOnly | QIODevice::Truncate));
    QVERIFY(opened.write(words + voxels) == words.size() + voxels.size());
}

} // namespace

} // namespace exportSegNrrdFaultsTest

Q_DECLARE_METATYPE(exportSegNrrdFaultsTest::Alter)

namespace exportSegNrrdFaultsTest {

void ExportSegNrrdFaultsTest::initTestCase()
{
    test::SmallSeries series;
    series.size = {11, 7, 6};
    series.spacing = {0.7, 0.9};
    series.placeEvenly({-40.25, -31.5, 812.125}, {0, 0, 2.5});
    m_volume = series.write(m_folder.filePath(QStringLiteral("images")));
    std::mt19937 random(5);
    m_labels.resize(m_volume.geometry.voxelCount());
    for (auto& label : m_labels)
        label = std::uint8_t(random() % 3);
    m_planes = {{.plane = 0, .labels = m_labels}};
    for (const int label : {1, 2}) {
        core::Segment segment;
        segment.label = std::uint8_t(label);
        segment.name = QStringLiteral("Skull");
        segment.rgb = label == 1 ? 0xff8000 : 0x0000ff;
        segment.code = {.scheme = QStringLiteral("SCT"),
            .value = QStringLiteral("89546000"),
            .meaning = QStringLiteral("Skull")};
        m_segments.push_back(segment);
    }
}

void ExportSegNrrdFaultsTest::faultInTheFileIsCaught_data()
{
    QTest::addColumn<Alter>("change");
    const auto word = [](const char* name, const QByteArray& from, const QByteArray& to) {
        QTest::newRow(name) << Alter([from, to](QByteArray& header, QByteArray&) {
            QVERIFY2(header.contains(from), header.constData());
            header.replace(from, to);
        });
    };
    word("flip of columns", "(0.69999999999999996,0,0)", "(-0.69999999999999996,0,0)");
    word("flip of rows", "(0,0.90000000000000002,0)", "(0,-0.90000000000000002,0)");
    word("flip of slices", "(0,0,2.5)", "(0,0,-2.5)");
    word("flip of slices about the middle",
        "(0,0,2.5)\nkinds: domain domain domain\n"
        "encoding: raw\nspace origin: (-40.25,-31.5,812.125)",
        "(0,0,-2.5)\nkinds: domain domain domain\nencoding: raw\nspace origin: "
        "(-40.25,-31.5,824.625)");
    word("half a column", "(-40.25,", "(-39.9,");
    word("half a row", ",-31.5,", ",-31.05,");
    word("half a slice", ",812.125)", ",813.375)");
    word("a hundredth of a millimetre", "(-40.25,", "(-40.26,");
    word("spacings swapped", "(0.69999999999999996,0,0) (0,0.90000000000000002,0)",
        "(0.90000000000000002,0,0) (0,0.69999999999999996,0)");
    word("another space", "left-posterior-superior", "right-anterior-superior");
    word("no space of the patient", "left-posterior-superior", "3D-right-handed");
    word("rows and columns exchanged", "sizes: 11 7 6", "sizes: 7 11 6");
    word("signed voxels", "type: unsigned char", "type: signed char");
    word("another name", "Segment0_Name:=Skull", "Segment0_Name:=Scull");
    word("no name", "Segment1_Name:=Skull\n", "");
    word("another colour", "Segment0_Color:=1 ", "Segment0_Color:=0.99 ");
    word("colours exchanged", "Segment0_Color:=1 0.501961 0", "Segment0_Color:=0 0.501961 1");
    word("no number as colour", "Segment0_Color:=1 ", "Segment0_Color:=one ");
    word("two numbers as colour", "Segment0_Color:=1 ", "Segment0_Color:=");
    word("labels exchanged", "Segment0_LabelValue:=1", "Segment0_LabelValue:=2");
    word("another layer", "Segment1_Layer:=0", "Segment1_Layer:=1");
    word("another extent", "Segment0_Extent:=0 10", "Segment0_Extent:=1 10");
    word("another code", "Segment0_Tags:=Term", "Segment0_Tags:=Other");
    word("another meaning", "^89546000^Skull", "^89546000^Liver");
    word("another category", "~SCT^85756007^Tissue~", "~SCT^123037004^Anatomical Structure~");
    word("another side", "~SCT^7771000^Left~", "~SCT^24028007^Right~");
    word("no side", "~SCT^7771000^Left~", "~^^~");
    word("another region", "~SCT^10200004^Liver~", "~SCT^78961009^Spleen~");
    word("no part of the region", "~SCT^24028007^Right|", "~^^|");
    word("one part less", "~SCT^24028007^Right|", "|");
    word("a side that no segment has", "~SCT^89546000^Skull~^^~",
        "~SCT^89546000^Skull~SCT^7771000^Left~");
    word("one ID twice", "Segment_2", "Segment_1");
    word("a segment more", "Segment0_ID:=", "Segment2_ID:=Segment_3\nSegment0_ID:=");
    word("another representation", "MasterRepresentation:=Binary labelmap",
        "MasterRepresentation:=Closed surface");
    word("an offset", "ExtentOffset:=0 0 0", "ExtentOffset:=0 1 0");
    QTest::newRow("one voxel") << Alter(
        [](QByteArray&, QByteArray& voxels) { voxels[200] = char(voxels[200] + 1); });
    QTest::newRow("labels exchanged in the voxels") << Alter([](QByteArray&, QByteArray& all) {
        for (char& voxel : all)
            voxel = voxel == 0 ? voxel : char(3 - voxel);
    });
    QTest::newRow("a byte more") << Alter([](QByteArray&, QByteArray& voxels) { voxels += '\0'; });
}

void ExportSegNrrdFaultsTest::faultInTheFileIsCaught()
{
    QFETCH(Alter, change);
    const QString file = m_folder.filePath(QStringLiteral("mask.seg.nrrd"));
    // The first segment has all codes that there are, the second one its type alone.
    const auto code = [](const char* value, const char* meaning) {
        return core::CodedConcept{.scheme = QStringLiteral("SCT"),
            .value = QLatin1String(value),
            .meaning = QLatin1String(meaning)};
    };
    const std::map<int, core::SegCodes> codes{{1,
        {.category = code("85756007", "Tissue"),
            .modifier = code("7771000", "Left"),
            .region = code("10200004", "Liver"),
            .regionModifier = code("24028007", "Right")}}};
    QVERIFY(core::exportMask(m_volume,
        {.format = core::ExportFormat::SegNrrd,
            .file = file,
            .force = true,
            .segments = m_segments,
            .planes = m_planes,
            .seg = {.codes = codes}},
        {}));
    const core::ExportExpectation expected{
        .volume = m_volume, .segments = m_segments, .planes = m_planes, .segmentCodes = codes};
    // The way through the test alone is no fault.
    alter(file, [](QByteArray&, QByteArray&) {});
    QVERIFY(core::checkSegNrrdExport(file, expected, {}));
    alter(file, change);
    const auto checked = core::checkSegNrrdExport(file, expected, {});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, core::ErrorCode::ExportMismatch);
    QCOMPARE(checked.error().arguments.value(0), file);
    QVERIFY(!checked.error().arguments.value(1).isEmpty());
}

BURIN_TEST(ExportSegNrrdFaultsTest)

} // namespace exportSegNrrdFaultsTest

#include "ExportSegNrrdFaultsTest.moc"
