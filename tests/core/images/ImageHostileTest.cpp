// SPDX-License-Identifier: Apache-2.0
#include "core/images/TiffDirectory.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/ImageFiles.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/VolumeFiles.h"
#include "ui/texts/ProblemTexts.h"

#include <QDir>
#include <QTest>
#include <QtEndian>

#include <random>

#include <tiff.h>

namespace imageHostileTest {

using core::LoadedVolume;
using core::Result;
using test::picture;
using test::png;
using test::writeTiff;

namespace {

constexpr int columns = 21;
constexpr int rows = 18;
const QString spacing = QStringLiteral("+spacing=1x1x1");

/// A little-endian classic TIFF of one directory, entry by entry.
class TiffBytes {
public:
    void add(quint16 tag, quint32 value, quint32 count = 1, quint16 type = 4)
    {
        append<quint16>(tag);
        append<quint16>(type);
        append<quint32>(count);
        append<quint32>(value);
        ++m_count;
    }
    [[nodiscard]] QByteArray bytes(quint32 next = 0, const QByteArray& behind = {}) const
    {
        QByteArray all("II*\0\x08\0\0\0", 8);
        QByteArray count(2, '\0');
        qToLittleEndian(m_count, count.data());
        QByteArray last(4, '\0');
        qToLittleEndian(next, last.data());
        return all + count + m_entries + last + behind;
    }

private:
    template <class T> void append(T value)
    {
        QByteArray bytes(sizeof(T), '\0');
        qToLittleEndian(value, bytes.data());
        m_entries += bytes;
    }
    QByteArray m_entries;
    quint16 m_count = 0;
};

/// What all of them begin with: 8 bits, grey.
TiffBytes greyTiff(quint32 wide, quint32 high)
{
    TiffBytes tiff;
    tiff.add(256, wide);
    tiff.add(257, high);
    tiff.add(258, 8);
    return tiff;
}

} // namespace

/// Pictures that are damaged, or made to hurt: one sentence, never the program.
class ImageHostileTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void everyCutIsSurvived_data();
    void everyCutIsSurvived();
    void randomBytesAreSurvived();
    void aDamagedPictureCostsItsSlice();
    void dicomThatBeginsLikeATiff();
    void otherFilesByTheName();
    void directoriesThatLie_data();
    void directoriesThatLie();
    void stripsOfALargeFileAreMany();
    void pngThatLies_data();
    void pngThatLies();

private:
    [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }
    QByteArray tiffBytes(const test::TiffOptions& options)
    {
        const QString file = path(QStringLiteral("sound.tif"));
        if (!writeTiff(file, {picture<std::uint16_t>(0, columns, rows)}, options))
            qFatal("no TIFF");
        const QByteArray bytes = test::bytesOf(file);
        QFile::remove(file);
        return bytes;
    }
    /// @return the sentence; empty where it opens
    QString refusal(const QString& name, const QByteArray& bytes)
    {
        const Result<LoadedVolume> loaded = core::loadVolume(put(name, bytes), spacing);
        return loaded ? QString() : test::errorText(loaded.error());
    }
};

void ImageHostileTest::everyCutIsSurvived_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("sound");
    makeFolder();
    const QString tiff = QStringLiteral("cut.tif");
    QTest::addRow("PNG") << QStringLiteral("cut.png")
                         << png(picture<std::uint8_t>(0, columns, rows));
    QTest::addRow("plain") << tiff << tiffBytes({});
    QTest::addRow("LZW, tiles") << tiff << tiffBytes({.compression = COMPRESSION_LZW, .tile = 16});
    QTest::addRow("deflate, BigTIFF")
        << tiff << tiffBytes({.bigTiff = true, .compression = COMPRESSION_ADOBE_DEFLATE});
}

void ImageHostileTest::everyCutIsSurvived()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, sound);
    QCOMPARE(refusal(name, sound), QString());
    const qsizetype step = test::longRun() ? 1 : 7;
    for (qsizetype length = 0; length < sound.size(); length += step) {
        const QString text = refusal(name, sound.left(length));
        QVERIFY2(text.contains(name), qPrintable(QStringLiteral("%1: %2").arg(length).arg(text)));
    }
}

void ImageHostileTest::randomBytesAreSurvived()
{
    const std::array kinds{png(picture<std::uint16_t>(0, columns, rows)), tiffBytes({}),
        tiffBytes({.compression = COMPRESSION_LZW, .predictor = 2}),
        tiffBytes({.bigEndian = true, .compression = COMPRESSION_PACKBITS}),
        tiffBytes({.compression = COMPRESSION_ADOBE_DEFLATE, .tile = 16})};
    std::mt19937 random(5);
    const int rounds = test::longRun() ? 20000 : 500;
    int opened = 0;
    for (int round = 0; round < rounds; ++round) {
        QByteArray bytes = kinds[std::size_t(round) % kinds.size()];
        const int changes = 1 + int(random() % 3);
        for (int change = 0; change < changes && !bytes.isEmpty(); ++change) {
            const auto at = qsizetype(random() % std::size_t(bytes.size()));
            if (random() % 4 == 0)
                bytes.remove(at, qsizetype(random() % 8));
            else
                bytes[at] = char(random());
        }
        opened += refusal(QStringLiteral("changed.tif"), bytes).isEmpty() ? 1 : 0;
    }
    QVERIFY(opened > 0 && opened < rounds);
}

void ImageHostileTest::aDamagedPictureCostsItsSlice()
{
    for (int k = 0; k < 5; ++k)
        put(QStringLiteral("%1.png").arg(k), png(picture<std::uint8_t>(k, columns, rows)));
    // One whose data are damaged, and one whose header is.
    QByteArray damaged = png(picture<std::uint8_t>(1, columns, rows));
    damaged[60] = char(damaged[60] ^ 0x55);
    put(QStringLiteral("1.png"), damaged);
    put(QStringLiteral("3.png"), "nothing of a picture");
    const Result<LoadedVolume> loaded = core::loadVolume(m_folder->path(), spacing);
    QVERIFY2(loaded, qPrintable(loaded ? QString() : test::errorText(loaded.error())));
    QCOMPARE(loaded->volume.geometry.size.z, 5);
    QStringList damages;
    for (const core::VolumeProblem& problem : loaded->volume.problems) {
        if (problem.kind == core::VolumeProblem::Kind::DamagedSlice)
            damages += ui::problemText(problem.said);
    }
    QCOMPARE(damages.size(), 2);
    QVERIFY2(damages[0].startsWith(QLatin1String("Slice 2 (1.png)")), qPrintable(damages[0]));
    QVERIFY2(damages[1].startsWith(QLatin1String("Slice 4 (3.png)")), qPrintable(damages[1]));
    for (int k = 0; k < 5; ++k) {
        const double value = test::valueAt(*loaded, {4, 3, k});
        QCOMPARE(value, k == 1 || k == 3 ? 0.0 : double(test::pixelAt(k, 4, 3) + 60));
    }
}

void ImageHostileTest::dicomThatBeginsLikeATiff()
{
    // Both at once, as PS3.10 7.1 lets a file be: it is DICOM's.
    QByteArray bytes = greyTiff(1, 1).bytes();
    bytes.resize(128);
    bytes += "DICM";
    const QString text = refusal(QStringLiteral("both.tif"), bytes);
    QVERIFY2(!text.isEmpty() && !text.contains(QLatin1String("TIFF")), qPrintable(text));
}

void ImageHostileTest::otherFilesByTheName()
{
    QVERIFY(refusal(QStringLiteral("text.png"), "hello").contains(QLatin1String("not a DICOM")));
    QVERIFY(!refusal(QStringLiteral("empty.tif"), "").isEmpty());
    // What macOS leaves beside a file is no slice.
    makeFolder();
    put(QStringLiteral("a1.png"), png(picture<std::uint8_t>(0, columns, rows)));
    put(QStringLiteral("a2.png"), png(picture<std::uint8_t>(1, columns, rows)));
    put(QStringLiteral("._a1.png"), "\0\x05\x16\x07");
    const Result<LoadedVolume> loaded = core::loadVolume(m_folder->path(), spacing);
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.geometry.size.z, 2);
}

void ImageHostileTest::directoriesThatLie_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const QByteArray& bytes, const char* says) {
        QTest::newRow(name) << bytes << QString::fromUtf8(says);
    };
    const QByteArray pixels(64, 'x');
    TiffBytes large = greyTiff(0xffffffff, 0xffffffff);
    row("huge sides", large.bytes(), "4294967295 × 4294967295 pixels");
    TiffBytes none = greyTiff(0, 0);
    row("no sides", none.bytes(), "0 × 0 pixels");

    TiffBytes bomb = greyTiff(32768, 32768);
    bomb.add(259, COMPRESSION_ADOBE_DEFLATE);
    bomb.add(273, 8);
    bomb.add(279, 60);
    row("more than it can unpack to", bomb.bytes(0, pixels), "incomplete");

    TiffBytes beyond = greyTiff(8, 8);
    beyond.add(273, 0xfffffff0);
    beyond.add(279, 64);
    row("pixels beyond the end", beyond.bytes(0, pixels), "incomplete");

    TiffBytes strips = greyTiff(8, 30000);
    strips.add(273, 8, 30000);
    strips.add(278, 1);
    strips.add(279, 8, 30000);
    row("lists beyond the end", strips.bytes(0, pixels), "where its pixels lie");

    TiffBytes tiles = greyTiff(32768, 32768);
    tiles.add(322, 1);
    tiles.add(323, 1);
    row("tiles of one pixel", tiles.bytes(), "size of its tiles");
    TiffBytes wide = greyTiff(8, 8);
    wide.add(322, 0xfffffff0);
    wide.add(323, 16);
    row("tiles beyond sense", wide.bytes(), "size of its tiles");

    TiffBytes over = greyTiff(8, 8);
    over.add(273, 8, 8);
    over.add(278, 1);
    over.add(279, 60, 8);
    row("strips of which only one is there", over.bytes(), "");

    TiffBytes again = greyTiff(8, 8);
    again.add(273, 8);
    again.add(279, 64);
    row("a directory behind itself", again.bytes(8, pixels), "do not come to an end");
    row("a directory nowhere", again.bytes(0xffffff00, pixels), "damaged");
    row("no directory", QByteArray("II*\0\0\0\0\0", 8), "no directory");
    row("BigTIFF that is none", QByteArray("II+\0\x04\0\0\0\0\0\0\0\0\0\0\0", 16), "no directory");
    TiffBytes bits = greyTiff(8, 8);
    bits.add(339, 6);
    row("complex numbers", bits.bytes(), "8 bits (sample format 6)");
    TiffBytes samples = greyTiff(8, 8);
    samples.add(277, 3);
    row("three values", samples.bytes(), "3 values per pixel");
}

void ImageHostileTest::directoriesThatLie()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    const QString text = refusal(QStringLiteral("lies.tif"), bytes);
    QVERIFY2(!text.isEmpty() && text.contains(says), qPrintable(text));
}

/// How many strips may be is a matter of how much there is to lie in them.
void ImageHostileTest::stripsOfALargeFileAreMany()
{
    constexpr quint32 wide = 8;
    constexpr quint32 high = 30000;
    constexpr quint32 pages = 71; // with a place and a size per strip more than 2²² numbers
    constexpr quint32 headerBytes = 8;
    constexpr quint32 directoryBytes = 2 + 6 * 12 + 4;
    constexpr quint32 offsetsAt = headerBytes + pages * directoryBytes;
    constexpr quint32 sizesAt = offsetsAt + 4 * high;
    constexpr quint32 pixelsAt = sizesAt + 2 * high;
    // All pages share their strips, one row each.
    TiffBytes page = greyTiff(wide, high);
    page.add(273, offsetsAt, high);
    page.add(278, 1);
    page.add(279, sizesAt, high, 3);
    QByteArray bytes = page.bytes().left(headerBytes);
    for (quint32 k = 1; k <= pages; ++k)
        bytes += page.bytes(k < pages ? headerBytes + k * directoryBytes : 0).mid(headerBytes);
    QByteArray offsets(4 * high, '\0');
    QByteArray sizes(2 * high, '\0');
    for (quint32 row = 0; row < high; ++row) {
        qToLittleEndian(pixelsAt + row * wide, offsets.data() + 4 * row);
        qToLittleEndian(quint16(wide), sizes.data() + 2 * row);
    }
    bytes += offsets + sizes + QByteArray(wide * high, 'x');

    QFile file(put(QStringLiteral("many.tif"), bytes));
    QVERIFY(file.open(QIODevice::ReadWrite));
    const auto refused = core::readTiffPages(file);
    QVERIFY(!refused);
    QVERIFY2(refused.error().arguments.value(1).contains(QLatin1String("where its pixels lie")),
        qPrintable(test::errorText(refused.error())));
    // What is behind takes no room on the disk.
    QVERIFY(file.resize(qint64(64) * 2 * high * pages));
    const auto read = core::readTiffPages(file);
    QVERIFY2(read, qPrintable(read ? QString() : test::errorText(read.error())));
    QCOMPARE(read->size(), std::size_t(pages));
    QCOMPARE(read->back().parts.size(), std::size_t(high));
}

void ImageHostileTest::pngThatLies_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    test::PictureBytes small = picture<std::uint8_t>(0, columns, rows);
    const QByteArray sound = png(small);
    QByteArray wide = sound;
    qToBigEndian(quint32(0x7fffffff), wide.data() + 16);
    QTest::addRow("huge sides") << wide << QStringLiteral("2147483647 × 18 pixels");
    QByteArray bomb = sound;
    qToBigEndian(quint32(32768), bomb.data() + 16);
    qToBigEndian(quint32(32768), bomb.data() + 20);
    QTest::addRow("more than it can unpack to") << bomb << QStringLiteral("incomplete");
    QByteArray chunk = sound;
    chunk.insert(33, test::pngChunk("pHYs", QByteArray(9, '\1')));
    qToBigEndian(quint32(0xfffffff0), chunk.data() + 33);
    QTest::addRow("a chunk beyond the end") << chunk << QStringLiteral("incomplete");
    // Its checksum is right, its rows are not.
    test::PictureBytes fewer = picture<std::uint8_t>(0, columns, rows - 3);
    QByteArray rowsLess = png(fewer);
    const QByteArray header = sound.mid(8, 25);
    rowsLess.replace(8, 25, header);
    // What is thrown behind the fence ends a decoder with that sanitizer in it.
    if (!test::underAddressSanitizer)
        QTest::addRow("fewer rows than it says")
            << rowsLess << QStringLiteral("damaged pixel data");
    QTest::addRow("no data") << sound.left(33) + test::pngChunk("IEND", {})
                             << QStringLiteral("incomplete");
}

void ImageHostileTest::pngThatLies()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    const QString text = refusal(QStringLiteral("lies.png"), bytes);
    QVERIFY2(!text.isEmpty() && text.contains(says), qPrintable(text));
}

BURIN_TEST(ImageHostileTest)

} // namespace imageHostileTest

#include "ImageHostileTest.moc"
