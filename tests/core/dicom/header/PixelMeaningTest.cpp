// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/ModalityLut.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SyntheticSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace pixelMeaningTest {

using test::SyntheticSeries;

namespace {

/// A table as long as the stored values are wide: the squares of its entries' numbers.
void putLut(DcmDataset& set, int first, int entries)
{
    DcmItem* item = nullptr;
    set.findOrCreateSequenceItem(DCM_ModalityLUTSequence, item, 0);
    const Uint16 descriptor[3] = {Uint16(entries), Uint16(first), 16};
    item->putAndInsertUint16Array(DCM_LUTDescriptor, descriptor, 3);
    item->putAndInsertString(DCM_ModalityLUTType, "HU");
    std::vector<Uint16> values;
    for (int entry = 0; entry < entries; ++entry)
        values.push_back(Uint16(entry * entry));
    item->putAndInsertUint16Array(DCM_LUTData, values.data(), values.size());
}

float floatAt(int column, int row, int k)
{
    return 0.25F * float(column) - 1.5F * float(row) + 0.001F * float(k);
}

/// Replaces the pixels of an image by cells of 32 bits, as they are written in a transfer syntax.
void putWideCells(DcmDataset& set, const std::vector<std::uint32_t>& cells, bool bigEndian)
{
    std::vector<Uint16> words;
    for (const std::uint32_t cell : cells) {
        // DCMTK swaps the bytes within words.
        words.push_back(Uint16(bigEndian ? cell >> 16 : cell));
        words.push_back(Uint16(bigEndian ? cell : cell >> 16));
    }
    set.putAndInsertUint16(DCM_BitsAllocated, 32);
    set.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size());
}

} // namespace

/// What stored pixels mean: lookup tables, padding, inverted display, floating-point numbers.
class PixelMeaningTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void lookupTableTakesThePlaceOfTheSlope();
    void lookupTableIsHeldAtItsEnds();
    void damagedLookupTableIsRefusedInWords();
    void noLookupTableInItsSequence_data();
    void noLookupTableInItsSequence();
    void paddingDoesNotCount();
    void imageOfNothingButPaddingCounts();
    void presentationShapeInvertsDisplayOnly();
    void floatingPointPixels();
    void sharedParametricMap();
    void wholeNumbersOf32Bits_data();
    void wholeNumbersOf32Bits();
    void wholeNumbersOf32BitsWithATableAreRefusedInWords();
};

void PixelMeaningTest::lookupTableTakesThePlaceOfTheSlope()
{
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.stored = [](const glm::ivec3& index) { return index.x + index.y + index.z; };
    series.slope = [](int) { return 7.0; };
    series.adjust = [](DcmDataset& set, int) { putLut(set, 0, 60); };
    test::writeSeries(series, folder.path());
    const core::LoadedVolume loaded = test::openVolume(folder.path());
    QCOMPARE(test::valueAt(loaded, {0, 0, 0}), 0.0);
    QCOMPARE(test::valueAt(loaded, {3, 4, 5}), 144.0);
    QCOMPARE(test::valueAt(loaded, {23, 17, 9}), 49.0 * 49.0);
    QCOMPARE(loaded.volume.unit, QStringLiteral("HU"));
}

void PixelMeaningTest::lookupTableIsHeldAtItsEnds()
{
    const core::ModalityLut lut{.first = -2, .values = {10, 20, 30}};
    std::vector<std::uint16_t> stored{
        std::uint16_t(-100), std::uint16_t(-2), std::uint16_t(-1), 0, 1, 900};
    lut.apply(stored, true);
    QCOMPARE(stored, (std::vector<std::uint16_t>{10, 10, 20, 30, 30, 30}));
    // Unsigned, the same bits are great numbers.
    std::vector<std::uint16_t> great{std::uint16_t(-100)};
    lut.apply(great, false);
    QCOMPARE(great.front(), std::uint16_t(30));
}

void PixelMeaningTest::damagedLookupTableIsRefusedInWords()
{
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        putLut(set, 0, 60);
        DcmItem* item = nullptr;
        set.findAndGetSequenceItem(DCM_ModalityLUTSequence, item);
        const Uint16 one = 1;
        item->putAndInsertUint16Array(DCM_LUTData, &one, 1);
    };
    test::writeSeries(series, folder.path());
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(folder.path());
    QVERIFY(!loaded);
    QVERIFY(loaded.error()
                .arguments.join(QLatin1Char(' '))
                .contains(QLatin1String("damaged modality lookup table")));
}

void PixelMeaningTest::noLookupTableInItsSequence_data()
{
    QTest::addColumn<QString>("syntax");
    QTest::newRow("explicit VR") << QStringLiteral("1.2.840.10008.1.2.1");
    QTest::newRow("implicit VR") << QStringLiteral("1.2.840.10008.1.2");
}

/// The sequence is there, without an item: slope and intercept count.
void PixelMeaningTest::noLookupTableInItsSequence()
{
    QFETCH(QString, syntax);
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.transferSyntaxUid = syntax;
    series.slope = [](int) { return 3.0; };
    series.adjust = [](DcmDataset& set, int) {
        QVERIFY(set.insertEmptyElement(DCM_ModalityLUTSequence).good());
    };
    test::writeSeries(series, folder.path());
    const core::LoadedVolume loaded = test::openVolume(folder.path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QCOMPARE(test::worstError(loaded, series), 0.0);
    QCOMPARE(loaded.volume.unit, QStringLiteral("HU"));
}

void PixelMeaningTest::paddingDoesNotCount()
{
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.layout.isSigned = true;
    series.layout.bitsStored = 16;
    series.layout.highBit = 15;
    series.stored = [](const glm::ivec3& index) { return index.x < 4 ? -2000 : 1000 + index.y; };
    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertSint16(DCM_PixelPaddingValue, -1990);
        set.putAndInsertSint16(DCM_PixelPaddingRangeLimit, -2000);
    };
    test::writeSeries(series, folder.path());
    const core::LoadedVolume loaded = test::openVolume(folder.path());
    // Voxels keep their values; what is made from their distribution leaves padding out.
    QCOMPARE(loaded.volume.minimum, -3024.0);
    QCOMPARE(test::valueAt(loaded, {0, 0, 0}), -3024.0);
    QCOMPARE(loaded.volume.histogram.minimum, -24.0);
    QCOMPARE(loaded.volume.histogram.maximum, -7.0);
    std::uint64_t counted = 0;
    for (const std::uint32_t count : loaded.volume.histogram.counts)
        counted += count;
    QCOMPARE(counted, std::uint64_t(20 * 18 * 10));
    QVERIFY(loaded.volume.defaultWindow.width < 20.0);
}

void PixelMeaningTest::imageOfNothingButPaddingCounts()
{
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.stored = [](const glm::ivec3&) { return 0; };
    series.adjust = [](DcmDataset& set, int) { set.putAndInsertUint16(DCM_PixelPaddingValue, 0); };
    test::writeSeries(series, folder.path());
    const core::LoadedVolume loaded = test::openVolume(folder.path());
    QCOMPARE(loaded.volume.histogram.minimum, -1024.0);
    QCOMPARE(loaded.volume.histogram.counts.front(), std::uint32_t(24 * 18 * 10));
}

void PixelMeaningTest::presentationShapeInvertsDisplayOnly()
{
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_PresentationLUTShape, "INVERSE");
    };
    test::writeSeries(series, folder.path());
    const core::LoadedVolume loaded = test::openVolume(folder.path());
    QVERIFY(loaded.volume.displayInverted);
    QCOMPARE(test::worstError(loaded, series), 0.0);
}

void PixelMeaningTest::floatingPointPixels()
{
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.intercept = [](int) { return 0.5; };
    series.slope = [](int) { return 2.0; };
    series.adjust = [&](DcmDataset& set, int k) {
        std::vector<Float32> values;
        for (int row = 0; row < series.size.y; ++row) {
            for (int column = 0; column < series.size.x; ++column)
                values.push_back(floatAt(column, row, k));
        }
        set.findAndDeleteElement(DCM_PixelData);
        set.putAndInsertUint16(DCM_BitsAllocated, 32);
        set.putAndInsertFloat32Array(DCM_FloatPixelData, values.data(), values.size());
    };
    test::writeSeries(series, folder.path());
    const core::LoadedVolume loaded = test::openVolume(folder.path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QVERIFY(loaded.volume.encoding.maxError > 0.0);
    QVERIFY(loaded.volume.encoding.maxError < 1e-3);
    for (const glm::ivec3 index :
        {glm::ivec3(0, 0, 0), glm::ivec3(23, 5, 9), glm::ivec3(4, 17, 3)}) {
        const double expected = 2.0 * double(floatAt(index.x, index.y, index.z)) + 0.5;
        QVERIFY(std::abs(test::valueAt(loaded, index) - expected)
            <= loaded.volume.encoding.maxError + 1e-12);
    }
}

void PixelMeaningTest::sharedParametricMap()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("edge_pixels_colour"));
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::LoadedVolume loaded =
        test::openVolume(data.source + QStringLiteral("/files/parametric_map_float.dcm"));
    QCOMPARE(loaded.volume.geometry.size, glm::ivec3(128, 128, 1));
    QCOMPARE(loaded.volume.minimum, 0.0);
    QVERIFY(std::abs(loaded.volume.maximum - 0.941579) < 1e-6);
    QCOMPARE(loaded.volume.voxelsSha256,
        QByteArray("ef41ff13cf378171c7ee25198c75e2b70764e3789664f17dd6df40163ec37284"));
}

void PixelMeaningTest::wholeNumbersOf32Bits_data()
{
    QTest::addColumn<QString>("syntax");
    QTest::addColumn<int>("stored");
    QTest::addColumn<int>("highBit");
    QTest::addColumn<bool>("isSigned");
    QTest::addColumn<double>("first");
    QTest::addColumn<double>("step");
    const QString explicitLe = QStringLiteral("1.2.840.10008.1.2.1");
    const QString explicitBe = QStringLiteral("1.2.840.10008.1.2.2");
    const QString rle = QStringLiteral("1.2.840.10008.1.2.5");
    const auto row = [](const char* name, const QString& syntax, int stored, int highBit,
                         bool isSigned, double first, double step) {
        QTest::newRow(name) << syntax << stored << highBit << isSigned << first << step;
    };
    row("few values", explicitLe, 32, 31, false, 5e8, 1.0);
    row("few values, implicit", QStringLiteral("1.2.840.10008.1.2"), 32, 31, false, 5e8, 1.0);
    row("few values, big endian", explicitBe, 32, 31, false, 5e8, 1.0);
    row("few values, RLE", rle, 32, 31, false, 5e8, 1.0);
    row("unsigned, all bits", explicitLe, 32, 31, false, 7.0, 994181.0);
    row("signed", explicitLe, 32, 31, true, -2147483648.0, 994181.0);
    row("signed, big endian", explicitBe, 32, 31, true, -2147483648.0, 994181.0);
    row("signed, RLE", rle, 32, 31, true, -2147483648.0, 994181.0);
    row("20 bits, dirty", explicitLe, 20, 19, false, 1000.0, 200.0);
    row("20 bits in the middle, signed, dirty", explicitLe, 20, 27, true, -1000.0, 20.0);
    row("16 bits, big endian, dirty", explicitBe, 16, 15, true, -1000.0, 1.0);
}

void PixelMeaningTest::wholeNumbersOf32Bits()
{
    QFETCH(QString, syntax);
    QFETCH(int, stored);
    QFETCH(int, highBit);
    QFETCH(bool, isSigned);
    QFETCH(double, first);
    QFETCH(double, step);
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.layout.bitsStored = stored;
    series.layout.highBit = highBit;
    series.layout.isSigned = isSigned;
    series.intercept = [](int) { return 0.5; };
    series.slope = [](int) { return 2.0; };
    series.transferSyntaxUid = syntax;
    const auto valueAt = [&](const glm::ivec3& index) {
        const int number = index.x + series.size.x * (index.y + series.size.y * index.z);
        return first + step * number;
    };
    series.adjust = [&](DcmDataset& set, int k) {
        const int shift = highBit + 1 - stored;
        const std::uint32_t mask = (~0u >> (32 - stored)) << shift;
        std::vector<std::uint32_t> cells;
        for (int row = 0; row < series.size.y; ++row) {
            for (int column = 0; column < series.size.x; ++column) {
                const auto value = std::uint32_t(std::int64_t(valueAt({column, row, k})));
                const std::uint32_t dirt = std::uint32_t(column) * 2654435761u & ~mask;
                cells.push_back((value << shift & mask) | dirt);
            }
        }
        putWideCells(set, cells, syntax == QLatin1String("1.2.840.10008.1.2.2"));
    };
    test::writeSeries(series, folder.path());
    const core::LoadedVolume loaded = test::openVolume(folder.path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    const double error = loaded.volume.encoding.maxError;
    const glm::ivec3 last = series.size - 1;
    const double range = 2.0 * (valueAt(last) - first);
    QVERIFY(error <= range / 65535.0);
    for (int k = 0; k <= last.z; ++k) {
        for (int row = 0; row <= last.y; ++row) {
            for (int column = 0; column <= last.x; ++column) {
                const glm::ivec3 index(column, row, k);
                const double wrong = test::valueAt(loaded, index) - (2.0 * valueAt(index) + 0.5);
                QVERIFY(std::abs(wrong) <= error + 1e-6);
            }
        }
    }
}

void PixelMeaningTest::wholeNumbersOf32BitsWithATableAreRefusedInWords()
{
    const QTemporaryDir folder;
    SyntheticSeries series;
    series.adjust = [&](DcmDataset& set, int) {
        putLut(set, 0, 60);
        putWideCells(set, std::vector<std::uint32_t>(24 * 18, 3), false);
    };
    test::writeSeries(series, folder.path());
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(folder.path());
    QVERIFY(!loaded);
    const QString why = loaded.error().arguments.join(QLatin1Char(' '));
    QVERIFY2(why.contains(QLatin1String("32 bits with a modality lookup table")), qPrintable(why));
}

BURIN_TEST(PixelMeaningTest)

} // namespace pixelMeaningTest

#include "PixelMeaningTest.moc"
