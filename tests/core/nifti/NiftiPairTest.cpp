// SPDX-License-Identifier: Apache-2.0
#include "core/nifti/NiftiHeader.h"
#include "core/study/FileFormats.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/NrrdFiles.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/series/VolumeFiles.h"

#include <QTest>

#include <cstring>

namespace niftiPairTest {

namespace {

constexpr glm::ivec3 size(5, 4, 3);
constexpr int atVoxelOffset = 108;
constexpr int atMagic = 344;
constexpr int headerSize = 348;

core::VolumeGeometry geometry()
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.indexToWorld[0] = {0.5, 0.0, 0.0, 0.0};
    geometry.indexToWorld[1] = {0.0, 0.75, 0.0, 0.0};
    geometry.indexToWorld[2] = {0.0, 0.0, 2.5, 0.0};
    geometry.indexToWorld[3] = {-12.0, 34.0, 56.0, 1.0};
    return geometry;
}

QByteArray voxelBytes()
{
    QByteArray bytes;
    for (int voxel = 0; voxel < size.x * size.y * size.z; ++voxel) {
        const auto value = std::int16_t(3 * voxel - 50);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return bytes;
}

/// The header of a single file.
QByteArray fileHeader()
{
    const core::NiftiHeader header =
        core::makeNiftiHeader(geometry(), core::NiftiHeader::DataType::Int16, "test");
    return {header.bytes.data(), qsizetype(header.bytes.size())};
}

/// The same for voxels in a file of their own, from its beginning.
QByteArray pairHeader(const char* magic = "ni1")
{
    QByteArray bytes = fileHeader().left(headerSize);
    std::memset(bytes.data() + atVoxelOffset, 0, sizeof(float));
    std::memcpy(bytes.data() + atMagic, magic, 4);
    return bytes;
}

} // namespace

/// NIfTI volumes whose header and voxels are two files.
class NiftiPairTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

private Q_SLOTS:
    void init() { makeFolder(); }

    void likeTheSingleFile_data();
    void likeTheSingleFile();
    void aFolderOfOne();
    void missingVoxelsAreNamed();
    void analyzeIsRefused();
    void headersOfOthersAreNoNifti();
};

void NiftiPairTest::likeTheSingleFile_data()
{
    QTest::addColumn<QString>("header");
    QTest::addColumn<QString>("voxels");
    QTest::newRow("plain") << QStringLiteral("pair.hdr") << QStringLiteral("pair.img");
    QTest::newRow("packed") << QStringLiteral("pair.hdr") << QStringLiteral("pair.img.gz");
    QTest::newRow("capitals") << QStringLiteral("PAIR.HDR") << QStringLiteral("PAIR.IMG");
}

void NiftiPairTest::likeTheSingleFile()
{
    QFETCH(QString, header);
    QFETCH(QString, voxels);
    const bool isPacked = voxels.endsWith(QLatin1String(".gz"));
    put(voxels, isPacked ? test::nrrd::gzipped(voxelBytes()) : voxelBytes());
    const core::Result<core::LoadedVolume> pair = opened(header, pairHeader());
    VERIFY_DONE(pair);
    const core::Result<core::LoadedVolume> single =
        opened(QStringLiteral("single.nii"), fileHeader() + voxelBytes());
    VERIFY_DONE(single);
    QCOMPARE(pair->volume.geometry.size, size);
    QCOMPARE(pair->volume.geometry.indexToWorld, single->volume.geometry.indexToWorld);
    QCOMPARE(pair->volume.voxelsSha256, single->volume.voxelsSha256);
    QVERIFY(pair->codes == single->codes);
    QVERIFY(pair->volume.problems.empty());
}

/// Its file of voxels is none that nothing is known of.
void NiftiPairTest::aFolderOfOne()
{
    put(QStringLiteral("pair.img"), voxelBytes());
    put(QStringLiteral("pair.hdr"), pairHeader());
    const core::Result<core::Study> study = core::Study::scan(m_folder->path());
    QVERIFY(study);
    QVERIFY(study->listing().unreadable.empty());
    QCOMPARE(study->listing().candidates().size(), std::size_t(1));
    QCOMPARE(study->listing().candidates().front()->key, QStringLiteral("pair.hdr"));
    const core::Result<core::LoadedVolume> loaded = study->load();
    VERIFY_DONE(loaded);
    QCOMPARE(loaded->volume.sourcePath, m_folder->filePath(QStringLiteral("pair.hdr")));
}

void NiftiPairTest::missingVoxelsAreNamed()
{
    // A volume of that name is another one.
    put(QStringLiteral("pair.nii"), fileHeader() + voxelBytes());
    const core::Result<core::LoadedVolume> missing =
        opened(QStringLiteral("pair.hdr"), pairHeader());
    QVERIFY(!missing);
    QCOMPARE(missing.error().code, core::ErrorCode::FileUnreadable);
    QVERIFY(missing.error().arguments.value(0).endsWith(QLatin1String("pair.hdr")));
    QVERIFY(missing.error().arguments.value(1).contains(QLatin1String("pair.img")));

    put(QStringLiteral("pair.img"), voxelBytes().chopped(2));
    const core::Result<core::LoadedVolume> cut =
        core::loadVolume(m_folder->filePath(QStringLiteral("pair.hdr")));
    QVERIFY(!cut);
    QCOMPARE(cut.error().code, core::ErrorCode::FileTruncated);
    QVERIFY(cut.error().arguments.value(1).contains(QLatin1String("pair.img")));
}

void NiftiPairTest::analyzeIsRefused()
{
    put(QStringLiteral("old.img"), voxelBytes());
    const core::Result<core::LoadedVolume> loaded =
        opened(QStringLiteral("old.hdr"), pairHeader("\0\0\0"));
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY(loaded.error().arguments.value(1).contains(QLatin1String("Analyze 7.5")));
}

void NiftiPairTest::headersOfOthersAreNoNifti()
{
    QVERIFY(core::fileFormatOf(put(QStringLiteral("envi.hdr"), "ENVI\nsamples = 5\n")) == nullptr);
    QVERIFY(core::fileFormatOf(put(QStringLiteral("short.hdr"), "\x5c\x01")) == nullptr);
    QVERIFY(core::fileFormatOf(put(QStringLiteral("pair.hdr"), pairHeader())) != nullptr);
}

BURIN_TEST(NiftiPairTest)

} // namespace niftiPairTest

#include "NiftiPairTest.moc"
