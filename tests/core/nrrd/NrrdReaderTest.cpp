// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/NrrdFiles.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/VolumeFiles.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QTest>

#include <cmath>

namespace nrrdReaderTest {

using namespace test::nrrd;
using test::sameAffine;

namespace {

template <class T> QByteArray hashAs(const core::LoadedVolume& loaded)
{
    QByteArray bytes;
    for (const std::uint16_t code : loaded.codes) {
        const T value = T(loaded.volume.encoding.value(code));
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

} // namespace

/// NRRD volumes: their place, their values, their refusals.
class NrrdReaderTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

public:
    NrrdReaderTest()
        : VolumeFiles("test.nrrd")
    {
    }

private Q_SLOTS:
    void init() { makeFolder(); }

    void sharedVolumesMatch_data();
    void sharedVolumesMatch();
    void typesOrdersAndEncodings_data();
    void typesOrdersAndEncodings();
    void spacesBecomeLps_data();
    void spacesBecomeLps();
    void withoutASpace();
    void pictures();
    void fourthAxes_data();
    void fourthAxes();
    void masksAreCheckedAgainstTheFile();
};

void NrrdReaderTest::sharedVolumesMatch_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QJsonObject>("facts");
    if (test::sharedDataFolder().isEmpty())
        QTest::newRow("no shared data") << QString() << QJsonObject();
    for (const char* name : {"mr_brain_tumour_nrrd", "ct_tooth"}) {
        const test::SharedCase data = test::sharedCase(QString::fromLatin1(name));
        for (const char* list : {"volumes", "labels"}) {
            for (const QJsonValue& facts : data.expected[QLatin1String(list)].toArray()) {
                const QString file = facts[QStringLiteral("file")].toString();
                QTest::newRow(qPrintable(file))
                    << data.source + QLatin1Char('/') + file << facts.toObject();
            }
        }
    }
}

void NrrdReaderTest::sharedVolumesMatch()
{
    QFETCH(QString, path);
    QFETCH(QJsonObject, facts);
    if (path.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::LoadedVolume loaded = test::openVolume(path);
    const core::Volume& volume = loaded.volume;
    const QJsonArray dims = facts[QStringLiteral("dims_i_j_k")].toArray();
    QCOMPARE(volume.geometry.size, glm::ivec3(dims[0].toInt(), dims[1].toInt(), dims[2].toInt()));
    const QJsonArray rows = facts[QStringLiteral("affine_ijk_to_lps_mm")].toArray();
    if (rows.isEmpty()) {
        QCOMPARE(volume.geometry.spacingMm(), glm::dvec3(1.0));
        QVERIFY(volume.needsCaution());
    }
    for (int row = 0; row < int(rows.size()) && row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            const double expected = rows[row].toArray()[column].toDouble();
            QVERIFY(std::abs(volume.geometry.indexToWorld[column][row] - expected) < 1e-6);
        }
    }
    const QJsonObject stored = facts[QStringLiteral("stored")].toObject();
    QCOMPARE(volume.minimum, stored[QStringLiteral("min")].toDouble());
    QCOMPARE(volume.maximum, stored[QStringLiteral("max")].toDouble());
    QCOMPARE(volume.encoding.maxError, 0.0);
    const QString type = facts[QStringLiteral("type")].toString();
    const QByteArray hash = facts[QStringLiteral("voxel_block_sha256")].toString().toLatin1();
    if (type == QLatin1String("int"))
        QCOMPARE(hashAs<std::int32_t>(loaded), hash);
    else
        QCOMPARE(hashAs<std::int16_t>(loaded), hash);
}

void NrrdReaderTest::typesOrdersAndEncodings_data()
{
    QTest::addColumn<QByteArray>("header");
    QTest::addColumn<QByteArray>("data");
    QTest::addColumn<int>("shift");
    const auto rows = [](const char* type, const QByteArray& little, const QByteArray& big,
                          bool isUnsigned) {
        QByteArray text;
        for (int voxel = 0; voxel < voxels; ++voxel) {
            text += QByteArray::number(valueOf(voxel) + (isUnsigned ? 20 : 0));
            text += voxel % 5 == 4 ? "\n" : voxel % 2 == 0 ? " " : ", ";
        }
        const int shift = isUnsigned ? 20 : 0;
        const QByteArray head = QByteArray("type: ") + type + "\ndimension: 3\nsizes: 5 4 3\n";
        const auto row = [&](const char* what, const QByteArray& more, const QByteArray& data) {
            QTest::addRow("%s, %s", type, what) << head + more << data << shift;
        };
        row("raw, little", "endian: little\nencoding: raw\n", little);
        row("raw, big", "endian: big\nencoding: raw\n", big);
        row("gzip, little", "endian: little\nencoding: gzip\n", gzipped(little));
        row("gz, big", "endian: big\nencoding: gz\n", gzipped(big));
        row("ascii", "encoding: ascii\n", text);
        row("hex, big", "endian: big\nencoding: hex\n", big.toHex('\n'));
    };
    const auto typed = [&]<class T>(const char* type, T) {
        rows(type, storedAs<T>(false), storedAs<T>(true), std::is_unsigned_v<T>);
    };
    typed("signed char", std::int8_t());
    typed("uchar", std::uint8_t());
    typed("short", std::int16_t());
    typed("unsigned short", std::uint16_t());
    typed("int32", std::int32_t());
    typed("unsigned int", std::uint32_t());
    typed("long long int", std::int64_t());
    typed("uint64_t", std::uint64_t());
    typed("float", float());
    typed("double", double());
}

void NrrdReaderTest::typesOrdersAndEncodings()
{
    QFETCH(QByteArray, header);
    QFETCH(QByteArray, data);
    QFETCH(int, shift);
    const auto loaded = openBytes(start + header + place + '\n' + data);
    compareVoxels(loaded, soundAffine(), shift);
    if (loaded)
        QCOMPARE(loaded->volume.sourceFormat, QStringLiteral("NRRD"));
}

void NrrdReaderTest::spacesBecomeLps_data()
{
    QTest::addColumn<QByteArray>("space");
    QTest::addColumn<glm::dvec3>("signs");
    QTest::addColumn<bool>("caution");
    const auto row = [](const char* space, const glm::dvec3& signs, bool caution) {
        QTest::newRow(space) << QByteArray(space) << signs << caution;
    };
    for (const char* space : {"left-posterior-superior", "LPS", "Left-Posterior-Superior"})
        row(space, {1, 1, 1}, false);
    for (const char* space : {"right-anterior-superior", "RAS"})
        row(space, {-1, -1, 1}, false);
    for (const char* space : {"left-anterior-superior", "LAS"})
        row(space, {1, -1, 1}, false);
    for (const char* space : {"3D-right-handed", "3DR", "3D-left-handed"})
        row(space, {1, 1, 1}, true);
}

void NrrdReaderTest::spacesBecomeLps()
{
    QFETCH(QByteArray, space);
    QFETCH(glm::dvec3, signs);
    QFETCH(bool, caution);
    const core::Result<core::LoadedVolume> loaded =
        openBytes(soundFile().replace("left-posterior-superior", space));
    QVERIFY2(loaded, qPrintable(loaded ? QString() : test::errorText(loaded.error())));
    glm::dmat4 expected = soundAffine();
    for (int column = 0; column < 4; ++column)
        expected[column] *= glm::dvec4(signs, 1.0);
    QVERIFY(sameAffine(loaded->volume.geometry.indexToWorld, expected));
    QCOMPARE(loaded->volume.needsCaution(), caution);
}

void NrrdReaderTest::withoutASpace()
{
    const auto affineOf = [&](const QByteArray& fields) {
        const core::Result<core::LoadedVolume> loaded =
            openBytes(start + shape + fields + "encoding: raw\n\n" + storedAs<std::int16_t>(false));
        if (!loaded || !loaded->volume.needsCaution())
            return glm::dmat4(0.0);
        return loaded->volume.geometry.indexToWorld;
    };
    const auto scaled = [](const glm::dvec3& spacing, const glm::dvec3& origin) {
        glm::dmat4 affine(1.0);
        for (int axis = 0; axis < 3; ++axis)
            affine[axis][axis] = spacing[axis];
        affine[3] = glm::dvec4(origin, 1.0);
        return affine;
    };
    QVERIFY(sameAffine(affineOf("spacings: 0.5 0.75 2\n"), scaled({0.5, 0.75, 2}, {0, 0, 0})));
    QVERIFY(sameAffine(affineOf("spacings: 0.5 nan 2\n"), scaled({0.5, 1, 2}, {0, 0, 0})));
    QVERIFY(sameAffine(affineOf(""), scaled({1, 1, 1}, {0, 0, 0})));
    // Minima are of edges unless the samples are at nodes.
    QVERIFY(sameAffine(
        affineOf("axis mins: 10 20 30\naxis maxs: 15 28 42\n"), scaled({1, 2, 4}, {10.5, 21, 32})));
    QVERIFY(sameAffine(affineOf("axismins: 10 20 30\naxis maxs: 18 26 34\n"
                                "centerings: node node node\n"),
        scaled({2, 2, 2}, {10, 20, 30})));
    QVERIFY(sameAffine(affineOf("spacings: 1 1 1\nunits: \"cm\" \"cm\" \"mm\"\n"),
        scaled({10, 10, 1}, {0, 0, 0})));
    const core::Result<core::LoadedVolume> micrometres = openBytes(
        soundFile().replace("space origin", "space units: \"um\" \"um\" \"um\"\nspace origin"));
    QVERIFY(micrometres);
    QVERIFY(std::abs(micrometres->volume.geometry.spacingMm().z - 0.0025) < 1e-12);
}

void NrrdReaderTest::pictures()
{
    const QByteArray data = storedAs<std::int16_t>(false).left(2 * 20);
    const QByteArray header = start
        + "type: short\ndimension: 2\nsizes: 5 4\nendian: little\n"
          "encoding: raw\n";
    for (const QByteArray& fields : {QByteArray("spacings: 0.5 0.5\n"),
             QByteArray("space: LPS\nspace directions: (0,0.5,0) "
                        "(0,0,-0.5)\nspace origin: (1,2,3)\n")}) {
        const core::Result<core::LoadedVolume> loaded = openBytes(header + fields + '\n' + data);
        QVERIFY2(loaded, qPrintable(loaded ? QString() : test::errorText(loaded.error())));
        QCOMPARE(loaded->volume.geometry.size, glm::ivec3(5, 4, 1));
        QCOMPARE(loaded->volume.geometry.spacingMm(), glm::dvec3(0.5, 0.5, 1.0));
        QVERIFY(
            test::hasProblem(loaded->volume.problems, core::VolumeProblem::Kind::AssumedSpacing));
    }
}

void NrrdReaderTest::fourthAxes_data()
{
    QTest::addColumn<QByteArray>("fields");
    QTest::addColumn<QString>("refusal");
    const auto row = [](const char* name, const QByteArray& fields, const char* refusal) {
        QTest::newRow(name) << fields << QString::fromUtf8(refusal);
    };
    const QByteArray three = "(0.6,0.8,0) (-0.8,0.6,0) (0,0,2.5)";
    row("one list entry",
        "sizes: 1 5 4 3\nkinds: list domain domain domain\nspace: LPS\n"
        "space directions: none "
            + three + "\nspace origin: (-12,34,56.5)\n",
        "");
    row("one point in time",
        "sizes: 5 4 3 1\nspace: left-posterior-superior-time\n"
        "space directions: (0.6,0.8,0,0) (-0.8,0.6,0,0) (0,0,2.5,0) (0,0,0,2)\n"
        "space origin: (-12,34,56.5,0)\n",
        "");
    row("one more axis", "sizes: 5 4 3 1\nspacings: 1 1 2.5 1\n", "");
    row("layers", "sizes: 2 5 4 3\nspace: LPS\nspace directions: none " + three + "\n",
        "it holds 2 values per voxel");
    row("colours", "sizes: 3 5 4 3\nkinds: RGB-color domain domain domain\n",
        "it holds 3 values per voxel");
    row("times", "sizes: 5 4 3 7\nkinds: domain domain domain time\n", "it holds 7 volumes");
    row("unknown", "sizes: 5 4 3 2\n", "it holds 2 volumes");
}

void NrrdReaderTest::fourthAxes()
{
    QFETCH(QByteArray, fields);
    QFETCH(QString, refusal);
    const QByteArray data = storedAs<std::int16_t>(false).repeated(7);
    const bool whole = refusal.isEmpty();
    const core::Result<core::LoadedVolume> loaded =
        openBytes(start + "type: short\ndimension: 4\nendian: little\n" + fields
            + "encoding: raw\n\n" + (whole ? data.left(120) : data));
    QCOMPARE(loaded.has_value(), whole);
    if (!whole) {
        QCOMPARE(loaded.error().code, core::ErrorCode::UnsupportedFormat);
        QCOMPARE(loaded.error().arguments.value(1), refusal);
        return;
    }
    QCOMPARE(loaded->volume.geometry.size, size);
    QVERIFY(std::abs(loaded->volume.geometry.spacingMm().z - 2.5) < 1e-12);
    QCOMPARE(loaded->volume.encoding.value(loaded->codes[59]), double(valueOf(59)));
}

void NrrdReaderTest::masksAreCheckedAgainstTheFile()
{
    compareMasks(soundFile(), soundFile().replace("(-12,", "(-11,"));
}

BURIN_TEST(NrrdReaderTest)

} // namespace nrrdReaderTest

#include "NrrdReaderTest.moc"
