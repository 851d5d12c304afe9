// SPDX-License-Identifier: Apache-2.0
#include "core/nifti/NiftiHeader.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace niftiReaderTest {

namespace {

// Offsets of nifti1.h that a test changes.
constexpr int atDim = 40;
constexpr int atDataType = 70;
constexpr int atBitsPerVoxel = 72;
constexpr int atSlope = 112;
constexpr int atIntercept = 116;
constexpr int atUnits = 123;
constexpr int atQformCode = 252;
constexpr int atSformCode = 254;

constexpr glm::ivec3 size(5, 4, 3);

core::VolumeGeometry obliqueGeometry(double mirror = 1.0)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    const double c = std::cos(0.3);
    const double s = std::sin(0.3);
    geometry.indexToWorld[0] = {0.7 * c, 0.7 * s, 0.0, 0.0};
    geometry.indexToWorld[1] = {-0.9 * s, 0.9 * c, 0.0, 0.0};
    geometry.indexToWorld[2] = {0.0, 0.0, 2.5 * mirror, 0.0};
    geometry.indexToWorld[3] = {-12.0, 34.0, 56.0, 1.0};
    return geometry;
}

template <class T> void put(QByteArray& bytes, int offset, T value)
{
    std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

/// A file of the given type whose voxel n holds value(n).
template <class T>
QByteArray makeNifti(std::int16_t type, const core::VolumeGeometry& geometry, T (*value)(int))
{
    const core::NiftiHeader header =
        core::makeNiftiHeader(geometry, core::NiftiHeader::DataType::Int16, "test");
    QByteArray bytes(header.bytes.data(), qsizetype(header.bytes.size()));
    put<std::int16_t>(bytes, atDataType, type);
    put<std::int16_t>(bytes, atBitsPerVoxel, std::int16_t(8 * sizeof(T)));
    for (int voxel = 0; voxel < size.x * size.y * size.z; ++voxel) {
        const T one = value(voxel);
        bytes.append(reinterpret_cast<const char*>(&one), sizeof(T));
    }
    return bytes;
}

double valueAt(const core::LoadedVolume& loaded, std::size_t voxel)
{
    return loaded.volume.encoding.value(loaded.codes.at(voxel));
}

bool sameAffine(const glm::dmat4& a, const glm::dmat4& b, double tolerance)
{
    for (int column = 0; column < 4; ++column) {
        if (glm::length(a[column] - b[column]) > tolerance)
            return false;
    }
    return true;
}

glm::dmat4 lpsMatrix(const QJsonValue& ras)
{
    glm::dmat4 matrix(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            const double value = ras.toArray()[row].toArray()[column].toDouble();
            matrix[column][row] = row < 2 ? -value : value;
        }
    }
    return matrix;
}

template <class T> QByteArray hashAs(const core::LoadedVolume& loaded)
{
    std::vector<T> values;
    for (std::size_t voxel = 0; voxel < loaded.codes.size(); ++voxel)
        values.push_back(T(valueAt(loaded, voxel)));
    return QCryptographicHash::hash(QByteArrayView(reinterpret_cast<const char*>(values.data()),
                                        qsizetype(values.size() * sizeof(T))),
        QCryptographicHash::Sha256)
        .toHex();
}

} // namespace

/// NIfTI volumes: their place, their values, their refusals.
/// The most that this program has had.
long peakMemoryKb()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

class NiftiReaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sharedVolumesMatch_data();
    void sharedVolumesMatch();
    void placeFromSformQformOrNeither();
    void leftHandedGridsKeepTheirOrder();
    void unitsBecomeMillimetres();
    void scaledValues();
    void wideIntegersStayExact();
    void fractionsStateTheirError();
    void notANumberIsTold();
    void theLargestNumberMarksWhatIsMissing();
    void whatHardlyDiffersIsTheSame();
    void damagedFilesAreNamed();
    void whatItCannotHoldIsNotAskedOfMemory();
    void compressedLikePlain();
    void nextToDicomOnlyByName();

private:
    core::Result<core::LoadedVolume> openBytes(
        const QByteArray& bytes, const QString& name = QStringLiteral("test.nii"))
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
        file.close();
        return core::loadVolume(file.fileName());
    }

    QTemporaryDir m_folder;
};

void NiftiReaderTest::sharedVolumesMatch_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QJsonObject>("facts");
    if (test::sharedDataFolder().isEmpty())
        QTest::newRow("no shared data") << QString() << QJsonObject();
    for (const char* name : {"mr_spine_t2_cord", "mr_brain_ch2_atlases", "mr_brain_mricrop_itksnap",
             "ct_totalseg_body_3mm", "ct_cranium_inv3", "ct_abdomen_j2k_organs"}) {
        const test::SharedCase data = test::sharedCase(QString::fromLatin1(name));
        for (const char* list : {"volumes", "labels"}) {
            for (const QJsonValue& facts : data.expected[QLatin1String(list)].toArray()) {
                const QString file = facts[QStringLiteral("file")].toString();
                if (!file.endsWith(QLatin1String(".nii.gz")))
                    continue;
                QTest::newRow(qPrintable(QString::fromLatin1(name) + QLatin1Char('/') + file))
                    << data.source + QLatin1Char('/') + file << facts.toObject();
            }
        }
    }
}

void NiftiReaderTest::sharedVolumesMatch()
{
    QFETCH(QString, path);
    QFETCH(QJsonObject, facts);
    if (path.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(path);
    QVERIFY(loaded);
    const core::Volume& volume = loaded->volume;
    const QJsonArray dims = facts[QStringLiteral("dims_i_j_k")].toArray();
    QCOMPARE(volume.geometry.size, glm::ivec3(dims[0].toInt(), dims[1].toInt(), dims[2].toInt()));
    const glm::dmat4 expected = lpsMatrix(facts[QStringLiteral("affine_ijk_to_ras_mm")]);
    QVERIFY(sameAffine(volume.geometry.indexToWorld, expected, 1e-5));
    const QJsonObject rescaled = facts[QStringLiteral("rescaled")].toObject();
    QCOMPARE(float(volume.minimum), float(rescaled[QStringLiteral("min")].toDouble()));
    QCOMPARE(float(volume.maximum), float(rescaled[QStringLiteral("max")].toDouble()));
    QCOMPARE(volume.encoding.maxError, 0.0);
    const QString type = facts[QStringLiteral("dtype")].toString();
    const QByteArray hash = facts[QStringLiteral("voxel_block_sha256")].toString().toLatin1();
    if (type == QLatin1String("uint8"))
        QCOMPARE(hashAs<std::uint8_t>(*loaded), hash);
    else if (type == QLatin1String("int16"))
        QCOMPARE(hashAs<std::int16_t>(*loaded), hash);
    else if (type == QLatin1String("uint16"))
        QCOMPARE(hashAs<std::uint16_t>(*loaded), hash);
    else if (type == QLatin1String("int32"))
        QCOMPARE(hashAs<std::int32_t>(*loaded), hash);
    else if (type == QLatin1String("float32"))
        QCOMPARE(hashAs<float>(*loaded), hash);
    else
        QFAIL(qPrintable(type));
}

void NiftiReaderTest::placeFromSformQformOrNeither()
{
    const core::VolumeGeometry geometry = obliqueGeometry();
    QByteArray bytes = makeNifti<std::int16_t>(4, geometry, [](int n) { return std::int16_t(n); });
    put<std::int16_t>(bytes, atQformCode, 0);
    const core::Result<core::LoadedVolume> bySform = openBytes(bytes);
    QVERIFY(bySform);
    QVERIFY(sameAffine(bySform->volume.geometry.indexToWorld, geometry.indexToWorld, 1e-5));
    QVERIFY(!bySform->volume.needsCaution());

    put<std::int16_t>(bytes, atQformCode, 1);
    put<std::int16_t>(bytes, atSformCode, 0);
    const core::Result<core::LoadedVolume> byQform = openBytes(bytes);
    QVERIFY(byQform);
    QVERIFY(sameAffine(byQform->volume.geometry.indexToWorld, geometry.indexToWorld, 1e-4));

    put<std::int16_t>(bytes, atQformCode, 0);
    const core::Result<core::LoadedVolume> byNeither = openBytes(bytes);
    QVERIFY(byNeither);
    const glm::dvec3 spacing = byNeither->volume.geometry.spacingMm();
    QVERIFY(glm::length(spacing - glm::dvec3(0.7, 0.9, 2.5)) < 1e-6);
    QVERIFY(byNeither->volume.needsCaution());
}

void NiftiReaderTest::leftHandedGridsKeepTheirOrder()
{
    const core::VolumeGeometry geometry = obliqueGeometry(-1.0);
    QVERIFY(glm::determinant(glm::dmat3(geometry.indexToWorld)) < 0.0);
    const core::Result<core::LoadedVolume> loaded = openBytes(
        makeNifti<std::int16_t>(4, geometry, [](int n) { return std::int16_t(3 * n - 50); }));
    QVERIFY(loaded);
    QVERIFY(sameAffine(loaded->volume.geometry.indexToWorld, geometry.indexToWorld, 1e-5));
    for (int voxel = 0; voxel < size.x * size.y * size.z; ++voxel)
        QCOMPARE(valueAt(*loaded, std::size_t(voxel)), 3.0 * voxel - 50.0);
}

void NiftiReaderTest::unitsBecomeMillimetres()
{
    QByteArray bytes =
        makeNifti<std::int16_t>(4, obliqueGeometry(), [](int n) { return std::int16_t(n); });
    put<char>(bytes, atUnits, 3);
    const core::Result<core::LoadedVolume> micrometres = openBytes(bytes);
    QVERIFY(micrometres);
    QVERIFY(std::abs(micrometres->volume.geometry.spacingMm().z - 0.0025) < 1e-9);
    put<char>(bytes, atUnits, 1);
    const core::Result<core::LoadedVolume> metres = openBytes(bytes);
    QVERIFY(metres);
    QVERIFY(std::abs(metres->volume.geometry.spacingMm().z - 2500.0) < 1e-3);
}

void NiftiReaderTest::scaledValues()
{
    QByteArray bytes =
        makeNifti<std::uint8_t>(2, obliqueGeometry(), [](int n) { return std::uint8_t(4 * n); });
    put<float>(bytes, atSlope, 0.5f);
    put<float>(bytes, atIntercept, -7.0f);
    const core::Result<core::LoadedVolume> loaded = openBytes(bytes);
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.encoding.maxError, 0.0);
    QCOMPARE(valueAt(*loaded, 11), 15.0);
    QCOMPARE(loaded->volume.minimum, -7.0);
    put<float>(bytes, atSlope, 0.0f);
    const core::Result<core::LoadedVolume> unscaled = openBytes(bytes);
    QVERIFY(unscaled);
    QCOMPARE(valueAt(*unscaled, 11), 44.0);
}

void NiftiReaderTest::wideIntegersStayExact()
{
    const core::Result<core::LoadedVolume> loaded = openBytes(makeNifti<std::int32_t>(
        8, obliqueGeometry(), [](int n) { return std::int32_t(1000000 + 1000 * n); }));
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.encoding.maxError, 0.0);
    QCOMPARE(valueAt(*loaded, 59), 1059000.0);
    QCOMPARE(hashAs<float>(*loaded), loaded->volume.voxelsSha256);
    const core::Result<core::LoadedVolume> whole =
        openBytes(makeNifti<float>(16, obliqueGeometry(), [](int n) { return float(n - 20); }));
    QVERIFY(whole);
    QCOMPARE(whole->volume.encoding.maxError, 0.0);
    QVERIFY(whole->volume.problems.empty());
}

void NiftiReaderTest::fractionsStateTheirError()
{
    const auto value = [](int n) { return std::sin(float(n)) * 10.0f; };
    const core::Result<core::LoadedVolume> loaded =
        openBytes(makeNifti<float>(16, obliqueGeometry(), value));
    QVERIFY(loaded);
    const core::Volume& volume = loaded->volume;
    QVERIFY(volume.encoding.maxError > 0.0);
    QVERIFY(volume.encoding.maxError <= (volume.maximum - volume.minimum) / 65535.0);
    std::vector<float> exact;
    for (int voxel = 0; voxel < size.x * size.y * size.z; ++voxel) {
        exact.push_back(value(voxel));
        QVERIFY(std::abs(valueAt(*loaded, std::size_t(voxel)) - double(exact.back()))
            <= volume.encoding.maxError);
    }
    QCOMPARE(volume.voxelsSha256,
        QCryptographicHash::hash(QByteArrayView(reinterpret_cast<const char*>(exact.data()),
                                     qsizetype(exact.size() * sizeof(float))),
            QCryptographicHash::Sha256)
            .toHex());
    QCOMPARE(volume.problems.size(), std::size_t(1));
    QVERIFY(volume.problems.front().kind == core::VolumeProblem::Kind::InexactValues);
}

void NiftiReaderTest::notANumberIsTold()
{
    const core::Result<core::LoadedVolume> loaded = openBytes(makeNifti<float>(
        16, obliqueGeometry(), [](int n) { return n == 7 ? std::nanf("") : float(n); }));
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.minimum, 0.0);
    QCOMPARE(loaded->volume.maximum, 59.0);
    QCOMPARE(valueAt(*loaded, 7), 0.0);
    QVERIFY(!loaded->volume.problems.empty());
}

void NiftiReaderTest::theLargestNumberMarksWhatIsMissing()
{
    constexpr double most = std::numeric_limits<double>::max();
    const core::Result<core::LoadedVolume> loaded =
        openBytes(makeNifti<double>(64, obliqueGeometry(), [](int n) {
            if (n < 2)
                return n == 0 ? most : -most;
            return double(n);
        }));
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.minimum, 2.0);
    QCOMPARE(loaded->volume.maximum, 59.0);
    QCOMPARE(valueAt(*loaded, 0), 2.0);
    QCOMPARE(valueAt(*loaded, 30), 30.0);
    QVERIFY(!loaded->volume.problems.empty());
}

void NiftiReaderTest::whatHardlyDiffersIsTheSame()
{
    const core::Result<core::LoadedVolume> loaded = openBytes(
        makeNifti<double>(64, obliqueGeometry(), [](int n) { return n == 3 ? 5e-324 : 0.0; }));
    QVERIFY(loaded);
    QCOMPARE(valueAt(*loaded, 3), 0.0);
    QCOMPARE(valueAt(*loaded, 4), 0.0);
}

void NiftiReaderTest::damagedFilesAreNamed()
{
    const QByteArray sound =
        makeNifti<std::int16_t>(4, obliqueGeometry(), [](int n) { return std::int16_t(n); });
    const auto codeOf = [&](const QByteArray& bytes) {
        const core::Result<core::LoadedVolume> loaded = openBytes(bytes);
        if (loaded)
            return core::ErrorCode::Internal;
        return loaded.error().arguments.value(0).endsWith(QLatin1String("test.nii"))
            ? loaded.error().code
            : core::ErrorCode::Internal;
    };
    QCOMPARE(codeOf({}), core::ErrorCode::FileTruncated);
    QCOMPARE(codeOf(sound.left(100)), core::ErrorCode::FileUnreadable);
    QCOMPARE(codeOf(sound.chopped(10)), core::ErrorCode::FileTruncated);
    QCOMPARE(codeOf(QByteArray(2000, 'x')), core::ErrorCode::FileUnreadable);
    QByteArray fiveDimensional = sound;
    put<std::int16_t>(fiveDimensional, atDim, 5);
    put<std::int16_t>(fiveDimensional, atDim + 10, 2);
    QCOMPARE(codeOf(fiveDimensional), core::ErrorCode::UnsupportedFormat);
    QByteArray colour = sound;
    put<std::int16_t>(colour, atDataType, 128);
    QCOMPARE(codeOf(colour), core::ErrorCode::UnsupportedFormat);
    QByteArray flat = sound;
    for (int row = 0; row < 3; ++row)
        put<float>(flat, 280 + 16 * row + 8, 0.0f);
    QCOMPARE(codeOf(flat), core::ErrorCode::InvalidGeometry);
    QByteArray huge = sound;
    for (int axis = 1; axis <= 3; ++axis)
        put<std::int16_t>(huge, atDim + 2 * axis, 32767);
    QVERIFY(codeOf(huge) == core::ErrorCode::OutOfMemory
        || codeOf(huge) == core::ErrorCode::FileTruncated
        || codeOf(huge) == core::ErrorCode::Internal);
    QVERIFY(!openBytes(huge));
}

void NiftiReaderTest::whatItCannotHoldIsNotAskedOfMemory()
{
    // Half a gigabyte is claimed.
    QByteArray claim =
        makeNifti<std::int16_t>(4, obliqueGeometry(), [](int n) { return std::int16_t(n); });
    put<std::int16_t>(claim, atDim + 2, 16384);
    put<std::int16_t>(claim, atDim + 4, 16384);
    put<std::int16_t>(claim, atDim + 6, 1);
    const long before = peakMemoryKb();
    const core::Result<core::LoadedVolume> loaded = openBytes(claim);
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::FileTruncated);
    QVERIFY(peakMemoryKb() - before < (1 << 18));
}

void NiftiReaderTest::compressedLikePlain()
{
    const QByteArray plain =
        makeNifti<std::int16_t>(4, obliqueGeometry(), [](int n) { return std::int16_t(n * n); });
    const QString path = m_folder.filePath(QStringLiteral("packed.nii.gz"));
    const gzFile file = gzopen(QFile::encodeName(path).constData(), "wb");
    QCOMPARE(gzwrite(file, plain.constData(), unsigned(plain.size())), int(plain.size()));
    gzclose(file);
    const core::Result<core::LoadedVolume> packed = core::loadVolume(path);
    const core::Result<core::LoadedVolume> unpacked = openBytes(plain);
    QVERIFY(packed && unpacked);
    QCOMPARE(packed->volume.voxelsSha256, unpacked->volume.voxelsSha256);
    QVERIFY(packed->codes == unpacked->codes);
    QFile cut(path);
    QVERIFY(cut.resize(cut.size() - 20));
    QVERIFY(!core::loadVolume(path));
}

void NiftiReaderTest::nextToDicomOnlyByName()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("ct_abdomen_j2k_organs"));
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::Result<core::StudyListing> listing = core::scanStudies(data.source);
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    QCOMPARE(listing->candidates().front()->slices(), 20);
    QCOMPARE(listing->foreign.front().kind, QStringLiteral("NIfTI file"));
    QVERIFY(core::loadVolume(data.source + QStringLiteral("/labels.nii.gz")));
}

BURIN_TEST(NiftiReaderTest)

} // namespace niftiReaderTest

#include "NiftiReaderTest.moc"
