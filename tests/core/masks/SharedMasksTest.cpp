// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskOnVolume.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <map>

namespace sharedMasksTest {

namespace {

QString messageOf(const core::Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

QString folderOf(const test::SharedCase& shared)
{
    return shared.unpacked.isEmpty() ? shared.source : shared.unpacked;
}

std::map<QString, std::uint64_t> countsOf(const core::MaskOnVolume& mask)
{
    std::map<QString, std::uint64_t> counts;
    for (const core::MaskSegment& segment : mask.segments)
        counts[segment.name] = segment.voxels.voxelCount();
    return counts;
}

} // namespace

/// Masks that other programs made, on the studies that they were made on.
class SharedMasksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// One DICOM SEG and the NRRD that it was made from.
    void segAndItsSource()
    {
        if (!open(QStringLiteral("seg_dcmqi_liver"), QStringLiteral("dicom")))
            return;
        const core::MaskOnVolume seg = read(QStringLiteral("dicom/seg/liver.dcm"));
        QVERIFY(seg.notes.empty());
        QCOMPARE(
            countsOf(seg), (std::map<QString, std::uint64_t>{{QStringLiteral("Liver"), 107098}}));
        const core::MaskOnVolume source = read(QStringLiteral("nrrd/liver_seg.nrrd"));
        QVERIFY(source.notes.empty());
        QCOMPARE(source.segments.front().voxels, seg.segments.front().voxels);
        QCOMPARE(source.segments.front().name, QStringLiteral("liver_seg"));
    }

    void segmentsThatOverlap()
    {
        if (!open(QStringLiteral("seg_dcmqi_liver"), QStringLiteral("dicom")))
            return;
        const core::MaskOnVolume seg = read(QStringLiteral("dicom/seg/partial_overlaps.dcm"));
        const std::map<QString, std::uint64_t> expected{{QStringLiteral("GREEN"), 9602},
            {QStringLiteral("ORANGE"), 11888}, {QStringLiteral("PURPLE"), 10743},
            {QStringLiteral("LIGHT_BLUE"), 6693}, {QStringLiteral("DARK_BLUE"), 4713}};
        QCOMPARE(countsOf(seg), expected);
        QCOMPARE(seg.notes.size(), std::size_t(1));
        QVERIFY(seg.notes.front().code == core::MaskNote::Code::SegmentsOverlap);
        QVERIFY(seg.notes.front().some > 0);
        QCOMPARE(voxelsOf(seg.overlaps), seg.notes.front().some);
        for (const core::MaskOverlap& overlap : seg.overlaps)
            QVERIFY(overlap.segments.size() > 1 && overlap.voxels > 0);
        // What all segments have, less what is one voxel's second and third.
        std::uint64_t all = 0;
        core::VoxelRuns once;
        for (const core::MaskSegment& segment : seg.segments) {
            all += segment.voxels.voxelCount();
            once = united(once, segment.voxels);
        }
        for (const core::MaskOverlap& overlap : seg.overlaps)
            all -= (overlap.segments.size() - 1) * overlap.voxels;
        QCOMPARE(all, once.voxelCount());
        // Each label map holds some of them.
        const std::map<QString, QPair<QString, QString>> where{
            {QStringLiteral("GREEN"), {QStringLiteral("1"), QStringLiteral("Label 1")}},
            {QStringLiteral("ORANGE"), {QStringLiteral("2"), QStringLiteral("partial_overlaps-2")}},
            {QStringLiteral("PURPLE"), {QStringLiteral("3"), QStringLiteral("partial_overlaps-3")}},
            {QStringLiteral("DARK_BLUE"), {QStringLiteral("1"), QStringLiteral("Label 5")}}};
        for (const core::MaskSegment& segment : seg.segments) {
            const auto found = where.find(segment.name);
            if (found == where.end())
                continue;
            const core::MaskOnVolume map =
                read(QStringLiteral("nrrd/partial_overlaps-%1.nrrd").arg(found->second.first));
            const auto same = std::find_if(map.segments.begin(), map.segments.end(),
                [&](const auto& other) { return other.name == found->second.second; });
            QVERIFY2(same != map.segments.end(), qPrintable(segment.name));
            QCOMPARE(segment.voxels, same->voxels);
        }
    }

    /// Thirteen frames for 299 slices, in no order that says where.
    void onlyOccupiedFrames()
    {
        if (!open(QStringLiteral("pet_headneck_seg"), QStringLiteral("dicom")))
            return;
        const core::MaskOnVolume seg =
            read(QStringLiteral("dicom/SEG/tumor_User1_Manual_Trial1.dcm"));
        QCOMPARE(countsOf(seg),
            (std::map<QString, std::uint64_t>{{QStringLiteral("Neoplasm, Primary"), 54},
                {QStringLiteral("Neoplasm, Secondary"), 212}}));
        QVERIFY(seg.notes.empty());
        // Where pydicom has the first and last frames, on slices counted from the lowest.
        const std::uint64_t slice = 128 * 128;
        QCOMPARE(seg.segments[0].voxels.runs().front().first / slice, std::uint64_t(247));
        QCOMPARE((seg.segments[0].voxels.end() - 1) / slice, std::uint64_t(250));
        QCOMPARE(seg.segments[1].voxels.runs().front().first / slice, std::uint64_t(245));
        QCOMPARE((seg.segments[1].voxels.end() - 1) / slice, std::uint64_t(253));
    }

    void labelMaps_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("study");
        QTest::addColumn<QString>("file");
        const auto row = [](const char* name, const char* study, const char* file) {
            QTest::addRow("%s %s", name, file)
                << QString::fromLatin1(name) << QString::fromLatin1(study)
                << QString::fromLatin1(file);
        };
        row("ct_totalseg_body_3mm", "ct_3mm.nii.gz", "ct_3mm_labels.nii.gz");
        row("ct_totalseg_body_3mm", "aorta/ct.nii.gz", "aorta/aorta.nii.gz");
        row("ct_totalseg_body_3mm", "aorta/ct.nii.gz", "aorta/vertebrae_T12.nii.gz");
        row("ct_ibsi_lung_rtstruct", "dicom", "mask.nii.gz");
        row("mr_brain_tumour_nrrd", "brain1_image.nrrd", "brain1_label.nrrd");
        row("mr_brain_mricrop_itksnap", "mri.nii.gz", "labels.nii.gz");
        row("ct_abdomen_j2k_organs", "dicom", "labels.nii.gz");
        row("ct_cranium_inv3", "dicom", "mask_bone_226_3071.nii.gz");
    }
    void labelMaps()
    {
        QFETCH(QString, name);
        QFETCH(QString, study);
        QFETCH(QString, file);
        if (!open(name, study))
            return;
        const core::MaskOnVolume mask = read(file);
        QVERIFY(mask.notes.empty());
        std::map<int, std::uint64_t> expected;
        for (const QJsonValue& entry : m_shared.expected[QStringLiteral("labels")].toArray()) {
            const QJsonObject one = entry.toObject();
            if (one[QStringLiteral("file")].toString() != file)
                continue;
            const QJsonObject labels = one[QStringLiteral("labels")].toObject();
            for (auto label = labels.begin(); label != labels.end(); ++label) {
                if (label.key() != QLatin1String("0"))
                    expected[label.key().toInt()] =
                        std::uint64_t(label->toObject()[QStringLiteral("voxels")].toDouble());
            }
        }
        QVERIFY(!expected.empty());
        std::vector<std::uint64_t> counts;
        for (const auto& [label, count] : expected)
            counts.push_back(count);
        std::vector<std::uint64_t> found;
        for (const core::MaskSegment& segment : mask.segments)
            found.push_back(segment.voxels.voxelCount());
        QCOMPARE(found, counts);
    }

private:
    bool open(const QString& name, const QString& study)
    {
        m_shared = test::sharedCase(name);
        if (m_shared.source.isEmpty()) {
            QTest::qSkip("no shared test data", __FILE__, __LINE__);
            return false;
        }
        const bool inArchive = study.startsWith(QLatin1String("dicom"));
        const QString place =
            QDir(inArchive ? folderOf(m_shared) : m_shared.source).filePath(study);
        const auto scanned = core::Study::scan(place);
        if (!scanned) {
            qWarning("%s", qPrintable(messageOf(scanned.error())));
            return false;
        }
        // The largest, where masks lie beside it as volumes of their own.
        QString key;
        std::size_t most = 0;
        for (const core::SeriesEntry* series : scanned->listing().candidates()) {
            if (series->geometry.voxelCount() > most) {
                most = series->geometry.voxelCount();
                key = series->key;
            }
        }
        auto loaded = scanned->load(key);
        if (!loaded) {
            qWarning("%s", qPrintable(messageOf(loaded.error())));
            return false;
        }
        m_volume = std::move(loaded->volume);
        return true;
    }
    core::MaskOnVolume read(const QString& file)
    {
        const bool inArchive = file.startsWith(QLatin1String("dicom/"));
        const auto mask = core::readMask(
            QDir(inArchive ? folderOf(m_shared) : m_shared.source).filePath(file), m_volume, {});
        if (mask)
            return *mask;
        qWarning("%s", qPrintable(messageOf(mask.error())));
        return {};
    }

    test::SharedCase m_shared;
    core::Volume m_volume;
};

BURIN_TEST(SharedMasksTest)

} // namespace sharedMasksTest

#include "SharedMasksTest.moc"
