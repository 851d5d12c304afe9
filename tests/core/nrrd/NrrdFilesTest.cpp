// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/NrrdFiles.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/VolumeFiles.h"

#include <QDir>
#include <QTest>

namespace nrrdFilesTest {

using namespace test::nrrd;

/// NRRD files that are in pieces, damaged or meant to do harm.
class NrrdFilesTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

public:
    NrrdFilesTest()
        : VolumeFiles("test.nrrd")
    {
    }

private Q_SLOTS:
    void init() { makeFolder(); }

    void voxelsInOtherFiles_data();
    void voxelsInOtherFiles();
    void voxelFilesAreNoStrangers();
    void damagedFilesAreNamed_data();
    void damagedFilesAreNamed();
    void packedFilesAreRead();
    void everyCutIsSurvived();
    void randomBytesAreSurvived();
};

void NrrdFilesTest::voxelsInOtherFiles_data()
{
    QTest::addColumn<QByteArray>("fields");
    QTest::addColumn<QStringList>("names");
    QTest::addColumn<QByteArray>("before");
    const auto row = [](const char* name, const QByteArray& fields, const QStringList& names,
                         const QByteArray& before = {}) {
        QTest::newRow(name) << fields << names << before;
    };
    const QStringList one{QStringLiteral("voxels.raw")};
    row("one file", "encoding: raw\ndata file: voxels.raw\n", one);
    row("old name of the field", "encoding: raw\ndatafile: ./voxels.raw\n", one);
    row("a name with blanks", "encoding: raw\ndata file: all 3 slices.raw\n",
        {QStringLiteral("all 3 slices.raw")});
    row("in a folder", "encoding: raw\ndata file: deep/voxels.raw\n",
        {QStringLiteral("deep/voxels.raw")});
    row("bytes to skip", "byte skip: 5\nencoding: raw\ndata file: voxels.raw\n", one, "12345");
    row("lines to skip", "line skip: 2\nbyte skip: 1\nencoding: raw\ndata file: voxels.raw\n", one,
        "a line\nanother\n!");
    row("from the end", "byte skip: -1\nencoding: raw\ndata file: voxels.raw\n", one, "whatever");
    row("packed", "encoding: gzip\ndata file: voxels.raw.gz\n", {QStringLiteral("voxels.raw.gz")});
    row("packed, with bytes to skip", "byte skip: 4\nencoding: gzip\ndata file: v.gz\n",
        {QStringLiteral("v.gz")}, "head");
    const QStringList slices{
        QStringLiteral("s08.raw"), QStringLiteral("s10.raw"), QStringLiteral("s12.raw")};
    row("listed", "encoding: raw\ndata file: LIST\ns08.raw\ns10.raw\ns12.raw\n", slices);
    row("listed, with their axes", "encoding: raw\ndata file: LIST 2\ns08.raw\ns10.raw\ns12.raw\n",
        slices);
    row("numbered", "encoding: raw\ndata file: s%02d.raw 8 12 2\n", slices);
    row("numbered, with their axes", "encoding: raw\ndata file: s%02d.raw 8 13 2 2\n", slices);
    row("numbered downwards", "encoding: raw\ndata file: s%d.raw 3 1 -1\n",
        {QStringLiteral("s3.raw"), QStringLiteral("s2.raw"), QStringLiteral("s1.raw")});
    row("each packed", "encoding: gzip\ndata file: s%02i.gz 8 12 2\n",
        {QStringLiteral("s08.gz"), QStringLiteral("s10.gz"), QStringLiteral("s12.gz")});
}

void NrrdFilesTest::voxelsInOtherFiles()
{
    QFETCH(QByteArray, fields);
    QFETCH(QStringList, names);
    QFETCH(QByteArray, before);
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("deep")));
    const bool packed = fields.contains("gzip");
    putVoxels(storedAs<std::int16_t>(false), names, before,
        packed ? [](const QByteArray& bytes) { return gzipped(bytes); }
               : std::function<QByteArray(const QByteArray&)>());
    compareVoxels(
        core::loadVolume(put(QStringLiteral("head.nhdr"), start + shape + place + fields)),
        soundAffine());
}

void NrrdFilesTest::voxelFilesAreNoStrangers()
{
    const QByteArray data = storedAs<std::int16_t>(false);
    for (int k = 0; k < 3; ++k)
        put(QStringLiteral("s%1.raw").arg(k), data.mid(40 * k, 40));
    put(QStringLiteral("head.nhdr"),
        start + shape + place + "encoding: raw\ndata file: s%d.raw 0 2 1\n");
    put(QStringLiteral("notes.txt"), "a study of a head");
    const core::Result<core::StudyListing> listing = core::scanStudies(m_folder->path());
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    QCOMPARE(listing->candidates().front()->key, QStringLiteral("head.nhdr"));
    QCOMPARE(listing->candidates().front()->files.size(), 1);
    QCOMPARE(listing->unreadable.size(), std::size_t(1));
    QVERIFY(listing->unreadable.front().file.endsWith(QStringLiteral("notes.txt")));
    QVERIFY(core::loadVolume(m_folder->path()));
}

void NrrdFilesTest::damagedFilesAreNamed_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<core::ErrorCode>("code");
    QTest::addColumn<QString>("reason");
    using core::ErrorCode;
    const auto row = [](const char* name, const QByteArray& bytes, ErrorCode code,
                         const char* reason) {
        QTest::newRow(name) << bytes << code << QString::fromUtf8(reason);
    };
    const QByteArray sound = soundFile();
    const auto changed = [&](const char* from, const QByteArray& to) {
        return QByteArray(sound).replace(from, to);
    };
    row("empty", {}, ErrorCode::FileTruncated, "no bytes");
    row("text", "a letter\n", ErrorCode::FileUnreadable, "not an NRRD file");
    row("from the future", changed("NRRD0004", "NRRD0009"), ErrorCode::FileUnreadable,
        "not an NRRD");
    row("no end", sound.left(100), ErrorCode::FileTruncated, "no end");
    row("cut", sound.chopped(1), ErrorCode::FileTruncated, "incomplete");
    row("endless header", start + QByteArray("k:=v\n").repeated(1000000), ErrorCode::FileUnreadable,
        "does not come to an end");
    row("no field", changed("type: short", "type short"), ErrorCode::FileUnreadable, "no field");
    row("twice", changed("type: short", "type: short\ntype: int"), ErrorCode::FileUnreadable,
        "'type' twice");
    row("no byte order", changed("endian: little\n", ""), ErrorCode::FileUnreadable, "endian");
    row("bzip2", changed("encoding: raw", "encoding: bzip2"), ErrorCode::UnsupportedFormat,
        "bzip2");
    row("block", changed("type: short", "type: block"), ErrorCode::UnsupportedFormat, "block");
    row("an encoding", changed("encoding: raw", "encoding: zrl"), ErrorCode::UnsupportedFormat,
        "zrl");
    row("the scanner's space", changed("left-posterior-superior", "scanner-xyz"),
        ErrorCode::UnsupportedFormat, "scanner-xyz");
    row("no dimension", changed("dimension: 3\n", ""), ErrorCode::FileUnreadable, "dimension");
    row("dimension", changed("dimension: 3", "dimension: 99999999999999999999"),
        ErrorCode::FileUnreadable, "dimension");
    row("sizes", changed("sizes: 5 4 3", "sizes: 5 4"), ErrorCode::FileUnreadable, "size for each");
    row("a size of 0", changed("sizes: 5 4 3", "sizes: 5 4 0"), ErrorCode::FileUnreadable, "0");
    row("longer than counted", changed("sizes: 5 4 3", "sizes: 5 4 32768"),
        ErrorCode::FileTruncated, "incomplete");
    row("a product that wraps", changed("sizes: 5 4 3", "sizes: 4294967296 4294967296 2"),
        ErrorCode::InvalidGeometry, "4294967296");
    row("as long as can be", changed("sizes: 5 4 3", "sizes: 32768 32768 32768"),
        ErrorCode::FileTruncated, "incomplete");
    row("flat", changed("(0,0,2.5)", "(0,0,0)"), ErrorCode::InvalidGeometry, "span");
    row("infinite", changed("(0,0,2.5)", "(0,0,inf)"), ErrorCode::InvalidGeometry, "span");
    row("beyond all bounds", changed("(-12,", "(1e999,"), ErrorCode::FileUnreadable, "origin");
    row("two directions", changed(" (0,0,2.5)", ""), ErrorCode::FileUnreadable, "direction");
    row("a direction without an end", changed("(0,0,2.5)", "(0,0,2.5"), ErrorCode::FileUnreadable,
        "direction");
    row("a skip", changed("encoding: raw", "byte skip: -2\nencoding: raw"),
        ErrorCode::FileUnreadable, "skips");
    row("a long skip", changed("encoding: raw", "byte skip: 999999999\nencoding: raw"),
        ErrorCode::FileTruncated, "incomplete");
    row("many lines", changed("encoding: raw", "line skip: 999999999\nencoding: raw"),
        ErrorCode::FileTruncated, "incomplete");
    row("not packed", changed("encoding: raw", "encoding: gzip"), ErrorCode::FileUnreadable,
        "damaged");
    row("no hex", changed("encoding: raw", "encoding: hex") + QByteArray(500, 'x'),
        ErrorCode::FileUnreadable, "hexadecimal");
    const QByteArray text =
        start + shape + place + "encoding: text\n\n" + QByteArray("1 2 3 4 5\n").repeated(11);
    row("text, cut", text, ErrorCode::FileTruncated, "incomplete");
    row("text, a word", text + "1 2 many 4 5", ErrorCode::FileUnreadable, "'many'");
    row("text, too great a number", text + "1 2 40000 4 5", ErrorCode::FileUnreadable, "'40000'");
    row("text, a long word", text + QByteArray(100000, '1'), ErrorCode::FileUnreadable, "words");
    const auto detached = [&](const QByteArray& file) {
        return start + shape + place + "encoding: raw\ndata file: " + file + '\n';
    };
    row("no such file", detached("nowhere.raw"), ErrorCode::FileUnreadable,
        "nowhere.raw: no such file");
    row("a device", detached("/dev/zero"), ErrorCode::FileUnreadable, "/dev/zero: not a file");
    row("a folder", detached("/"), ErrorCode::FileUnreadable, "not a file");
    row("no file", detached("LIST"), ErrorCode::FileUnreadable, "names no files");
    row("too many files", detached("s%d.raw 1 30000 1"), ErrorCode::FileUnreadable, "30000 files");
    row("very many files", detached("s%d.raw 1 60000 1"), ErrorCode::FileUnreadable,
        "no such file");
    row("long names", detached("s%d" + QByteArray(2000, 'x') + " 1 3 1"), ErrorCode::FileUnreadable,
        "names no files");
    row("a name with a zero", detached(QByteArray("s\0.raw", 6)), ErrorCode::FileUnreadable,
        "names no files");
    row("a pattern of another kind", detached("s%s.raw 1 3 1"), ErrorCode::FileUnreadable,
        "no such file");
    row("a step that leads nowhere", detached("s%d.raw 1 3 0"), ErrorCode::FileUnreadable,
        "no such file");
    row("numbers that wrap", detached("s%d.raw -9223372036854775808 9223372036854775807 1"),
        ErrorCode::FileUnreadable, "no such file");
    row("itself", detached("test.nrrd"), ErrorCode::Internal, "");
}

void NrrdFilesTest::damagedFilesAreNamed()
{
    QFETCH(QByteArray, bytes);
    QFETCH(core::ErrorCode, code);
    QFETCH(QString, reason);
    if (code != core::ErrorCode::Internal)
        return compareRefusal(bytes, code, reason);
    (void)openBytes(bytes); // only that it comes back counts
}

void NrrdFilesTest::packedFilesAreRead()
{
    const QByteArray head = start + shape + place + "encoding: gzip\n\n";
    const QByteArray data = storedAs<std::int16_t>(false);
    const auto reasonOf = [&](const QByteArray& packed) {
        const core::Result<core::LoadedVolume> loaded = openBytes(head + packed);
        return loaded ? test::problemText(loaded->volume.problems, core::VolumeProblem::Kind::Other)
                      : loaded.error().arguments.value(1);
    };
    const QByteArray packed = gzipped(data);
    QCOMPARE(reasonOf(packed), QString());
    QCOMPARE(reasonOf(gzipped(data.left(50)) + gzipped(data.mid(50))), QString());
    // More than the header implies: only told, and never unpacked.
    QVERIFY(reasonOf(gzipped(data + "!")).contains(QStringLiteral("holds more")));
    QVERIFY(reasonOf(gzipped(data + QByteArray(200'000'000, '\0')))
                .contains(QStringLiteral("holds more")));
    QVERIFY(reasonOf(gzipped(data.chopped(1))).contains(QStringLiteral("incomplete")));
    QVERIFY(reasonOf(packed.chopped(1)).contains(QStringLiteral("break off")));
    QByteArray wrongSum = packed;
    wrongSum[wrongSum.size() - 6] = char(wrongSum[wrongSum.size() - 6] ^ 1);
    QVERIFY(reasonOf(wrongSum).contains(QStringLiteral("damaged")));
    QVERIFY(reasonOf(gzipped(data, MAX_WBITS)).contains(QStringLiteral("damaged")));
}

void NrrdFilesTest::everyCutIsSurvived()
{
    compareEveryCut(soundFile());
}

void NrrdFilesTest::randomBytesAreSurvived()
{
    const QByteArray detached =
        start + shape + place + "encoding: raw\ndata file: s%02d.raw 8 12 2\n";
    put(QStringLiteral("s08.raw"), QByteArray(40, '1'));
    const QByteArray text =
        start + shape + place + "encoding: text\n\n" + QByteArray("1 2 3 4 5\n").repeated(12);
    const QByteArray packed =
        start + shape + place + "encoding: gzip\n\n" + gzipped(storedAs<std::int16_t>(false));
    compareRandomBytes({soundFile(), detached, text, packed}, 7, test::longRun() ? 20000 : 1500);
}

BURIN_TEST(NrrdFilesTest)

} // namespace nrrdFilesTest

#include "NrrdFilesTest.moc"
