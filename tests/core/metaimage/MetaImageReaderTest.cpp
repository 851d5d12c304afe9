// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/NrrdFiles.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/VolumeFiles.h"

#include <QTest>

namespace metaImageReaderTest {

// The voxels are those of the NRRD tests; the headers share nothing.
using test::sameAffine;
using test::nrrd::gzipped;
using test::nrrd::storedAs;
using test::nrrd::valueOf;
using test::nrrd::voxels;

namespace {

const QByteArray start("ObjectType = Image\nNDims = 3\nBinaryData = True\n");
const QByteArray place("TransformMatrix = 0.6 0.8 0 -0.8 0.6 0 0 0 1\nOffset = -12 34 56.5\n"
                       "CenterOfRotation = 7 7 7\nAnatomicalOrientation = RAI\n"
                       "ElementSpacing = 0.5 0.75 2.5\nDimSize = 5 4 3\n");

QByteArray soundFile()
{
    return start + place + "ElementType = MET_SHORT\nElementDataFile = LOCAL\n"
        + storedAs<std::int16_t>(false);
}

glm::dmat4 soundAffine()
{
    return {glm::dvec4(0.3, 0.4, 0, 0), glm::dvec4(-0.6, 0.45, 0, 0), glm::dvec4(0, 0, 2.5, 0),
        glm::dvec4(-12, 34, 56.5, 1)};
}

} // namespace

/// MetaImage volumes: their place, their values, their refusals.
class MetaImageReaderTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

public:
    MetaImageReaderTest()
        : VolumeFiles("test.mha")
    {
    }

private Q_SLOTS:
    void init() { makeFolder(); }

    void typesOrdersAndEncodings_data();
    void typesOrdersAndEncodings();
    void placeAndItsNames();
    void axesBeyondThree();
    void voxelsInOtherFiles_data();
    void voxelsInOtherFiles();
    void damagedFilesAreNamed_data();
    void damagedFilesAreNamed();
    void everyCutIsSurvived();
    void randomBytesAreSurvived();
    void masksAreCheckedAgainstTheFile();
};

void MetaImageReaderTest::typesOrdersAndEncodings_data()
{
    QTest::addColumn<QByteArray>("fields");
    QTest::addColumn<QByteArray>("data");
    QTest::addColumn<int>("shift");
    const auto typed = [&]<class T>(const char* type, T) {
        const int shift = std::is_unsigned_v<T> ? 20 : 0;
        const QByteArray head = QByteArray("ElementType = ") + type + '\n';
        const auto row = [&](const char* what, const QByteArray& more, const QByteArray& data) {
            QTest::addRow("%s, %s", type, what) << head + more << data << shift;
        };
        const QByteArray little = storedAs<T>(false);
        const QByteArray big = storedAs<T>(true);
        row("little", "BinaryDataByteOrderMSB = False\n", little);
        row("big", "BinaryDataByteOrderMSB = True\n", big);
        row("big by its other name", "ElementByteOrderMSB = True\n", big);
        row("nothing said", "", little);
        row("zlib", "CompressedData = True\nCompressedDataSize = 99\n", gzipped(little, MAX_WBITS));
        row("gzip, big", "CompressedData = True\nElementByteOrderMSB = true\n", gzipped(big));
    };
    typed("MET_CHAR", std::int8_t());
    typed("MET_UCHAR", std::uint8_t());
    typed("MET_SHORT", std::int16_t());
    typed("MET_USHORT", std::uint16_t());
    typed("MET_INT", std::int32_t());
    typed("MET_UINT", std::uint32_t());
    typed("MET_LONG", std::int32_t());
    typed("MET_ULONG", std::uint32_t());
    typed("MET_LONG_LONG", std::int64_t());
    typed("MET_ULONG_LONG", std::uint64_t());
    typed("MET_FLOAT", float());
    typed("MET_DOUBLE", double());
}

void MetaImageReaderTest::typesOrdersAndEncodings()
{
    QFETCH(QByteArray, fields);
    QFETCH(QByteArray, data);
    QFETCH(int, shift);
    const auto loaded = openBytes(start + place + fields + "ElementDataFile = LOCAL\n" + data);
    compareVoxels(loaded, soundAffine(), shift);
    if (loaded)
        QCOMPARE(loaded->volume.sourceFormat, QStringLiteral("MetaImage"));
}

void MetaImageReaderTest::placeAndItsNames()
{
    const auto opened = [&](const QByteArray& from, const QByteArray& to) {
        const core::Result<core::LoadedVolume> loaded = openBytes(soundFile().replace(from, to));
        return loaded ? loaded->volume : core::Volume();
    };
    for (const char* name : {"Position", "Origin"})
        QVERIFY(sameAffine(opened("Offset", name).geometry.indexToWorld, soundAffine()));
    for (const char* name : {"Rotation", "Orientation"})
        QVERIFY(sameAffine(opened("TransformMatrix", name).geometry.indexToWorld, soundAffine()));
    QVERIFY(
        sameAffine(opened("ElementSpacing", "ElementSize").geometry.indexToWorld, soundAffine()));
    // Windows' ends of lines, and no care for blanks.
    QVERIFY(sameAffine(
        opened("Offset = -12 34 56.5\n", "Offset=-12  34 56.5\r\n").geometry.indexToWorld,
        soundAffine()));
    const core::Volume bare = opened(place, "DimSize = 5 4 3\n");
    QVERIFY(sameAffine(bare.geometry.indexToWorld, glm::dmat4(1.0)));
    QVERIFY(bare.needsCaution());
    QVERIFY(test::hasProblem(bare.problems, core::VolumeProblem::Kind::AssumedSpacing));
    QVERIFY(opened("BinaryData = True", "BinaryData = False").geometry.size == glm::ivec3(0));
    const core::Result<core::LoadedVolume> words =
        openBytes(QByteArray(start).replace("True", "False") + place
            + "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n"
            + QByteArray("1.5 2 3 4 5e1\n").repeated(12));
    QVERIFY(words);
    QCOMPARE(words->volume.maximum, 50.0);
}

void MetaImageReaderTest::axesBeyondThree()
{
    const QByteArray data = storedAs<std::int16_t>(false);
    const QByteArray end = "ElementType = MET_SHORT\nElementDataFile = LOCAL\n";
    const QByteArray four = "NDims = 4\nElementSpacing = 1 1 2 1\nOffset = 1 2 3 9\n"
                            "TransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n";
    const auto one = openBytes(four + "DimSize = 5 4 3 1\n" + end + data);
    QVERIFY2(one, qPrintable(one ? QString() : test::errorText(one.error())));
    QCOMPARE(one->volume.geometry.originLps(), glm::dvec3(1, 2, 3));
    QCOMPARE(one->volume.geometry.spacingMm(), glm::dvec3(1, 1, 2));
    const auto two = openBytes(four + "DimSize = 5 4 3 2\n" + end + data + data);
    QVERIFY(!two);
    QCOMPARE(two.error().code, core::ErrorCode::UnsupportedFormat);
    QCOMPARE(two.error().arguments.value(1), QStringLiteral("it holds 2 volumes"));
    const auto picture =
        openBytes("NDims = 2\nElementSpacing = 0.5 0.5\nDimSize = 5 4\n" + end + data.left(40));
    QVERIFY(picture);
    QCOMPARE(picture->volume.geometry.size, glm::ivec3(5, 4, 1));
    QVERIFY(picture->volume.needsCaution());
}

void MetaImageReaderTest::voxelsInOtherFiles_data()
{
    QTest::addColumn<QByteArray>("fields");
    QTest::addColumn<QStringList>("names");
    QTest::addColumn<QByteArray>("before");
    const auto row = [](const char* name, const QByteArray& fields, const QStringList& names,
                         const QByteArray& before = {}) {
        QTest::newRow(name) << fields << names << before;
    };
    const QStringList one{QStringLiteral("voxels 1.raw")};
    row("one file", "ElementDataFile = voxels 1.raw\n", one);
    row("without an end of line", "ElementDataFile = voxels 1.raw", one);
    row("behind a header", "HeaderSize = 5\nElementDataFile = voxels 1.raw\n", one, "12345");
    row("at the end", "HeaderSize = -1\nElementDataFile = voxels 1.raw\n", one, "whatever");
    row("packed", "CompressedData = True\nElementDataFile = v.zraw\n", {QStringLiteral("v.zraw")});
    const QStringList slices{
        QStringLiteral("s08.raw"), QStringLiteral("s10.raw"), QStringLiteral("s12.raw")};
    row("listed", "ElementDataFile = LIST\ns08.raw\ns10.raw\ns12.raw\n", slices);
    row("listed, with their axes", "ElementDataFile = LIST 2\ns08.raw\r\ns10.raw\r\ns12.raw",
        slices);
    row("numbered", "ElementDataFile = s%02d.raw 8 12 2\n", slices);
}

void MetaImageReaderTest::voxelsInOtherFiles()
{
    QFETCH(QByteArray, fields);
    QFETCH(QStringList, names);
    QFETCH(QByteArray, before);
    const bool packed = fields.contains("Compressed");
    putVoxels(storedAs<std::int16_t>(false), names, before,
        packed ? [](const QByteArray& bytes) { return gzipped(bytes, MAX_WBITS); }
               : std::function<QByteArray(const QByteArray&)>());
    const QString header =
        put(QStringLiteral("head.mhd"), start + place + "ElementType = MET_SHORT\n" + fields);
    for (const QString& path : {header, m_folder->path()}) {
        const core::Result<core::Study> study = core::Study::scan(path);
        QVERIFY2(study, qPrintable(study ? QString() : test::errorText(study.error())));
        QVERIFY(study->listing().unreadable.empty());
        const core::Result<core::LoadedVolume> loaded = study->load();
        compareVoxels(loaded, soundAffine());
    }
}

void MetaImageReaderTest::damagedFilesAreNamed_data()
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
    row("text", "a letter\n", ErrorCode::FileUnreadable, "not a MetaImage file");
    row("zeros", QByteArray(200000, '\0'), ErrorCode::FileUnreadable, "not a MetaImage file");
    row("cut", sound.chopped(1), ErrorCode::FileTruncated, "incomplete");
    row("endless", start + QByteArray("\n").repeated(5'000'000), ErrorCode::FileUnreadable,
        "does not come to an end");
    row("no end", start + place, ErrorCode::FileUnreadable, "ElementDataFile");
    row("no field", changed("ElementType = ", "ElementType "), ErrorCode::FileUnreadable,
        "no field");
    row("twice", changed("DimSize", "NDims = 3\nDimSize"), ErrorCode::FileUnreadable,
        "'NDims' twice");
    row("channels", changed("ElementType", "ElementNumberOfChannels = 3\nElementType"),
        ErrorCode::UnsupportedFormat, "3 values");
    row("vectors", changed("MET_SHORT", "MET_FLOAT_ARRAY"), ErrorCode::UnsupportedFormat,
        "MET_FLOAT_ARRAY");
    row("dimension", changed("NDims = 3", "NDims = nan"), ErrorCode::FileUnreadable, "NDims");
    row("sizes", changed("DimSize = 5 4 3", "DimSize = 5 4"), ErrorCode::FileUnreadable, "DimSize");
    row("half a size", changed("DimSize = 5 4 3", "DimSize = 5 4 2.5"), ErrorCode::FileUnreadable,
        "2.5");
    row("no size", changed("DimSize = 5 4 3", "DimSize = 5 4 inf"), ErrorCode::FileUnreadable,
        "inf");
    row("a product that wraps", changed("DimSize = 5 4 3", "DimSize = 4294967296 4294967296 2"),
        ErrorCode::InvalidGeometry, "4294967296");
    row("as long as can be", changed("DimSize = 5 4 3", "DimSize = 32768 32768 32768"),
        ErrorCode::FileTruncated, "incomplete");
    row("flat", changed("0 0 1\n", "0 0 0\n"), ErrorCode::InvalidGeometry, "span");
    row("no spacing", changed("0.5 0.75 2.5", "0.5 0.75"), ErrorCode::FileUnreadable, "spacing");
    row("no place", changed("-12 34", "left 34"), ErrorCode::FileUnreadable, "place");
    row("no direction", changed("0.6 0.8 0", "0.6 0.8"), ErrorCode::FileUnreadable, "direction");
    row("a header that is none", changed("DimSize", "HeaderSize = -7\nDimSize"),
        ErrorCode::FileUnreadable, "HeaderSize");
    row("not packed", changed("DimSize", "CompressedData = True\nDimSize"),
        ErrorCode::FileUnreadable, "damaged");
    row("no such file", changed("LOCAL", "nowhere.raw"), ErrorCode::FileUnreadable,
        "nowhere.raw: no such file");
    row("a device", changed("LOCAL", "/dev/zero"), ErrorCode::FileUnreadable, "not a file");
    row("too many files", changed("LOCAL", "s%d.raw 1 30000 1"), ErrorCode::FileUnreadable,
        "30000 files");
}

void MetaImageReaderTest::damagedFilesAreNamed()
{
    QFETCH(QByteArray, bytes);
    QFETCH(core::ErrorCode, code);
    QFETCH(QString, reason);
    compareRefusal(bytes, code, reason);
}

void MetaImageReaderTest::everyCutIsSurvived()
{
    compareEveryCut(soundFile());
}

void MetaImageReaderTest::randomBytesAreSurvived()
{
    const QByteArray head = start + place + "ElementType = MET_SHORT\n";
    put(QStringLiteral("s08.raw"), QByteArray(40, '1'));
    compareRandomBytes({soundFile(), head + "ElementDataFile = s%02d.raw 8 12 2\n",
                           head + "CompressedData = True\nElementDataFile = LOCAL\n"
                               + gzipped(storedAs<std::int16_t>(false), MAX_WBITS)},
        11, test::longRun() ? 20000 : 1500);
}

void MetaImageReaderTest::masksAreCheckedAgainstTheFile()
{
    compareMasks(soundFile(), soundFile().replace("-12 34", "-11 34"));
}

BURIN_TEST(MetaImageReaderTest)

} // namespace metaImageReaderTest

#include "MetaImageReaderTest.moc"
