// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/VolumeFiles.h"

#include "core/base/files/StagedFile.h"
#include "core/export/common/ExportMask.h"
#include "core/sessionfile/records/SessionImages.h"
#include "tests/support/series/Affine.h"
#include "tests/support/series/NrrdFiles.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/VerifyResult.h"

#include <random>

namespace test {

void VolumeFiles::putVoxels(const QByteArray& voxels, const QStringList& names,
    const QByteArray& before, const std::function<QByteArray(const QByteArray&)>& pack)
{
    const qsizetype share = voxels.size() / names.size();
    for (qsizetype part = 0; part < names.size(); ++part) {
        const QByteArray bytes = before + voxels.mid(part * share, share);
        put(names[part], pack ? pack(bytes) : bytes);
    }
}

void VolumeFiles::compareVoxels(
    const core::Result<core::LoadedVolume>& loaded, const glm::dmat4& indexToWorld, int shift)
{
    VERIFY_DONE(loaded);
    QCOMPARE(loaded->volume.geometry.size, nrrd::size);
    QVERIFY(sameAffine(loaded->volume.geometry.indexToWorld, indexToWorld));
    QVERIFY(loaded->volume.problems.empty() && !loaded->volume.needsCaution());
    for (int voxel = 0; voxel < nrrd::voxels; ++voxel)
        QCOMPARE(loaded->volume.encoding.value(loaded->codes[std::size_t(voxel)]),
            double(nrrd::valueOf(voxel) + shift));
}

void VolumeFiles::compareRefusal(
    const QByteArray& bytes, core::ErrorCode code, const QString& reason)
{
    const core::Result<core::LoadedVolume> loaded = openBytes(bytes);
    QVERIFY(!loaded);
    QVERIFY2(loaded.error().code == code, qPrintable(errorText(loaded.error())));
    QVERIFY(loaded.error().arguments.value(0).endsWith(m_name));
    QVERIFY2(
        loaded.error().arguments.value(1).contains(reason), qPrintable(errorText(loaded.error())));
}

void VolumeFiles::compareEveryCut(const QByteArray& sound)
{
    for (qsizetype length = 0; length < sound.size(); ++length) {
        const core::Result<core::LoadedVolume> loaded = openBytes(sound.left(length));
        QVERIFY2(!loaded, qPrintable(QString::number(length)));
        QVERIFY(loaded.error().arguments.value(0).endsWith(m_name));
        QVERIFY(!loaded.error().arguments.value(1).isEmpty());
    }
    QVERIFY(openBytes(sound));
}

void VolumeFiles::compareRandomBytes(
    const std::vector<QByteArray>& kinds, unsigned int seed, int rounds)
{
    std::mt19937 random(seed);
    int opened = 0;
    for (int round = 0; round < rounds; ++round) {
        QByteArray bytes = kinds[std::size_t(round) % kinds.size()];
        const int changes = 1 + int(random() % 3);
        for (int change = 0; change < changes; ++change) {
            const auto at = qsizetype(random() % std::size_t(bytes.size()));
            switch (random() % 4) {
            case 0:
                bytes.remove(at, qsizetype(random() % 8));
                break;
            case 1:
                bytes.insert(at, bytes.mid(qsizetype(random() % std::size_t(bytes.size())), 9));
                break;
            default:
                bytes[at] = char(random() % 2 == 0 ? '0' + random() % 10 : random());
            }
            if (bytes.isEmpty())
                bytes = "N";
        }
        const core::Result<core::LoadedVolume> loaded = openBytes(bytes);
        opened += loaded ? 1 : 0;
        QVERIFY(loaded || !loaded.error().arguments.value(0).isEmpty());
    }
    QVERIFY(opened > 0 && opened < rounds);
}

void VolumeFiles::compareMasks(const QByteArray& sound, const QByteArray& moved)
{
    const QString source = put(m_name, sound);
    const core::LoadedVolume loaded = openVolume(source);
    const std::vector<std::uint8_t> labels(loaded.codes.size(), 1);
    core::Segment segment;
    segment.label = 1;
    segment.name = QStringLiteral("All");
    core::ExportRequest request{.format = core::ExportFormat::Nifti,
        .file = m_folder->filePath(QStringLiteral("mask.nii")),
        .force = true,
        .segments = {segment},
        .planes = {{.plane = 0, .labels = labels}}};
    const auto report = core::exportMask(loaded.volume, request, {});
    VERIFY_DONE(report);
    const core::LoadedVolume mask = openVolume(request.file);
    QVERIFY(cornerDistance(mask.volume.geometry.indexToWorld, loaded.volume.geometry) < 1e-3);

    put(m_name, moved);
    const auto refused = core::exportMask(loaded.volume, request, {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::ExportMismatch);

    // A session that holds the images holds the header too.
    put(m_name, sound);
    const QString session = m_folder->filePath(QStringLiteral("kept.burin"));
    core::Result<core::StagedFile> staged = core::stageImages(session, true, loaded);
    QVERIFY(staged && staged->commit());
    QVERIFY(QFile::remove(source));
    QVERIFY(!core::exportMask(loaded.volume, request, {}));
    const core::Result<core::LoadedVolume> kept = core::loadSessionImages(session);
    VERIFY_DONE(kept);
    const auto without = core::exportMask(kept->volume, request, {});
    VERIFY_DONE(without);
}

} // namespace test
