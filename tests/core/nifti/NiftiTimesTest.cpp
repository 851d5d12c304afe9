// SPDX-License-Identifier: Apache-2.0
#include "core/masks/StoredGrid.h"
#include "core/nifti/NiftiHeader.h"
#include "core/sessionfile/records/SessionSource.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/NrrdFiles.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/series/VolumeFiles.h"

#include <QDir>
#include <QTest>

#include <cstring>

namespace niftiTimesTest {

namespace {

constexpr glm::ivec3 size(4, 3, 2);
constexpr int voxels = 24;
constexpr int times = 3;
constexpr int atDim = 40;

std::int16_t valueOf(int voxel, int time)
{
    return std::int16_t(1000 * time + 7 * voxel - 30);
}

/// Three volumes, one after the other.
QByteArray fileInTime()
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    const core::NiftiHeader header =
        core::makeNiftiHeader(geometry, core::NiftiHeader::DataType::Int16, "test");
    QByteArray bytes(header.bytes.data(), qsizetype(header.bytes.size()));
    const std::int16_t dimensions = 4;
    const std::int16_t count = times;
    std::memcpy(bytes.data() + atDim, &dimensions, sizeof dimensions);
    std::memcpy(bytes.data() + atDim + 8, &count, sizeof count);
    for (int time = 0; time < times; ++time) {
        for (int voxel = 0; voxel < voxels; ++voxel) {
            const std::int16_t value = valueOf(voxel, time);
            bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
    }
    return bytes;
}

} // namespace

/// NIfTI files of several volumes, which are points in time.
class NiftiTimesTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

private Q_SLOTS:
    void init() { makeFolder(); }

    void everyPointHasItsValues_data();
    void everyPointHasItsValues();
    void aCutFileKeepsItsFirstPoints();
    void otherPointsAreFoundFromTheVolume();
    void masksAreOfOneMoment();
};

void NiftiTimesTest::everyPointHasItsValues_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("plain") << QStringLiteral("times.nii");
    QTest::newRow("packed") << QStringLiteral("times.nii.gz");
    // As before a repair, or a point in time.
    QTest::newRow("signs") << QStringLiteral("a+b@2.nii");
}

void NiftiTimesTest::everyPointHasItsValues()
{
    QFETCH(QString, name);
    const bool isPacked = name.endsWith(QLatin1String(".gz"));
    const QString file = put(name, isPacked ? test::nrrd::gzipped(fileInTime()) : fileInTime());
    const core::Result<core::Study> study = core::Study::scan(file);
    QVERIFY(study);
    QCOMPARE(study->listing().candidates().size(), std::size_t(1));
    const core::SeriesEntry& entry = *study->listing().candidates().front();
    QCOMPARE(entry.times.size(), times);
    QCOMPARE(entry.geometry.size, size);
    for (int time = 0; time < times; ++time) {
        const core::Result<core::LoadedVolume> loaded = study->load(entry.keyAtTime(time));
        VERIFY_DONE(loaded);
        QCOMPARE(loaded->volume.geometry.size, size);
        QCOMPARE(loaded->codes.size(), std::size_t(voxels));
        for (int voxel = 0; voxel < voxels; ++voxel) {
            QCOMPARE(loaded->volume.encoding.value(loaded->codes[std::size_t(voxel)]),
                double(valueOf(voxel, time)));
        }
        QCOMPARE(loaded->volume.seriesKey, entry.keyAtTime(time));
        QCOMPARE(core::SessionSource::of(loaded->volume).time, time + 1);
        const QString told =
            test::problemText(loaded->volume.problems, core::VolumeProblem::Kind::MixedSlices);
        QVERIFY2(told.contains(QStringLiteral("this is point %1").arg(time + 1)), qPrintable(told));
        QVERIFY(!loaded->volume.needsCaution());
    }
    const core::Result<core::LoadedVolume> none = study->load(entry.keyAtTime(times));
    QVERIFY(!none);
    QCOMPARE(none.error().code, core::ErrorCode::SeriesNotFound);
}

void NiftiTimesTest::aCutFileKeepsItsFirstPoints()
{
    const QString file = put(QStringLiteral("times.nii"), fileInTime().chopped(10));
    QVERIFY(core::loadVolume(file));
    QVERIFY(core::loadVolume(file, QStringLiteral("times.nii@2")));
    const core::Result<core::LoadedVolume> cut =
        core::loadVolume(file, QStringLiteral("times.nii@3"));
    QVERIFY(!cut);
    QCOMPARE(cut.error().code, core::ErrorCode::FileTruncated);
}

/// The volume tells of its file, not of the folder above it that was opened.
void NiftiTimesTest::otherPointsAreFoundFromTheVolume()
{
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("inner")));
    put(QStringLiteral("inner/times.nii"), fileInTime());
    const core::Result<core::LoadedVolume> first = core::loadVolume(m_folder->path());
    VERIFY_DONE(first);
    QVERIFY(first->volume.alternatives);
    QCOMPARE(first->volume.alternatives->times.size(), times);
    const core::Result<core::LoadedVolume> second = core::loadVolume(
        first->volume.sourcePath, first->volume.alternatives->key + QStringLiteral("@2"));
    VERIFY_DONE(second);
    QCOMPARE(second->volume.encoding.value(second->codes.front()), double(valueOf(0, 1)));
    QCOMPARE(second->volume.alternatives->time, 1);
}

void NiftiTimesTest::masksAreOfOneMoment()
{
    const core::Result<core::StoredGrid> grid =
        core::readStoredGrid(put(QStringLiteral("times.nii"), fileInTime()), core::Progress());
    QVERIFY(!grid);
    QCOMPARE(grid.error().code, core::ErrorCode::UnsupportedFormat);
    QCOMPARE(grid.error().arguments.value(1), QStringLiteral("it holds 3 volumes"));
}

BURIN_TEST(NiftiTimesTest)

} // namespace niftiTimesTest

#include "NiftiTimesTest.moc"
