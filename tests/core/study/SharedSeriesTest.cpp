// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/ImageHeaderReader.h"
#include "core/study/StudyLoader.h"
#include "tests/support/SharedData.h"

#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QTest>

#include <algorithm>
#include <set>

namespace {

/// Folders that hold files themselves: some cases repeat the same UIDs from folder to folder.
QStringList foldersWithFiles(const QString& root)
{
    std::set<QString> folders;
    QDirIterator iterator(root, QDir::Files, QDirIterator::Subdirectories);
    while (iterator.hasNext())
        folders.insert(QFileInfo(iterator.next()).absolutePath());
    return {folders.begin(), folders.end()};
}

std::vector<core::LoadedVolume> openAll(const QStringList& folders)
{
    std::vector<core::LoadedVolume> all;
    for (const QString& folder : folders) {
        const core::Result<core::StudyListing> listing = core::scanStudies(folder);
        if (!listing)
            continue;
        for (const core::StudyEntry& study : listing->studies) {
            for (const core::SeriesEntry& entry : study.series) {
                core::Result<core::LoadedVolume> loaded = core::loadVolume(folder, entry.key);
                if (loaded)
                    all.push_back(std::move(*loaded));
                else
                    qWarning() << loaded.error().arguments;
            }
        }
    }
    return all;
}

glm::dvec3 vector(const QJsonValue& value, qsizetype first = 0)
{
    const QJsonArray array = value.toArray();
    return {array[first].toDouble(), array[first + 1].toDouble(), array[first + 2].toDouble()};
}

double valueAt(const core::LoadedVolume& loaded, const glm::ivec3& index)
{
    const glm::ivec3& size = loaded.volume.geometry.size;
    const std::size_t voxel = std::size_t(index.x)
        + std::size_t(size.x) * (std::size_t(index.y) + std::size_t(size.y) * std::size_t(index.z));
    return loaded.volume.encoding.value(loaded.codes.at(voxel));
}

glm::dvec3 positionAt(const core::VolumeGeometry& geometry, const glm::ivec3& index)
{
    if (geometry.slicePositions.empty())
        return geometry.toWorld(glm::dvec3(index));
    return geometry.slicePositions.at(std::size_t(index.z))
        + geometry.toWorld({index.x, index.y, 0}) - geometry.originLps();
}

bool near(const glm::dvec3& a, const glm::dvec3& b, double tolerance)
{
    return glm::length(a - b) <= tolerance;
}

/// What a stack of expected.json and an opened volume disagree about; empty if about nothing.
QStringList differences(const core::LoadedVolume& loaded, const QJsonObject& stack)
{
    QStringList wrong;
    const core::Volume& volume = loaded.volume;
    const core::VolumeGeometry& geometry = volume.geometry;
    const auto check = [&](bool agrees, const char* what) {
        if (!agrees)
            wrong.append(QString::fromLatin1(what));
    };
    const QJsonArray spacing = stack[QStringLiteral("pixel_spacing_row_col_mm")].toArray();
    const QJsonValue axes = stack[QStringLiteral("image_orientation_patient")];
    check(near(geometry.direction()[0], glm::normalize(vector(axes)), 1e-6), "row direction");
    check(near(geometry.direction()[1], glm::normalize(vector(axes, 3)), 1e-6), "column direction");
    check(std::abs(geometry.spacingMm().x - spacing[1].toDouble()) < 1e-6, "column spacing");
    check(std::abs(geometry.spacingMm().y - spacing[0].toDouble()) < 1e-6, "row spacing");
    check(near(geometry.originLps(), vector(stack[QStringLiteral("first_slice_ipp_lps_mm")]), 1e-6),
        "origin");
    if (geometry.size.z > 1) {
        check(near(glm::dvec3(geometry.indexToWorld[2]),
                  vector(stack[QStringLiteral("mean_slice_step_lps_mm")]), 1e-5),
            "slice step");
        check(std::abs(geometry.shearAngleDegrees()
                  - stack[QStringLiteral("shear_angle_deg")].toDouble())
                < 0.01,
            "shear angle");
        const QJsonObject gaps = stack[QStringLiteral("slice_spacing_along_normal_mm")].toObject();
        check(gaps[QStringLiteral("uniform_within_0.01mm")].toBool()
                == geometry.slicePositions.empty(),
            "evenness of spacing");
    }
    const QJsonObject rescaled = stack[QStringLiteral("rescaled")].toObject();
    check(float(volume.minimum) == float(rescaled[QStringLiteral("min")].toDouble()), "minimum");
    check(float(volume.maximum) == float(rescaled[QStringLiteral("max")].toDouble()), "maximum");
    for (const QJsonValue& value : stack[QStringLiteral("sample_voxels")].toArray()) {
        const QJsonArray at = value[QStringLiteral("t_k_j_i")].toArray();
        const glm::ivec3 index(at[3].toInt(), at[2].toInt(), at[1].toInt());
        check(near(positionAt(geometry, index), vector(value[QStringLiteral("lps_mm")]), 2e-4),
            "position of a voxel");
        const double told = value[QStringLiteral("rescaled")].toDouble();
        const double tolerance = volume.encoding.maxError + 1e-5 * std::abs(told) + 1e-3;
        check(std::abs(valueAt(loaded, index) - told) <= tolerance, "value of a voxel");
    }
    return wrong;
}

} // namespace

/// Every stack that the shared data describe opens with exactly the voxels and the place described.
class SharedSeriesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void matchesExpectations_data();
    void matchesExpectations();
    void timePointsStayApart();
    void localizersStayApart();
    void namesInEveryScript_data();
    void namesInEveryScript();
};

void SharedSeriesTest::matchesExpectations_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"ct_cranium_inv3", "ct_lidc0314_lower", "ct_abdomen_j2k_organs",
             "mr_t1_sag_mprage", "mr_patient_position_hfs_hfp", "mr_multifragment_jpegll",
             "ct_tilt_study_philips", "edge_geometry", "edge_transfer_syntaxes", "ct_mr_pet_sts001",
             "ct_ibsi_lung_rtstruct", "pet_headneck_seg", "seg_dcmqi_liver",
             "mr_prostate_localizer_missing", "edge_charsets"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void SharedSeriesTest::matchesExpectations()
{
    QFETCH(QString, name);
    const test::SharedCase data = test::sharedCase(name);
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    QStringList folders = foldersWithFiles(data.source);
    if (!data.unpacked.isEmpty())
        folders = foldersWithFiles(data.unpacked);
    folders.removeIf(
        [](const QString& folder) { return folder.contains(QLatin1String("/one_slice")); });
    // Slices of one series may be spread over folders; cases that repeat UIDs are the exception.
    const bool repeatsUids =
        name != QLatin1String("edge_charsets") && name.startsWith(QLatin1String("edge_"));
    const std::vector<core::LoadedVolume> opened = openAll(
        repeatsUids ? folders : QStringList{data.unpacked.isEmpty() ? data.source : data.unpacked});

    int compared = 0;
    for (const QJsonValue& series : data.expected[QStringLiteral("series")].toArray()) {
        for (const QJsonValue& value : series[QStringLiteral("stacks")].toArray()) {
            const QJsonObject stack = value.toObject();
            const QByteArray hash = stack[QStringLiteral("rescaled")]
                                        .toObject()[QStringLiteral("sha256_f32le")]
                                        .toString()
                                        .toLatin1();
            if (hash.isEmpty() || stack[QStringLiteral("frames_per_position")].toInt() != 1)
                continue;
            // Localizers are listed apart.
            const QString type =
                series[QStringLiteral("image_types")].toObject().keys().join(QLatin1Char(' '));
            if (type.contains(QLatin1String("LOCALIZER")))
                continue;
            ++compared;
            QStringList wrong{QStringLiteral("no volume with the voxels of %1")
                                  .arg(series[QStringLiteral("series_instance_uid")].toString())};
            for (const core::LoadedVolume& loaded : opened) {
                if (loaded.volume.voxelsSha256 != hash)
                    continue;
                const QStringList here = differences(loaded, stack);
                if (wrong.front().startsWith(QLatin1String("no volume"))
                    || here.size() < wrong.size())
                    wrong = here;
                if (wrong.isEmpty())
                    break;
            }
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1String(", "))));
        }
    }
    QVERIFY(compared > 0);
}

void SharedSeriesTest::timePointsStayApart()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("mr_4d_fmri_ge"));
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::Result<core::StudyListing> listing = core::scanStudies(data.unpacked);
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(10));
    for (const core::SeriesEntry* entry : listing->candidates()) {
        QCOMPARE(entry->slices(), 15);
        QVERIFY(std::any_of(
            entry->problems.begin(), entry->problems.end(), [](const core::VolumeProblem& problem) {
                return problem.kind == core::VolumeProblem::Kind::MixedSlices;
            }));
    }
    // One after the other the phases are the whole series.
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const core::SeriesEntry* entry : listing->candidates()) {
        const core::Result<core::LoadedVolume> loaded = core::loadVolume(data.unpacked, entry->key);
        QVERIFY(loaded);
        for (const std::uint16_t code : loaded->codes) {
            const auto value = float(loaded->volume.encoding.value(code));
            hash.addData(QByteArrayView(reinterpret_cast<const char*>(&value), sizeof(value)));
        }
    }
    const QJsonObject stack = data.expected[QStringLiteral("series")]
                                  .toArray()[0]
                                  .toObject()[QStringLiteral("stacks")]
                                  .toArray()[0]
                                  .toObject();
    QCOMPARE(QString::fromLatin1(hash.result().toHex()),
        stack[QStringLiteral("rescaled")].toObject()[QStringLiteral("sha256_f32le")].toString());

    const core::Result<core::LoadedVolume> guessed = core::loadVolume(data.unpacked);
    QVERIFY(!guessed);
    QCOMPARE(guessed.error().code, core::ErrorCode::SeriesAmbiguous);
    QCOMPARE(guessed.error().arguments.size(), 11);
}

void SharedSeriesTest::localizersStayApart()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("ct_tilt_study_philips"));
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::Result<core::StudyListing> listing = core::scanStudies(data.unpacked);
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    const core::SeriesEntry& stack = *listing->candidates().front();
    QCOMPARE(stack.slices(), 54);
    QCOMPARE(stack.problems.size(), std::size_t(1));
    QVERIFY(stack.problems.front().kind == core::VolumeProblem::Kind::Tilt);
    QVERIFY(stack.problems.front().caution);
    QVERIFY2(stack.problems.front().text.contains(QStringLiteral("18.5°")),
        qPrintable(stack.problems.front().text));
    std::multiset<QString> kinds;
    for (const core::ForeignObject& object : listing->foreign) {
        for (qsizetype file = 0; file < object.files.size(); ++file)
            kinds.insert(object.kind);
    }
    QCOMPARE(kinds.count(QStringLiteral("DICOMDIR")), std::size_t(4));
    QCOMPARE(kinds.count(QStringLiteral("localizer")), std::size_t(3));
    QCOMPARE(kinds.count(QStringLiteral("colour image")), std::size_t(3));
}

void SharedSeriesTest::namesInEveryScript_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("name");
    const test::SharedCase data = test::sharedCase(QStringLiteral("edge_charsets"));
    if (data.source.isEmpty())
        QTest::newRow("no shared data") << QString() << QString();
    for (const QJsonValue& file : data.expected[QStringLiteral("single_files")].toArray()) {
        const QString path = file[QStringLiteral("file")].toString();
        QTest::newRow(qPrintable(path)) << data.source + QLatin1Char('/') + path
                                        << file[QStringLiteral("patient_name")].toString();
    }
}

void SharedSeriesTest::namesInEveryScript()
{
    QFETCH(QString, file);
    QFETCH(QString, name);
    if (file.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::Result<core::ImageHeader> header = core::readImageHeader(file);
    QVERIFY(header);
    // Empty component groups at the end may stand or not (PS3.5 6.2.1.1).
    QString read = header->identity.patientName;
    while (read.endsWith(QLatin1Char('=')))
        read.chop(1);
    QCOMPARE(read, name);
}

QTEST_GUILESS_MAIN(SharedSeriesTest)
#include "SharedSeriesTest.moc"
