// SPDX-License-Identifier: Apache-2.0
#include "core/nifti/NiftiWriter.h"

#include "tests/support/program/TestProgram.h"
#include "tests/support/series/Affine.h"
#include "tests/support/servers/Python.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <random>

namespace niftiWriterTest {

class NiftiWriterTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nibabelSeesTheSame_data();
    void nibabelSeesTheSame();
    void valuesAreInt16();
    void existingFileIsRefused();
    void unwritableLeavesNothing();
    void fullDiskLeavesNothing();

private:
    QTemporaryDir m_folder;
};

void NiftiWriterTest::nibabelSeesTheSame_data()
{
    QTest::addColumn<glm::dmat4>("affine");
    QTest::addColumn<bool>("sheared");

    const auto rotated = [](double degrees, glm::dvec3 axis, glm::dvec3 spacing) {
        return glm::translate(glm::dmat4(1.0), {-120.5, -87.25, 1033.75})
            * glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::normalize(axis))
            * glm::scale(glm::dmat4(1.0), spacing);
    };
    QTest::newRow("axial supine") << rotated(0, {0, 0, 1}, {0.9570312, 0.9570312, 1.5}) << false;
    QTest::newRow("axial prone") << rotated(180, {0, 0, 1}, {0.5, 0.7, 3}) << false;
    QTest::newRow("oblique") << rotated(33, {1, 2, -1}, {0.859375, 0.859375, 0.9}) << false;
    QTest::newRow("nearly axial") << rotated(0.06, {0, 0, 1}, {0.7, 0.7, 1}) << false;
    QTest::newRow("nearly half a turn") << rotated(179.94, {0.01, 0, 1}, {0.7, 0.7, 1}) << false;
    glm::dmat4 mirrored = rotated(20, {0, 1, 0}, {1, 2, 3});
    mirrored[2] = -mirrored[2];
    QTest::newRow("left-handed") << mirrored << false;
    glm::dmat4 tilted = rotated(0, {0, 0, 1}, {0.48, 0.48, 2.5});
    tilted[2].y += 0.8;
    QTest::newRow("tilted") << tilted << true;

    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const int count = qEnvironmentVariableIsSet("BURIN_LONG") ? 100 : 5;
    for (int i = 0; i < count; ++i)
        QTest::addRow("random %d", i)
            << rotated(180.0 * any(random), {any(random), any(random), any(random)},
                   {1.5 + any(random), 1.5 + any(random), 2.5 + any(random)})
            << false;
}

void NiftiWriterTest::nibabelSeesTheSame()
{
    QFETCH(glm::dmat4, affine);
    QFETCH(bool, sheared);
    core::VolumeGeometry geometry{.size = {11, 7, 5}, .indexToWorld = affine, .slicePositions = {}};
    std::vector<std::uint8_t> labels(geometry.voxelCount());
    std::mt19937 random(3);
    for (auto& label : labels)
        label = std::uint8_t(random() % 4);

    const QString file = m_folder.filePath(QStringLiteral("labels.nii.gz"));
    const auto written = core::writeNifti(file,
        {.geometry = geometry, .voxels = labels, .description = QStringLiteral("Burin")}, true);
    QVERIFY(written.has_value());

    const auto read = test::runScript(QStringLiteral("nifti_facts.py"), {file});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QCOMPARE(facts["size"].toArray(), (QJsonArray{11, 7, 5}));
    QCOMPARE(facts["type"].toString(), QStringLiteral("uint8"));
    QCOMPARE(facts["intent"].toInt(), 1002);
    QCOMPARE(facts["units"].toString(), QStringLiteral("mm"));
    QCOMPARE(facts["description"].toString(), QStringLiteral("Burin"));
    QVERIFY(test::cornerDistance(test::matrixFrom(facts["sform"]), geometry) < 1e-3);
    QCOMPARE(facts["qform"].isNull(), !written->qform);
    if (sheared)
        QVERIFY(!written->qform);
    if (written->qform)
        QVERIFY(test::cornerDistance(test::matrixFrom(facts["qform"]), geometry) < 2e-3);
    const QByteArray bytes(reinterpret_cast<const char*>(labels.data()), qsizetype(labels.size()));
    QCOMPARE(facts["sha256"].toString().toLatin1(),
        QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

void NiftiWriterTest::valuesAreInt16()
{
    core::VolumeGeometry geometry;
    geometry.size = {4, 3, 2};
    std::vector<std::int16_t> values(geometry.voxelCount());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::int16_t(int(i) * 100 - 1024);
    const QString file = m_folder.filePath(QStringLiteral("values.nii"));
    QVERIFY(core::writeNifti(file, {.geometry = geometry, .voxels = values, .description = {}}));

    const auto read = test::runScript(QStringLiteral("nifti_facts.py"), {file});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QCOMPARE(facts["type"].toString(), QStringLiteral("int16"));
    QCOMPARE(facts["intent"].toInt(), 0);
    const QByteArray bytes(
        reinterpret_cast<const char*>(values.data()), qsizetype(values.size() * 2));
    QCOMPARE(facts["sha256"].toString().toLatin1(),
        QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

void NiftiWriterTest::existingFileIsRefused()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("a.nii.gz"));
    QFile old(file);
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("kept");
    old.close();
    core::VolumeGeometry geometry;
    geometry.size = {2, 2, 2};
    const std::vector<std::uint8_t> labels(8, 1);
    const core::NiftiImage image{.geometry = geometry, .voxels = labels, .description = {}};
    const auto refused = core::writeNifti(file, image);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::FileExists);
    QVERIFY(old.open(QIODevice::ReadOnly));
    QCOMPARE(old.readAll(), QByteArray("kept"));
    QVERIFY(core::writeNifti(file, image, true));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
}

void NiftiWriterTest::unwritableLeavesNothing()
{
    core::VolumeGeometry geometry;
    geometry.size = {2, 2, 2};
    const std::vector<std::uint8_t> labels(8, 1);
    const core::NiftiImage image{.geometry = geometry, .voxels = labels, .description = {}};
    for (const QString& file : {m_folder.filePath(QStringLiteral("missing/a.nii.gz")),
             m_folder.path(), QStringLiteral("/proc/a.nii.gz")}) {
        const auto refused = core::writeNifti(file, image);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, core::ErrorCode::FileUnwritable);
        QVERIFY(refused.error().arguments.value(0) == file);
    }
    QVERIFY(!QDir(m_folder.filePath(QStringLiteral("missing"))).exists());
}

void NiftiWriterTest::fullDiskLeavesNothing()
{
    core::VolumeGeometry geometry;
    geometry.size = {64, 64, 64};
    const std::vector<std::uint8_t> labels(geometry.voxelCount(), 1);
    const auto refused = core::writeNiftiAt(
        QStringLiteral("/dev/full"), {.geometry = geometry, .voxels = labels, .description = {}});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::FileUnwritable);
}

BURIN_TEST(NiftiWriterTest)

} // namespace niftiWriterTest

#include "NiftiWriterTest.moc"
