// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/SeriesSplit.h"

#include "core/dicom/stack/ApartImage.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <functional>

namespace seriesSplitTest {

using core::ImageHeader;

namespace {

ImageHeader slice(int k)
{
    ImageHeader image;
    image.file = QString::number(k);
    image.imageType = QStringList{QStringLiteral("ORIGINAL"), QStringLiteral("PRIMARY")};
    image.layout = {.columns = 8, .rows = 6, .bitsAllocated = 16};
    image.layout.photometric = QStringLiteral("MONOCHROME2");
    image.identity.frameOfReferenceUid = QStringLiteral("1.2");
    image.position = glm::dvec3(0.0, 0.0, 2.0 * k);
    image.plane = core::ImagePlane();
    image.spacing = glm::dvec2(0.7, 0.9);
    return image;
}

using Change = std::function<void(ImageHeader& image)>;

} // namespace

} // namespace seriesSplitTest

Q_DECLARE_METATYPE(seriesSplitTest::Change)

namespace seriesSplitTest {

/// What parts a series and what does not, and which images are no slices.
class SeriesSplitTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void partsAndDoesNotPart_data();
    void partsAndDoesNotPart();
    void aFrameOfReferencePerSliceSaysNothing();
    void noSlicesAreNamed_data();
    void noSlicesAreNamed();
};

void SeriesSplitTest::partsAndDoesNotPart_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<int>("groups");
    const auto row = [](const char* name, int groups, const Change& change) {
        QTest::newRow(name) << change << groups;
    };
    row("plane", 2, [](ImageHeader& image) {
        image.plane = core::ImagePlane{{0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};
    });
    row("plane turned by more than rounding", 2,
        [](ImageHeader& image) { image.plane->row = glm::normalize(glm::dvec3(1.0, 3e-4, 0.0)); });
    row("plane as rounded", 1,
        [](ImageHeader& image) { image.plane->row = glm::normalize(glm::dvec3(1.0, 3e-5, 0.0)); });
    row("rows", 2, [](ImageHeader& image) { image.layout.rows = 7; });
    row("columns", 2, [](ImageHeader& image) { image.layout.columns = 9; });
    row("pixel spacing", 2, [](ImageHeader& image) { image.spacing->y = 0.91; });
    row("pixel spacing as rounded", 1, [](ImageHeader& image) { image.spacing->y = 0.90001; });
    row("frame of reference", 2,
        [](ImageHeader& image) { image.identity.frameOfReferenceUid = QStringLiteral("1.3"); });
    row("stack", 2, [](ImageHeader& image) { image.stackId = QStringLiteral("2"); });
    // Differ within volumes (DICOM.md 1.3).
    row("thickness", 1, [](ImageHeader& image) { image.sliceThickness = 9.0; });
    row("slope", 1, [](ImageHeader& image) { image.slope = 3.0; });
    row("bits", 1, [](ImageHeader& image) { image.layout.bitsStored = 10; });
    row("bits beyond 16", 2, [](ImageHeader& image) { image.layout.bitsAllocated = 32; });
    row("image type", 1, [](ImageHeader& image) { image.imageType.append(QStringLiteral("ADD")); });
    row("instance number", 1, [](ImageHeader& image) { image.instanceNumber = 9000; });
}

void SeriesSplitTest::partsAndDoesNotPart()
{
    QFETCH(Change, change);
    QFETCH(int, groups);
    std::vector<ImageHeader> images;
    for (int k = 0; k < 6; ++k) {
        images.push_back(slice(k));
        if (k >= 4)
            change(images.back());
    }
    const auto split = core::splitSeries(images);
    QCOMPARE(int(split.size()), groups);
    QCOMPARE(split.front().size(), std::size_t(groups == 1 ? 6 : 4));
    QCOMPARE(split.front()[3].file, QStringLiteral("3"));
}

void SeriesSplitTest::aFrameOfReferencePerSliceSaysNothing()
{
    std::vector<ImageHeader> images;
    for (int k = 0; k < 4; ++k) {
        images.push_back(slice(k));
        images.back().identity.frameOfReferenceUid = QString::number(k);
    }
    QVERIFY(core::framesOfReferenceAreMeaningless(images));
    QCOMPARE(core::splitSeries(images).size(), std::size_t(1));
}

void SeriesSplitTest::noSlicesAreNamed_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const char* kind, const char* reason,
                         const Change& change) {
        QTest::newRow(name) << change << QString::fromLatin1(kind) << QString::fromLatin1(reason);
    };
    row("localizer", "localizer", "LOCALIZER",
        [](ImageHeader& image) { image.imageType.append(QStringLiteral("LOCALIZER")); });
    row("survey", "localizer", "REF_SURVIEW",
        [](ImageHeader& image) { image.imageType.append(QStringLiteral("REF_SURVIEW")); });
    row("mosaic", "mosaic", "tiled",
        [](ImageHeader& image) { image.imageType.append(QStringLiteral("MOSAIC")); });
    row("colour", "colour image", "RGB", [](ImageHeader& image) {
        image.layout.samplesPerPixel = 3;
        image.layout.photometric = QStringLiteral("RGB");
    });
    row("palette", "colour image", "PALETTE COLOR",
        [](ImageHeader& image) { image.layout.photometric = QStringLiteral("PALETTE COLOR"); });
    row("film of colour", "colour image", "30 frames", [](ImageHeader& image) {
        image.layout.samplesPerPixel = 3;
        image.frames = 30;
    });
    row("no position", "image without a place", "no position in",
        [](ImageHeader& image) { image.position.reset(); });
    row("no place at all", "image without a place", "no position or orientation",
        [](ImageHeader& image) {
            image.position.reset();
            image.plane.reset();
        });
    row("no scale", "image without a scale", "pixel spacing",
        [](ImageHeader& image) { image.spacing.reset(); });
    row("film", "multi-frame image", "its 10 frames", [](ImageHeader& image) {
        image.frames = 10;
        image.framesUnplaced = true;
    });
}

void SeriesSplitTest::noSlicesAreNamed()
{
    QFETCH(Change, change);
    QFETCH(QString, kind);
    QFETCH(QString, reason);
    ImageHeader image = slice(0);
    QVERIFY(!core::whyApart(image));
    change(image);
    const std::optional<core::ApartImage> why = core::whyApart(image);
    QVERIFY(why);
    QCOMPARE(why->kind.english(), kind);
    QVERIFY2(why->kind.form() != nullptr, "ui could not word it");
    QVERIFY2(why->reason.contains(reason), qPrintable(why->reason));
}

BURIN_TEST(SeriesSplitTest)

} // namespace seriesSplitTest

#include "SeriesSplitTest.moc"
