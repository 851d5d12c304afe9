// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/Rle.h"
#include "core/dicom/base/TransferSyntax.h"
#include "core/dicom/codecs/Jpeg2000.h"
#include "core/dicom/codecs/JpegCheck.h"
#include "core/dicom/codecs/StoredBits.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <random>

namespace compressedPixelsTest {

namespace {

using Bytes = std::vector<std::uint8_t>;

core::PixelLayout layoutOf(int allocated, int stored, int highBit, bool isSigned)
{
    return {.columns = 4,
        .rows = 2,
        .bitsAllocated = allocated,
        .bitsStored = stored,
        .highBit = highBit,
        .isSigned = isSigned,
        .photometric = {}};
}

Bytes rleFrame(const std::vector<Bytes>& segments)
{
    Bytes frame(64, 0);
    frame[0] = std::uint8_t(segments.size());
    for (std::size_t segment = 0; segment < segments.size(); ++segment) {
        frame[4 + 4 * segment] = std::uint8_t(frame.size());
        frame.insert(frame.end(), segments[segment].begin(), segments[segment].end());
    }
    return frame;
}

/// A JPEG header of one component, then whatever is asked for.
Bytes jpeg(int columns, int rows, const Bytes& scan)
{
    Bytes stream{0xff, 0xd8, 0xff, 0xc3, 0, 11, 16, std::uint8_t(rows >> 8), std::uint8_t(rows),
        std::uint8_t(columns >> 8), std::uint8_t(columns), 1, 1, 0x11, 0, 0xff, 0xda, 0, 8, 1, 1, 0,
        1, 0, 0};
    stream.insert(stream.end(), scan.begin(), scan.end());
    return stream;
}

} // namespace

/// What stands between a file's bytes and a decoder.
class CompressedPixelsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void storedBitsAreCutAndExtended_data();
    void storedBitsAreCutAndExtended();
    void rleUnpacks();
    void rleRefusesDamage();
    void rleSurvivesNoise();
    void jpegHeaderMustAgree();
    void jpegMarkersThatHangAreRefused();
    void jpeg2000RefusesNoise();
    void unknownSyntaxIsUnknown();
};

void CompressedPixelsTest::storedBitsAreCutAndExtended_data()
{
    QTest::addColumn<int>("allocated");
    QTest::addColumn<int>("stored");
    QTest::addColumn<int>("highBit");
    QTest::addColumn<bool>("isSigned");
    QTest::addColumn<int>("cell");
    QTest::addColumn<int>("value");
    QTest::newRow("all 16") << 16 << 16 << 15 << false << 0xfedc << 0xfedc;
    QTest::newRow("signed 16") << 16 << 16 << 15 << true << 0xfedc << -292;
    QTest::newRow("12, dirty") << 16 << 12 << 11 << false << 0xf123 << 0x123;
    QTest::newRow("signed 12, negative, dirty") << 16 << 12 << 11 << true << 0x5fff << -1;
    QTest::newRow("signed 12, positive, dirty") << 16 << 12 << 11 << true << 0xf7ff << 2047;
    QTest::newRow("15 signed") << 16 << 15 << 14 << true << 0x4000 << -16384;
    QTest::newRow("12 on top") << 16 << 12 << 15 << false << 0x123f << 0x123;
    QTest::newRow("signed 12 on top") << 16 << 12 << 15 << true << 0x8007 << -2048;
    QTest::newRow("8") << 8 << 8 << 7 << false << 0xff << 255;
    QTest::newRow("signed 8") << 8 << 8 << 7 << true << 0xff << -1;
    QTest::newRow("signed 5 of 8, dirty") << 8 << 5 << 4 << true << 0xf0 << -16;
    QTest::newRow("1 bit") << 8 << 1 << 0 << false << 0xff << 1;
}

void CompressedPixelsTest::storedBitsAreCutAndExtended()
{
    QFETCH(int, allocated);
    QFETCH(int, stored);
    QFETCH(int, highBit);
    QFETCH(bool, isSigned);
    QFETCH(int, cell);
    QFETCH(int, value);
    Bytes cells{std::uint8_t(cell), std::uint8_t(cell >> 8)};
    cells.resize(std::size_t(allocated) / 8);
    std::uint16_t out = 0;
    core::extractStoredBits(cells, layoutOf(allocated, stored, highBit, isSigned), {&out, 1});
    QCOMPARE(isSigned ? int(std::int16_t(out)) : int(out), value);
}

void CompressedPixelsTest::rleUnpacks()
{
    // High bytes: three times 1, then 2; low bytes: 5 6 literally, then twice 7; -128 does nothing.
    const Bytes frame =
        rleFrame({{std::uint8_t(-2), 1, 0, 2}, {std::uint8_t(-128), 1, 5, 6, std::uint8_t(-1), 7}});
    Bytes cells(8);
    QVERIFY(core::decodeRle(frame, 2, cells));
    QCOMPARE(cells, (Bytes{5, 1, 6, 1, 7, 1, 7, 2}));
}

void CompressedPixelsTest::rleRefusesDamage()
{
    Bytes cells(8);
    const Bytes sound = rleFrame({{std::uint8_t(-3), 1}, {std::uint8_t(-3), 2}});
    QVERIFY(core::decodeRle(sound, 2, cells));
    QVERIFY(!core::decodeRle({}, 2, cells));
    QVERIFY(!core::decodeRle(std::span(sound).first(63), 2, cells));
    QVERIFY(!core::decodeRle(std::span(sound).first(sound.size() - 1), 2, cells));
    QVERIFY(!core::decodeRle(sound, 1, cells));
    Bytes beyond = sound;
    beyond[8] = 0xff;
    QVERIFY(!core::decodeRle(beyond, 2, cells));
    beyond[11] = 0xff;
    QVERIFY(!core::decodeRle(beyond, 2, cells));
    Bytes intoHeader = sound;
    intoHeader[4] = 0;
    QVERIFY(!core::decodeRle(intoHeader, 2, cells));
}

void CompressedPixelsTest::rleSurvivesNoise()
{
    std::mt19937 random(7);
    const Bytes sound = rleFrame({{std::uint8_t(-3), 1, 3, 1, 2, 3, 4}, {std::uint8_t(-7), 2}});
    for (int round = 0; round < 20000; ++round) {
        Bytes noisy = sound;
        noisy.resize(64 + random() % 16);
        for (int change = 0; change < 3; ++change)
            noisy[random() % noisy.size()] = std::uint8_t(random());
        Bytes cells(8);
        (void)core::decodeRle(noisy, 2, cells);
    }
}

void CompressedPixelsTest::jpegHeaderMustAgree()
{
    const core::PixelLayout layout = layoutOf(16, 16, 15, false);
    const Bytes scan{0x12, 0xff, 0x00, 0x34, 0xff, 0xd9};
    QCOMPARE(core::checkJpeg(jpeg(4, 2, scan), layout).wrong, QString());
    QCOMPARE(core::checkJpeg(jpeg(4, 2, scan), layout).precision, 16);
    QVERIFY(core::checkJpeg(jpeg(5, 2, scan), layout).wrong.contains(QStringLiteral("5 ×")));
    QVERIFY(!core::checkJpeg(jpeg(4, 20000, scan), layout).wrong.isEmpty());
    Bytes threeComponents = jpeg(4, 2, scan);
    threeComponents[11] = 3;
    QVERIFY(!core::checkJpeg(threeComponents, layout).wrong.isEmpty());
    Bytes twoFrames = jpeg(4, 2, scan);
    const Bytes frame(twoFrames.begin() + 2, twoFrames.begin() + 15);
    twoFrames.insert(twoFrames.begin() + 2, frame.begin(), frame.end());
    QVERIFY(!core::checkJpeg(twoFrames, layout).wrong.isEmpty());
    QVERIFY(!core::checkJpeg(Bytes{0xff, 0xd8, 0xff}, layout).wrong.isEmpty());
    QVERIFY(!core::checkJpeg(Bytes(100, 0), layout).wrong.isEmpty());
}

void CompressedPixelsTest::jpegMarkersThatHangAreRefused()
{
    const core::PixelLayout layout = layoutOf(16, 16, 15, false);
    QVERIFY(
        !core::checkJpeg(jpeg(4, 2, {0x12, 0xff, 0x01, 0x34, 0xff, 0xd9}), layout).wrong.isEmpty());
    Bytes early = jpeg(4, 2, {0x12, 0xff, 0xd9});
    const Bytes marker{0xff, 0x01};
    early.insert(early.begin() + 2, marker.begin(), marker.end());
    QVERIFY(!core::checkJpeg(early, layout).wrong.isEmpty());
}

void CompressedPixelsTest::jpeg2000RefusesNoise()
{
    Bytes cells(16);
    const core::PixelLayout layout = layoutOf(16, 16, 15, false);
    QVERIFY(!core::decodeJpeg2000({}, layout, cells).isEmpty());
    std::mt19937 random(3);
    Bytes noise(500);
    for (std::uint8_t& byte : noise)
        byte = std::uint8_t(random());
    QVERIFY(!core::decodeJpeg2000(noise, layout, cells).isEmpty());
}

void CompressedPixelsTest::unknownSyntaxIsUnknown()
{
    QVERIFY(core::transferSyntax(QStringLiteral("1.2.840.10008.1.2.4.110")).coding
        == core::PixelCoding::Unknown);
    QVERIFY(core::transferSyntax(QString()).coding == core::PixelCoding::Unknown);
    QVERIFY(core::transferSyntax(QStringLiteral("1.2.840.10008.1.2.2")).bigEndian);
}

BURIN_TEST(CompressedPixelsTest)

} // namespace compressedPixelsTest

#include "CompressedPixelsTest.moc"
