// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/AlterDicom.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SyntheticSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QCryptographicHash>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace storedValuesTest {

using core::VolumeProblem;
using test::SyntheticSeries;

namespace {

QByteArray sha256(const SyntheticSeries& series)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (int k = 0; k < series.size.z; ++k) {
        for (int j = 0; j < series.size.y; ++j) {
            for (int i = 0; i < series.size.x; ++i) {
                const auto value = float(series.value({i, j, k}));
                hash.addData(QByteArrayView(reinterpret_cast<const char*>(&value), sizeof(value)));
            }
        }
    }
    return hash.result().toHex();
}

} // namespace

/// Series made to order: the numbers of the file, in every way that DICOM stores them.
class StoredValuesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void opensWhatWasWritten_data();
    void opensWhatWasWritten();
    void eightBitsAreWidened_data();
    void eightBitsAreWidened();
    void eightBitsElsewhereAreRefused();
    void highBitLeavesRoomForTheStoredBits_data();
    void highBitLeavesRoomForTheStoredBits();
    void valuesBeyondTheStoredBitsAreTold_data();
    void valuesBeyondTheStoredBitsAreTold();
    void rescalePerSliceIsOnACommonScale();
    void negativeSlopeKeepsTheOrderOfValues();
    void invertedDisplayLeavesValues();
    void windowComesFromTheFileWhereValid();
    void unitIsHounsfieldOnlyForCt();

private:
    [[nodiscard]] QString path(const QString& name = QStringLiteral("series")) const
    {
        return m_folder->filePath(name);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void StoredValuesTest::opensWhatWasWritten_data()
{
    QTest::addColumn<int>("allocated");
    QTest::addColumn<int>("stored");
    QTest::addColumn<int>("highBit");
    QTest::addColumn<bool>("isSigned");
    QTest::addColumn<bool>("dirty");
    QTest::addColumn<QString>("syntax");
    const char* implicitLe = "1.2.840.10008.1.2";
    const char* explicitLe = "1.2.840.10008.1.2.1";
    const char* deflated = "1.2.840.10008.1.2.1.99";
    const char* explicitBe = "1.2.840.10008.1.2.2";
    const char* rle = "1.2.840.10008.1.2.5";
    const char* lossless = "1.2.840.10008.1.2.4.70";
    const char* jpegLs = "1.2.840.10008.1.2.4.80";
    const auto row = [](const char* name, int allocated, int stored, int highBit, bool isSigned,
                         bool dirty, const char* syntax) {
        QTest::newRow(name) << allocated << stored << highBit << isSigned << dirty
                            << QString::fromLatin1(syntax);
    };
    row("12 of 16", 16, 12, 11, false, false, explicitLe);
    row("12 of 16, implicit", 16, 12, 11, false, false, implicitLe);
    row("12 of 16, big endian", 16, 12, 11, false, false, explicitBe);
    row("12 of 16, deflated", 16, 12, 11, false, false, deflated);
    row("signed 12, dirty", 16, 12, 11, true, true, explicitLe);
    row("signed 12, dirty, big endian", 16, 12, 11, true, true, explicitBe);
    row("unsigned 12 on top, dirty", 16, 12, 15, false, true, explicitLe);
    row("signed 12 in the middle, dirty", 16, 12, 13, true, true, explicitLe);
    row("signed 16", 16, 16, 15, true, false, explicitLe);
    row("unsigned 16", 16, 16, 15, false, false, explicitLe);
    row("8 bits", 8, 8, 7, false, false, explicitLe);
    row("8 bits, big endian", 8, 8, 7, false, false, explicitBe);
    row("signed 8 bits", 8, 8, 7, true, false, explicitLe);
    row("6 of 8 bits, dirty", 8, 6, 5, false, true, explicitLe);
    row("RLE", 16, 12, 11, false, false, rle);
    row("RLE, dirty, signed", 16, 12, 11, true, true, rle);
    row("RLE, 8 bits", 8, 8, 7, false, false, rle);
    row("JPEG lossless", 16, 12, 11, false, false, lossless);
    row("JPEG lossless, 16 bits", 16, 16, 15, false, false, lossless);
    row("JPEG lossless, signed", 16, 16, 15, true, false, lossless);
    row("JPEG-LS", 16, 12, 11, false, false, jpegLs);
    row("JPEG-LS, 16 bits", 16, 16, 15, false, false, jpegLs);
    row("JPEG-LS, signed", 16, 16, 15, true, false, jpegLs);
    row("JPEG-LS, 8 bits", 8, 8, 7, false, false, jpegLs);
}

void StoredValuesTest::opensWhatWasWritten()
{
    QFETCH(int, allocated);
    QFETCH(int, stored);
    QFETCH(int, highBit);
    QFETCH(bool, isSigned);
    QFETCH(bool, dirty);
    QFETCH(QString, syntax);
    SyntheticSeries series;
    series.layout.bitsAllocated = allocated;
    series.layout.bitsStored = stored;
    series.layout.highBit = highBit;
    series.layout.isSigned = isSigned;
    series.dirtySpareBits = dirty;
    series.transferSyntaxUid = syntax;
    const int range = 1 << stored;
    series.stored = [=](const glm::ivec3& index) {
        const int value = (index.x * 977 + index.y * 3931 + index.z * 211) % range;
        return isSigned ? value - range / 2 : value;
    };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QCOMPARE(loaded.volume.encoding.maxError, 0.0);
    QCOMPARE(test::worstError(loaded, series), 0.0);
    QCOMPARE(loaded.volume.voxelsSha256, sha256(series));
    // What is in bits above is no part of the value, but may be meant as one.
    const bool isCutOff = dirty && highBit + 1 < allocated;
    QCOMPARE(loaded.volume.problems.size(), std::size_t(isCutOff ? 1 : 0));
    QCOMPARE(loaded.volume.needsCaution(), isCutOff);
}

void StoredValuesTest::eightBitsAreWidened_data()
{
    QTest::addColumn<QString>("syntax");
    QTest::addColumn<bool>("isSigned");
    QTest::addColumn<int>("stored");
    const auto row = [](const char* name, const char* syntax, bool isSigned, int stored) {
        QTest::newRow(name) << QString::fromLatin1(syntax) << isSigned << stored;
    };
    row("JPEG baseline", "1.2.840.10008.1.2.4.50", false, 8);
    row("JPEG extended", "1.2.840.10008.1.2.4.51", false, 8);
    row("JPEG extended, 12 bits stored", "1.2.840.10008.1.2.4.51", false, 12);
    row("JPEG lossless", "1.2.840.10008.1.2.4.57", false, 8);
    row("JPEG lossless, 16 bits stored", "1.2.840.10008.1.2.4.57", false, 16);
    row("JPEG lossless, first order", "1.2.840.10008.1.2.4.70", false, 8);
    row("JPEG lossless, first order, signed", "1.2.840.10008.1.2.4.70", true, 8);
    row("JPEG lossless, first order, signed, 12 bits stored", "1.2.840.10008.1.2.4.70", true, 12);
    row("JPEG-LS", "1.2.840.10008.1.2.4.80", false, 8);
    row("JPEG-LS, signed", "1.2.840.10008.1.2.4.80", true, 8);
    row("JPEG-LS, near lossless", "1.2.840.10008.1.2.4.81", false, 8);
}

/// The stream has one byte for each pixel, and the header allocates two.
void StoredValuesTest::eightBitsAreWidened()
{
    QFETCH(QString, syntax);
    QFETCH(bool, isSigned);
    QFETCH(int, stored);
    SyntheticSeries series;
    series.layout.bitsAllocated = 8;
    series.layout.bitsStored = 8;
    series.layout.highBit = 7;
    series.layout.isSigned = isSigned;
    series.transferSyntaxUid = syntax;
    series.stored = [=](const glm::ivec3& index) {
        return (index.x * 7 + index.y * 3 + index.z * 5) % 256 - (isSigned ? 128 : 0);
    };
    const QStringList files = test::writeSeries(series, path());
    const core::LoadedVolume narrow = test::openVolume(path());
    for (const QString& file : files) {
        test::alterDicom(file, [=](DcmDataset& set) {
            set.putAndInsertUint16(DCM_BitsAllocated, 16);
            set.putAndInsertUint16(DCM_BitsStored, Uint16(stored));
            set.putAndInsertUint16(DCM_HighBit, Uint16(stored - 1));
        });
    }
    const core::LoadedVolume wide = test::openVolume(path());
    QCOMPARE(wide.volume.geometry.size, series.size);
    QCOMPARE(wide.volume.voxelsSha256, narrow.volume.voxelsSha256);
    QVERIFY(wide.volume.maximum > wide.volume.minimum + 100.0);
}

void StoredValuesTest::eightBitsElsewhereAreRefused()
{
    SyntheticSeries series;
    series.layout.bitsAllocated = 8;
    series.layout.bitsStored = 8;
    series.layout.highBit = 7;
    series.stored = [](const glm::ivec3& index) { return index.x; };
    series.transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.4.70");
    for (const QString& file : test::writeSeries(series, path())) {
        test::alterDicom(file, [](DcmDataset& set) {
            set.putAndInsertUint16(DCM_BitsAllocated, 16);
            set.putAndInsertUint16(DCM_HighBit, 15);
        });
    }
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(path());
    QVERIFY(!loaded);
    const QString why = loaded.error().arguments.value(1);
    QVERIFY2(why.contains(QLatin1String("8 bits up to bit 15")), qPrintable(why));
}

void StoredValuesTest::highBitLeavesRoomForTheStoredBits_data()
{
    QTest::addColumn<int>("stored");
    QTest::addColumn<int>("highBit");
    QTest::addColumn<QString>("syntax");
    const QString explicitLe = QStringLiteral("1.2.840.10008.1.2.1");
    QTest::newRow("16 bits below bit 11") << 16 << 11 << explicitLe;
    QTest::newRow("12 bits below bit 7") << 12 << 7 << explicitLe;
    QTest::newRow("12 bits, bit 0") << 12 << 0 << explicitLe;
    QTest::newRow("JPEG lossless") << 16 << 11 << QStringLiteral("1.2.840.10008.1.2.4.70");
}

void StoredValuesTest::highBitLeavesRoomForTheStoredBits()
{
    QFETCH(int, stored);
    QFETCH(int, highBit);
    QFETCH(QString, syntax);
    SyntheticSeries series;
    series.layout.bitsStored = stored;
    series.layout.highBit = stored - 1;
    series.transferSyntaxUid = syntax;
    series.stored = [=](const glm::ivec3& index) {
        return (index.x * 977 + index.y * 3931 + index.z * 211) % (1 << stored);
    };
    for (const QString& file : test::writeSeries(series, path())) {
        test::alterDicom(
            file, [=](DcmDataset& set) { set.putAndInsertUint16(DCM_HighBit, Uint16(highBit)); });
    }
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    QCOMPARE(test::worstError(loaded, series), 0.0);
    QCOMPARE(test::problemText(loaded.volume.problems, VolumeProblem::Kind::Other),
        QStringLiteral("The files name bit %1 as the highest of %2 stored bits, which cannot be; "
                       "bit %3 is taken.")
            .arg(highBit)
            .arg(stored)
            .arg(stored - 1));
    QVERIFY(!loaded.volume.needsCaution());
}

void StoredValuesTest::valuesBeyondTheStoredBitsAreTold_data()
{
    QTest::addColumn<bool>("isSigned");
    QTest::addColumn<int>("cell");
    QTest::addColumn<int>("overlayBit");
    QTest::addColumn<bool>("told");
    QTest::newRow("a value of 13 bits") << false << 5000 << 0 << true;
    QTest::newRow("padding of -2000, not signed") << false << 63536 << 0 << true;
    QTest::newRow("a value of 12 bits") << false << 4095 << 0 << false;
    QTest::newRow("an extended sign") << true << 0xf830 << 0 << false;
    QTest::newRow("a sign that is not extended") << true << 0x0830 << 0 << false;
    QTest::newRow("positive, and of 13 bits") << true << 0x1000 << 0 << true;
    QTest::newRow("an overlay") << false << 0x8123 << 15 << false;
    QTest::newRow("an overlay elsewhere") << false << 0x8123 << 14 << true;
    QTest::newRow("an extended sign below an overlay") << true << 0x7830 << 15 << false;
}

void StoredValuesTest::valuesBeyondTheStoredBitsAreTold()
{
    QFETCH(bool, isSigned);
    QFETCH(int, cell);
    QFETCH(int, overlayBit);
    QFETCH(bool, told);
    SyntheticSeries series;
    series.layout.isSigned = isSigned;
    series.adjust = [&](DcmDataset& set, int) {
        std::vector<Uint16> cells(std::size_t(series.size.x) * std::size_t(series.size.y), 9);
        cells[7] = Uint16(cell);
        set.putAndInsertUint16Array(DCM_PixelData, cells.data(), cells.size());
        if (overlayBit > 0)
            set.putAndInsertUint16(DcmTagKey(0x6004, 0x0102), Uint16(overlayBit));
    };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(loaded.volume.geometry.size, series.size);
    const int low = cell & 0xfff;
    const int value = isSigned && low >= 2048 ? low - 4096 : low;
    QCOMPARE(test::valueAt(loaded, {7, 0, 0}), value - 1024.0);
    QCOMPARE(loaded.volume.needsCaution(), told);
    QCOMPARE(test::problemText(loaded.volume.problems, VolumeProblem::Kind::Other),
        told ? QStringLiteral("Some pixels hold more bits than their files say they store; what is "
                              "beyond is cut off, so that these values may be wrong.")
             : QString());
}

void StoredValuesTest::rescalePerSliceIsOnACommonScale()
{
    SyntheticSeries series;
    series.modality = QStringLiteral("PT");
    series.slope = [](int k) { return 0.25 + 0.37 * k; };
    series.intercept = [](int) { return 0.0; };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    QVERIFY(loaded.volume.encoding.maxError > 0.0);
    QVERIFY(test::worstError(loaded, series) <= loaded.volume.encoding.maxError);
    QVERIFY(loaded.volume.encoding.maxError <= loaded.volume.maximum / 65535.0);
    QVERIFY(test::hasProblem(loaded.volume.problems, VolumeProblem::Kind::InexactValues));
    QCOMPARE(loaded.volume.voxelsSha256, sha256(series));
    QCOMPARE(loaded.volume.unit, QString());
}

void StoredValuesTest::negativeSlopeKeepsTheOrderOfValues()
{
    SyntheticSeries series;
    series.slope = [](int) { return -0.5; };
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    QCOMPARE(loaded.volume.encoding.maxError, 0.0);
    QVERIFY(loaded.volume.encoding.value(1) > loaded.volume.encoding.value(0));
    QCOMPARE(test::worstError(loaded, series), 0.0);
    QCOMPARE(loaded.volume.voxelsSha256, sha256(series));
}

void StoredValuesTest::invertedDisplayLeavesValues()
{
    SyntheticSeries series;
    series.layout.photometric = QStringLiteral("MONOCHROME1");
    test::writeSeries(series, path());
    const core::LoadedVolume loaded = test::openVolume(path());
    QVERIFY(loaded.volume.displayInverted);
    QCOMPARE(test::worstError(loaded, series), 0.0);
}

void StoredValuesTest::windowComesFromTheFileWhereValid()
{
    SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_WindowCenter, "-0450\\40");
        set.putAndInsertString(DCM_WindowWidth, "+1600\\400");
    };
    test::writeSeries(series, path());
    QCOMPARE(test::openVolume(path()).volume.defaultWindow, (core::WindowLevel{-450.0, 1600.0}));

    // Of fractions, one that is narrower than 1 is meant.
    SyntheticSeries fractions;
    fractions.slope = [](int) { return 0.001; };
    fractions.intercept = [](int) { return 0.0; };
    fractions.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_WindowCenter, "0.5");
        set.putAndInsertString(DCM_WindowWidth, "0.75");
    };
    test::writeSeries(fractions, path(QStringLiteral("fractions")));
    QCOMPARE(test::openVolume(path(QStringLiteral("fractions"))).volume.defaultWindow,
        (core::WindowLevel{0.5, 0.75}));

    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_WindowCenter, "40");
        set.putAndInsertString(DCM_WindowWidth, "0");
    };
    test::writeSeries(series, path(QStringLiteral("invalid")));
    const core::Volume volume = test::openVolume(path(QStringLiteral("invalid"))).volume;
    QVERIFY(volume.defaultWindow.width > 1.0);
    QVERIFY(volume.defaultWindow.centre > volume.minimum);
    QVERIFY(volume.defaultWindow.centre < volume.maximum);
    const std::vector<std::uint32_t>& counts = volume.histogram.counts;
    QCOMPARE(counts.size(), std::size_t(256));
    QCOMPARE(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)),
        std::uint64_t(volume.geometry.voxelCount()));
}

void StoredValuesTest::unitIsHounsfieldOnlyForCt()
{
    SyntheticSeries series;
    test::writeSeries(series, path());
    QCOMPARE(test::openVolume(path()).volume.unit, QStringLiteral("HU"));
    series.modality = QStringLiteral("MR");
    test::writeSeries(series, path(QStringLiteral("mr")));
    QCOMPARE(test::openVolume(path(QStringLiteral("mr"))).volume.unit, QString());
    series.modality = QStringLiteral("CT");
    series.adjust = [](DcmDataset& set, int) { set.putAndInsertString(DCM_RescaleType, "US"); };
    test::writeSeries(series, path(QStringLiteral("us")));
    QCOMPARE(test::openVolume(path(QStringLiteral("us"))).volume.unit, QString());
}

BURIN_TEST(StoredValuesTest)

} // namespace storedValuesTest

#include "StoredValuesTest.moc"
