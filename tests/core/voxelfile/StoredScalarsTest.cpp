// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/StoredScalars.h"

#include "core/nifti/NiftiHeader.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/NrrdFiles.h"
#include "tests/support/series/OpenedVolume.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace storedScalarsTest {

using namespace core;

namespace {

/// One of the numbers of /proc/self/status, in KiB; −1: it is not there.
qint64 statusKib(const char* name)
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return -1;
    for (const QByteArray& line : status.readAll().split('\n')) {
        if (line.startsWith(name))
            return line.simplified().split(' ').value(1).toLongLong();
    }
    return -1;
}

/// The most memory that this process had is what it has now.
bool forgetPeak()
{
    QFile file(QStringLiteral("/proc/self/clear_refs"));
    return file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) && file.write("5") == 1;
}

/// Large enough that nothing else counts beside it: 128 MiB of codes.
VolumeGeometry largeGrid()
{
    VolumeGeometry geometry;
    geometry.size = {512, 512, 256};
    return geometry;
}

QByteArray niftiHeader(NiftiHeader::DataType type)
{
    const NiftiHeader header = makeNiftiHeader(largeGrid(), type, {}, false);
    return {header.bytes.data(), qsizetype(header.bytes.size())};
}

} // namespace

class StoredScalarsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Room for bytes lies behind the codes that are made of them first: every one of them is read
    /// before its place is written to.
    void bytesBecomeCodesInPlace_data()
    {
        QTest::addColumn<int>("voxels");
        for (const int voxels : {1, 2, 3, 7, 1000, 4099})
            QTest::addRow("%d voxels", voxels) << voxels;
    }
    void bytesBecomeCodesInPlace()
    {
        QFETCH(int, voxels);
        for (const ScalarType type : {ScalarType::UInt8, ScalarType::Int8}) {
            LoadedVolume loaded;
            loaded.volume.geometry.size = {voxels, 1, 1};
            const std::span<char> room = roomForScalars(loaded, type);
            QCOMPARE(room.size(), std::size_t(voxels));
            for (int voxel = 0; voxel < voxels; ++voxel)
                room[std::size_t(voxel)] = char(voxel * 37);
            encodeScalarsInRoom(loaded, type, 2.0, -3.0, false);
            QCOMPARE(loaded.codes.size(), std::size_t(voxels));
            for (int voxel = 0; voxel < voxels; ++voxel) {
                const int stored = type == ScalarType::Int8 ? int(std::int8_t(voxel * 37))
                                                            : int(std::uint8_t(voxel * 37));
                QCOMPARE(test::valueAt(loaded, {voxel, 0, 0}), 2.0 * stored - 3.0);
            }
        }
    }

    /// A study of up to 16 bits is opened without being in memory twice.
    void volumesAreInMemoryOnce_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<int>("bytesPerVoxel");
        QTest::newRow("NRRD, bytes")
            << QStringLiteral("bytes.nrrd") << test::nrrd::onGrid(largeGrid(), "uchar", {}) << 1;
        QTest::newRow("NRRD, 16 bits")
            << QStringLiteral("words.nrrd") << test::nrrd::onGrid(largeGrid(), "short", {}) << 2;
        QTest::newRow("NIfTI, bytes")
            << QStringLiteral("bytes.nii") << niftiHeader(NiftiHeader::DataType::UInt8) << 1;
        QTest::newRow("NIfTI, 16 bits")
            << QStringLiteral("words.nii") << niftiHeader(NiftiHeader::DataType::Int16) << 2;
    }
    void volumesAreInMemoryOnce()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, header);
        QFETCH(int, bytesPerVoxel);
        if (test::underSanitizer)
            QSKIP("a sanitizer has memory of its own beside the program's");
        const QTemporaryDir folder;
        const glm::ivec3 size = largeGrid().size;
        const qint64 voxels = qint64(largeGrid().voxelCount());
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(header), header.size());
        QCOMPARE(file.write(QByteArray(1, '\x07')), 1);
        // Nothing in between is on the disk.
        QVERIFY(file.resize(header.size() + voxels * bytesPerVoxel));
        QVERIFY(file.seek(header.size() + (voxels - 1) * bytesPerVoxel));
        QCOMPARE(file.write(QByteArray(1, '\x64')), 1);
        file.close();

        QVERIFY(forgetPeak());
        const qint64 before = statusKib("VmRSS:");
        QVERIFY(before > 0);
        const Result<LoadedVolume> loaded = loadVolume(file.fileName());
        QVERIFY2(loaded, loaded ? "" : qPrintable(test::errorText(loaded.error())));
        const qint64 taken = statusKib("VmHWM:") - before;
        const qint64 codes = voxels * 2 / 1024;
        QCOMPARE(test::valueAt(*loaded, {0, 0, 0}), 7.0);
        QCOMPARE(test::valueAt(*loaded, size / 2), 0.0);
        QCOMPARE(test::valueAt(*loaded, size - 1), 100.0);
        QVERIFY2(taken >= codes, qPrintable(QStringLiteral("%1 KiB were measured").arg(taken)));
        QVERIFY2(taken < codes + codes / 4,
            qPrintable(QStringLiteral("%1 KiB for %2 of codes").arg(taken).arg(codes)));
    }
};

BURIN_TEST(StoredScalarsTest)

} // namespace storedScalarsTest

#include "StoredScalarsTest.moc"
