// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskOnVolume.h"

#include "core/masks/ReadImport.h"
#include "core/nifti/NiftiWriter.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace maskOnVolumeTest {

using namespace core;

namespace {

/// A folder of masks on the grid of the small study, as networks write them.
class MaskFolder {
public:
    MaskFolder() { QDir(m_folder.path()).mkdir(QStringLiteral("segmentations")); }

    [[nodiscard]] QString path() const
    {
        return m_folder.filePath(QStringLiteral("segmentations"));
    }
    [[nodiscard]] QString path(const QString& name) const { return path() + u'/' + name; }
    /// The label in a box, 0 elsewhere. An empty box: no voxel has a label.
    void add(const QString& name, const VoxelBox& box, std::uint8_t label = 1) const
    {
        const VolumeGeometry& geometry = test::smallGrid();
        std::vector<std::uint8_t> labels(geometry.voxelCount(), 0);
        for (int z = box.minimum.z; z < box.maximum.z; ++z)
            for (int y = box.minimum.y; y < box.maximum.y; ++y)
                for (int x = box.minimum.x; x < box.maximum.x; ++x)
                    labels[test::smallIndexOf({x, y, z})] = label;
        QVERIFY(writeNifti(path(name), {.geometry = geometry, .voxels = labels}, false));
    }
    void addImage(const QString& name, const std::vector<std::int16_t>& values) const
    {
        QVERIFY(writeNifti(path(name), {.geometry = test::smallGrid(), .voxels = values}, false));
    }
    void addText(const QString& name, const QByteArray& text) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
    [[nodiscard]] Result<MaskOnVolume> read() const
    {
        return readMask(path(), test::smallStudy().volume, {});
    }

private:
    QTemporaryDir m_folder;
};

constexpr VoxelBox liver{{2, 3, 4}, {15, 9, 8}};
constexpr VoxelBox spleen{{14, 3, 4}, {20, 9, 8}}; // it shares a plane of voxels with the liver
constexpr VoxelBox nowhere{{0, 0, 0}, {0, 0, 0}};

} // namespace

/// Masks of which each structure lies in a file of its own.
class MaskOnVolumeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aFolderIsOneMask()
    {
        const MaskFolder folder;
        folder.add(QStringLiteral("spleen.nii"), spleen);
        folder.add(QStringLiteral("liver.nii"), liver, 7);
        folder.add(QStringLiteral("brain.nii"), nowhere);
        folder.addText(QStringLiteral("statistics.json"), "{}");
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("preview.nii"))); // a folder, no file
        const Result<MaskOnVolume> mask = folder.read();
        QVERIFY(mask);
        QCOMPARE(mask->segments.size(), std::size_t(2));
        QCOMPARE(mask->segments[0].name, QStringLiteral("liver"));
        QCOMPARE(mask->segments[1].name, QStringLiteral("spleen"));
        QCOMPARE(mask->segments[0].voxels.voxelCount(), std::uint64_t(13 * 6 * 4));
        QCOMPARE(mask->segments[1].voxels.voxelCount(), std::uint64_t(6 * 6 * 4));
        QCOMPARE(mask->overlaps.size(), std::size_t(1));
        QCOMPARE(voxelsOf(mask->overlaps), std::uint64_t(6 * 4));
        const std::vector<MaskNote> notes{
            {.code = MaskNote::Code::FilesWithoutVoxel, .some = 1, .all = 3},
            {.code = MaskNote::Code::SegmentsOverlap, .some = 6 * 4}};
        QCOMPARE(mask->notes, notes);
    }

    void anImportKeepsTheOverlapsOfItsFiles()
    {
        const MaskFolder folder;
        folder.add(QStringLiteral("spleen.nii"), spleen);
        folder.add(QStringLiteral("liver.nii"), liver);
        const Result<ReadImport> read =
            readImport(ImportMask{.file = folder.path() + u'/'}, test::smallStudy().volume, 0, {});
        QVERIFY(read);
        QCOMPARE(read->edit.file, QStringLiteral("segmentations"));
        QCOMPARE(*read->edit.planes, (std::vector<int>{0, 1}));
    }

    /// The same said of many files is said once.
    void notesAreAddedUp()
    {
        const MaskFolder folder;
        VolumeGeometry moved = test::smallGrid();
        moved.indexToWorld[3] += glm::dvec4(1.0, 0.0, 0.0, 0.0); // by a voxel
        std::vector<std::uint8_t> labels(moved.voxelCount(), 1);
        for (const char* name : {"a.nii", "b.nii", "c.nii"})
            QVERIFY(writeNifti(
                folder.path(QLatin1String(name)), {.geometry = moved, .voxels = labels}, false));
        const Result<MaskOnVolume> mask = folder.read();
        QVERIFY(mask);
        const auto outside = std::count_if(mask->notes.begin(), mask->notes.end(),
            [](const MaskNote& note) { return note.code == MaskNote::Code::OutsideStudy; });
        QCOMPARE(outside, std::ptrdiff_t(1));
        for (const MaskNote& note : mask->notes) {
            if (note.code != MaskNote::Code::OutsideStudy)
                continue;
            QCOMPARE(note.some, std::uint64_t(3 * 36 * 34));
            QCOMPARE(note.all, std::uint64_t(3 * 40 * 36 * 34));
        }
    }

    void whatIsNoMaskIsRefused()
    {
        const MaskFolder folder;
        const auto refusal = [&folder] {
            const Result<MaskOnVolume> mask = folder.read();
            return mask ? QString() : mask.error().arguments.join(QStringLiteral(": "));
        };
        QVERIFY(refusal().contains(QStringLiteral("no mask file lies in this folder")));
        QVERIFY(refusal().startsWith(folder.path()));
        folder.add(QStringLiteral("brain.nii"), nowhere);
        QVERIFY(refusal().contains(QStringLiteral("wholly outside the study")));
        folder.add(QStringLiteral("liver.nii"), liver);
        QCOMPARE(refusal(), QString());
        // One that cannot be read is named; nothing of the others is taken.
        folder.addText(QStringLiteral("spleen.nii"), "no NIfTI at all");
        QVERIFY2(
            refusal().startsWith(folder.path(QStringLiteral("spleen.nii"))), qPrintable(refusal()));
    }

    /// The study itself and other images often lie beside the masks.
    void imagesBesideMasksAreLeftOut()
    {
        const MaskFolder folder;
        std::vector<std::int16_t> values(test::smallGrid().voxelCount());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = std::int16_t(i % 1000); // more values than there can be labels
        folder.addImage(QStringLiteral("mr.nii"), values);
        values[7] = -1000; // no label
        folder.addImage(QStringLiteral("ct.nii"), values);
        const Result<MaskOnVolume> images = folder.read();
        QVERIFY(!images);
        QCOMPARE(QString(images.error().arguments[0]), folder.path(QStringLiteral("ct.nii")));
        const test::SyntheticSeries slices{.size = {8, 8, 3},
            .fileName = [](int k) { return QStringLiteral("slice%1.dcm").arg(k); }};
        QCOMPARE(test::writeSeries(slices, folder.path()).size(), 3);
        folder.add(QStringLiteral("liver.nii"), liver);
        const Result<MaskOnVolume> mask = folder.read();
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        QCOMPARE(mask->segments.size(), std::size_t(1));
        const std::vector<MaskNote> notes{
            {.code = MaskNote::Code::ImagesLeftOut,
                .names = {QStringLiteral("ct.nii"), QStringLiteral("mr.nii")}},
            {.code = MaskNote::Code::SlicesLeftOut, .some = 3}};
        QCOMPARE(mask->notes, notes);
    }

    /// One that is damaged, or was resampled linearly, is no image: it is named, and nothing of
    /// the others is taken.
    void aDamagedMaskIsNoImage()
    {
        const MaskFolder folder;
        folder.add(QStringLiteral("liver.nii"), liver);
        std::vector<std::int16_t> values(test::smallGrid().voxelCount(), 0);
        for (std::size_t i = 1000; i < 3000; ++i)
            values[i] = 1;
        values[2000] = -1;
        folder.addImage(QStringLiteral("spleen.nii"), values);
        const Result<MaskOnVolume> mask = folder.read();
        QVERIFY(!mask);
        QCOMPARE(QString(mask.error().arguments[0]), folder.path(QStringLiteral("spleen.nii")));
        QCOMPARE(QString(mask.error().arguments[1]),
            QStringLiteral("its values are not labels: -1 is among them"));
    }

    /// What is neither image nor mask is refused by name.
    void otherDicomIsRefused()
    {
        const MaskFolder folder;
        folder.add(QStringLiteral("liver.nii"), liver);
        const test::SyntheticSeries plans{.size = {8, 8, 1},
            .fileName = [](int) { return QStringLiteral("plan.dcm"); },
            .adjust =
                [](DcmDataset& set, int) {
                    set.putAndInsertString(DCM_SOPClassUID, "1.2.840.10008.5.1.4.1.1.481.5");
                }};
        QCOMPARE(test::writeSeries(plans, folder.path()).size(), 1);
        const Result<MaskOnVolume> mask = folder.read();
        QVERIFY(!mask);
        QCOMPARE(QString(mask.error().arguments[0]), folder.path(QStringLiteral("plan.dcm")));
    }

    void aFolderHasNoMoreSegmentsThanASession()
    {
        const MaskFolder folder;
        for (int i = 0; i < 256; ++i)
            folder.add(QStringLiteral("part%1.nii").arg(i, 3, 10, QLatin1Char('0')),
                {{i % 40, 3, 4}, {i % 40 + 1, 4, 5}});
        const Result<MaskOnVolume> mask = folder.read();
        QVERIFY(!mask);
        QVERIFY(mask.error().arguments.value(1).contains(QStringLiteral("more than 255 segments")));
    }

    void givingUpEndsBetweenFiles()
    {
        const MaskFolder folder;
        folder.add(QStringLiteral("liver.nii"), liver);
        folder.add(QStringLiteral("spleen.nii"), spleen);
        Progress* told = nullptr;
        Progress progress([&told](ProgressStep, int done, int) {
            if (done == 1)
                told->cancel();
        });
        told = &progress;
        const Result<MaskOnVolume> mask =
            readMask(folder.path(), test::smallStudy().volume, progress);
        QVERIFY(!mask);
        QVERIFY(mask.error().code == ErrorCode::Cancelled);
    }
};

BURIN_TEST(MaskOnVolumeTest)

} // namespace maskOnVolumeTest

#include "MaskOnVolumeTest.moc"
