// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/codecs/FrameDecoder.h"

#include "core/dicom/base/TransferSyntax.h"
#include "core/dicom/header/ImageHeaderReader.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QCryptographicHash>
#include <QDirIterator>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <random>

namespace frameDecoderTest {

namespace {

QByteArray sha256(const std::vector<std::uint16_t>& stored, bool isSigned)
{
    std::vector<std::int32_t> wide;
    for (const std::uint16_t value : stored)
        wide.push_back(isSigned ? std::int16_t(value) : value);
    return QCryptographicHash::hash(QByteArrayView(reinterpret_cast<const char*>(wide.data()),
                                        qsizetype(wide.size() * sizeof(std::int32_t))),
        QCryptographicHash::Sha256)
        .toHex();
}

/// The same numbers from pixels that do not fit 16 bits.
QByteArray sha256OfWide(const std::vector<double>& numbers)
{
    std::vector<std::uint32_t> wide;
    for (const double number : numbers)
        wide.push_back(std::uint32_t(std::int64_t(number)));
    return QCryptographicHash::hash(QByteArrayView(reinterpret_cast<const char*>(wide.data()),
                                        qsizetype(wide.size() * sizeof(std::uint32_t))),
        QCryptographicHash::Sha256)
        .toHex();
}

/// Files of a case, in its archives or beside them.
QString findFile(const test::SharedCase& data, const QString& name)
{
    for (const QString& root : {data.source, data.unpacked}) {
        if (!root.isEmpty() && QFile::exists(root + QLatin1Char('/') + name))
            return root + QLatin1Char('/') + name;
    }
    return {};
}

} // namespace

/// Stored values of single files, and files that no decoder should trust.
class FrameDecoderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void storedValuesMatch_data();
    void storedValuesMatch();
    void brokenFilesAreNamed();
    void damagedBytesNeverCrash_data();
    void damagedBytesNeverCrash();
};

void FrameDecoderTest::storedValuesMatch_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("hash");
    for (const char* name : {"edge_pixels_colour", "edge_transfer_syntaxes", "edge_broken"}) {
        const test::SharedCase data = test::sharedCase(QString::fromLatin1(name));
        for (const QJsonValue& file : data.expected[QStringLiteral("single_files")].toArray()) {
            const QByteArray hash = file[QStringLiteral("pixels")]
                                        .toObject()[QStringLiteral("stored_sha256_i32le")]
                                        .toString()
                                        .toLatin1();
            const QJsonArray bits = file[QStringLiteral("bits")].toArray();
            const int allocated = bits[0].toInt();
            const bool one = file[QStringLiteral("frames")].toInt() == 1;
            const bool grey = file[QStringLiteral("samples_per_pixel")].toInt() == 1
                && (allocated == 32 || (one && (allocated == 8 || allocated == 16)));
            if (hash.isEmpty() || !grey)
                continue;
            const QString path = file[QStringLiteral("file")].toString();
            QTest::newRow(qPrintable(path)) << findFile(data, path) << hash;
        }
    }
    if (test::sharedDataFolder().isEmpty())
        QTest::newRow("no shared data") << QString() << QByteArray();
}

void FrameDecoderTest::storedValuesMatch()
{
    QFETCH(QString, file);
    QFETCH(QByteArray, hash);
    if (test::sharedDataFolder().isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    QVERIFY(!file.isEmpty());
    const core::Result<core::ImageHeader> header = core::readImageHeader(file);
    QVERIFY(header);
    const core::PixelLayout& layout = header->layout;
    const std::size_t pixels = std::size_t(layout.rows) * std::size_t(layout.columns);
    if (layout.isWide()) {
        const core::Result<core::FrameFile> opened = core::FrameFile::open(file);
        QVERIFY(opened);
        std::vector<double> numbers(pixels * std::size_t(header->frames));
        for (int frame = 0; frame < header->frames; ++frame) {
            core::ImageHeader one = *header;
            one.frame = frame;
            QVERIFY(opened->decodeNumbers(
                one, std::span(numbers).subspan(pixels * std::size_t(frame), pixels)));
        }
        QCOMPARE(sha256OfWide(numbers), hash);
        return;
    }
    std::vector<std::uint16_t> stored(pixels);
    const core::Result<core::DecodedFrame> decoded = core::decodeFrame(*header, stored);
    QVERIFY2(decoded, decoded ? "" : qPrintable(decoded.error().arguments.join(QLatin1Char(' '))));
    QCOMPARE(sha256(stored, layout.isSigned), hash);
}

void FrameDecoderTest::brokenFilesAreNamed()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("edge_broken"));
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    QDirIterator iterator(data.source + QStringLiteral("/files"), QDir::Files);
    int opened = 0;
    while (iterator.hasNext()) {
        const QString file = iterator.next();
        const core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
        if (loaded) {
            ++opened;
            continue;
        }
        QVERIFY2(loaded.error().arguments.value(0) == file, qPrintable(file));
        QVERIFY2(!loaded.error().arguments.value(1).isEmpty(), qPrintable(file));
    }
    // The two whose images are sound: MR_small_padded.dcm and bad_sequence.dcm.
    QCOMPARE(opened, 2);

    const QString folder = data.source + QStringLiteral("/damaged_series");
    const core::Result<core::StudyListing> listing = core::scanStudies(folder);
    QVERIFY(listing);
    QStringList unreadable;
    for (const core::UnreadableFile& file : listing->unreadable)
        unreadable.append(QFileInfo(file.file).fileName());
    unreadable.sort();
    QCOMPARE(unreadable.join(QLatin1Char(' ')),
        QStringLiteral("CT005.dcm CT011.dcm CT020.dcm Thumbs.db readme.txt"));
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(folder);
    QVERIFY(loaded);
    const QJsonObject stack = data.expected[QStringLiteral("damaged_series")]
                                  .toObject()[QStringLiteral("sound_slices_only_CT005_dropped")]
                                  .toArray()[0]
                                  .toObject()[QStringLiteral("stacks")]
                                  .toArray()[0]
                                  .toObject();
    QCOMPARE(QString::fromLatin1(loaded->volume.voxelsSha256),
        stack[QStringLiteral("rescaled")].toObject()[QStringLiteral("sha256_f32le")].toString());
    QVERIFY(loaded->volume.needsCaution());
}

void FrameDecoderTest::damagedBytesNeverCrash_data()
{
    QTest::addColumn<QString>("syntax");
    for (const char* uid : {"1.2.840.10008.1.2", "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.1.99",
             "1.2.840.10008.1.2.2", "1.2.840.10008.1.2.5", "1.2.840.10008.1.2.4.70",
             "1.2.840.10008.1.2.4.80"})
        QTest::newRow(uid) << QString::fromLatin1(uid);
}

void FrameDecoderTest::damagedBytesNeverCrash()
{
    QFETCH(QString, syntax);
    const QTemporaryDir folder;
    test::SyntheticSeries series;
    series.size = {16, 12, 1};
    series.transferSyntaxUid = syntax;
    const QString path = test::writeSeries(series, folder.path()).front();
    QFile original(path);
    QVERIFY(original.open(QIODevice::ReadOnly));
    const QByteArray bytes = original.readAll();
    const int rounds = qEnvironmentVariableIsSet("BURIN_LONG") ? 5000 : 150;
    std::mt19937 random(20240131);
    int opened = 0;
    for (int round = 0; round < rounds; ++round) {
        QByteArray damaged = bytes;
        const int changes = 1 + int(random() % 6);
        for (int change = 0; change < changes; ++change) {
            // Half of the damage goes where the pixels are.
            const qsizetype from =
                random() % 2 == 0 ? 132 : std::max<qsizetype>(132, bytes.size() / 2);
            const qsizetype at = from + qsizetype(random() % quint32(bytes.size() - from));
            damaged[at] = char(random());
        }
        if (random() % 8 == 0)
            damaged.truncate(qsizetype(random() % quint32(bytes.size())));
        const QString file = folder.filePath(QStringLiteral("damaged.dcm"));
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(damaged);
        out.close();
        const core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
        opened += loaded ? 1 : 0;
        if (!loaded)
            QVERIFY(!loaded.error().arguments.isEmpty());
    }
    QVERIFY(opened < rounds);
}

BURIN_TEST(FrameDecoderTest)

} // namespace frameDecoderTest

#include "FrameDecoderTest.moc"
