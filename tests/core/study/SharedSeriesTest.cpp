// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/ImageHeaderReader.h"
#include "core/study/StudyLoader.h"
#include "core/study/VolumeFacts.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "ui/texts/ProblemTexts.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <set>

namespace sharedSeriesTest {

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

/// A folder read as `burin info` reads it.
struct Opened {
    core::Study study;
    std::vector<core::VolumeFacts> volumes{};
};

std::vector<Opened> openAll(const QStringList& folders)
{
    std::vector<Opened> all;
    for (const QString& folder : folders) {
        core::Result<core::Study> study = core::Study::scan(folder);
        if (!study)
            continue;
        Opened& opened = all.emplace_back(Opened{std::move(*study)});
        for (const core::StudyEntry& one : opened.study.listing().studies) {
            for (const core::SeriesEntry& entry : one.series) {
                opened.volumes.push_back(core::volumeFacts(opened.study, entry));
                if (!opened.volumes.back().loaded)
                    qWarning() << opened.volumes.back().loaded.error().arguments.join(u' ');
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
QStringList differences(const core::VolumeFacts& facts, const QJsonObject& stack)
{
    QStringList wrong;
    const core::LoadedVolume& loaded = *facts.loaded;
    const core::Volume& volume = loaded.volume;
    const core::VolumeGeometry& geometry = volume.geometry;
    const auto check = [&](bool agrees, const char* what) {
        if (!agrees)
            wrong.append(QString::fromLatin1(what));
    };
    const int times = stack[QStringLiteral("frames_per_position")].toInt();
    check(int(facts.times.size()) == (times > 1 ? times : 0), "points in time");
    check(geometry.size.x == stack[QStringLiteral("columns")].toInt()
            && geometry.size.y == stack[QStringLiteral("rows")].toInt()
            && geometry.size.z == stack[QStringLiteral("slices")].toInt(),
        "size");
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
    check(float(facts.minimum) == float(rescaled[QStringLiteral("min")].toDouble()), "minimum");
    check(float(facts.maximum) == float(rescaled[QStringLiteral("max")].toDouble()), "maximum");
    for (const QJsonValue& value : stack[QStringLiteral("sample_voxels")].toArray()) {
        const QJsonArray at = value[QStringLiteral("t_k_j_i")].toArray();
        const glm::ivec3 index(at[3].toInt(), at[2].toInt(), at[1].toInt());
        check(near(positionAt(geometry, index), vector(value[QStringLiteral("lps_mm")]), 2e-4),
            "position of a voxel");
        if (at[0].toInt() > 0)
            continue; // the checksum over all points in time has it
        const double told = value[QStringLiteral("rescaled")].toDouble();
        const double tolerance = volume.encoding.maxError + 1e-5 * std::abs(told) + 1e-3;
        check(std::abs(valueAt(loaded, index) - told) <= tolerance, "value of a voxel");
    }
    return wrong;
}

/// Whether a stack of expected.json is none that a volume could be made of.
bool isRefused(const QJsonObject& series, const QJsonObject& stack)
{
    const QString types =
        series[QStringLiteral("image_types")].toObject().keys().join(QLatin1Char(' '));
    return stack[QStringLiteral("samples_per_pixel")].toInt() != 1
        || stack[QStringLiteral("image_orientation_patient")].isUndefined()
        || types.contains(QLatin1String("LOCALIZER")) || types.contains(QLatin1String("SURVIEW"))
        || types.contains(QLatin1String("MOSAIC"));
}

/// Why nothing of a series became a volume; empty where that is not said.
QString refusal(const std::vector<Opened>& opened, const QString& seriesUid)
{
    for (const Opened& one : opened) {
        for (const core::ForeignObject& object : one.study.listing().foreign) {
            if (object.identity.seriesUid == seriesUid)
                return object.kind + QLatin1Char(' ') + object.reason;
        }
    }
    return {};
}

/// What the nearest of the opened volumes and a stack disagree about; empty if about nothing.
QStringList differencesOfNearest(const std::vector<Opened>& opened, const QJsonObject& stack)
{
    const QByteArray hash = stack[QStringLiteral("rescaled")]
                                .toObject()[QStringLiteral("sha256_f32le")]
                                .toString()
                                .toLatin1();
    QStringList wrong{QStringLiteral("no volume with these voxels")};
    bool found = false;
    for (const Opened& one : opened) {
        for (const core::VolumeFacts& facts : one.volumes) {
            if (!facts.loaded || facts.voxelsSha256 != hash)
                continue;
            const QStringList here = differences(facts, stack);
            if (!found || here.size() < wrong.size())
                wrong = here;
            found = true;
        }
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
    void pointsInTimeOpenOneByOne();
    void filesOfAnEnhancedSeriesAreOneVolume();
    void singleFilesOpenOrSayWhy_data();
    void singleFilesOpenOrSayWhy();
    void localizersStayApart();
    void namesInEveryScript_data();
    void namesInEveryScript();
};

void SharedSeriesTest::matchesExpectations_data()
{
    QTest::addColumn<QString>("name");
    for (const QString& name :
        QDir(test::sharedDataFolder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QDir folder(test::sharedDataFolder() + QLatin1Char('/') + name);
        QFile expected(folder.filePath(QStringLiteral("expected.json")));
        if (!expected.open(QIODevice::ReadOnly))
            continue;
        const QJsonObject facts = QJsonDocument::fromJson(expected.readAll()).object();
        if (!facts[QStringLiteral("series")].toArray().isEmpty())
            QTest::newRow(qPrintable(name)) << name;
    }
    if (test::sharedDataFolder().isEmpty())
        QTest::newRow("no shared data") << QString();
}

void SharedSeriesTest::matchesExpectations()
{
    QFETCH(QString, name);
    if (name.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const test::SharedCase data = test::sharedCase(name);
    const QString root = data.unpacked.isEmpty() ? data.source : data.unpacked;
    QStringList folders = foldersWithFiles(root);
    folders.removeIf(
        [](const QString& folder) { return folder.contains(QLatin1String("/one_slice")); });
    // Slices of one series may be spread over folders; cases that repeat UIDs are the exception.
    const bool repeatsUids = name == QLatin1String("edge_geometry")
        || name == QLatin1String("edge_transfer_syntaxes")
        || name == QLatin1String("edge_pixels_colour");
    std::vector<Opened> opened = openAll(repeatsUids ? folders : QStringList{root});
    // Files that share their UIDs, or are points in time of each other, are told about one by one.
    for (const QJsonValue& series : data.expected[QStringLiteral("series")].toArray()) {
        const QString file = series[QStringLiteral("file")].toString();
        if (!file.isEmpty()) {
            for (Opened& one : openAll({root + QLatin1Char('/') + file}))
                opened.push_back(std::move(one));
        }
    }

    int compared = 0;
    for (const QJsonValue& series : data.expected[QStringLiteral("series")].toArray()) {
        const QString uid = series[QStringLiteral("series_instance_uid")].toString();
        for (const QJsonValue& value : series[QStringLiteral("stacks")].toArray()) {
            ++compared;
            const QJsonObject stack = value.toObject();
            if (isRefused(series.toObject(), stack)) {
                QVERIFY2(!refusal(opened, uid).isEmpty(), qPrintable(uid));
                continue;
            }
            const QStringList wrong = differencesOfNearest(opened, stack);
            QVERIFY2(wrong.isEmpty(),
                qPrintable(uid + QStringLiteral(": ") + wrong.join(QLatin1String(", "))));
        }
    }
    QVERIFY(compared > 0);
}

void SharedSeriesTest::pointsInTimeOpenOneByOne()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("mr_4d_fmri_ge"));
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::Result<core::Study> study = core::Study::scan(data.unpacked);
    QVERIFY(study);
    const core::StudyListing& listing = study->listing();
    QCOMPARE(listing.candidates().size(), std::size_t(1));
    const core::SeriesEntry& entry = *listing.candidates().front();
    QCOMPARE(entry.slices(), 15);
    QCOMPARE(entry.times.size(), 10);
    const core::VolumeFacts facts = core::volumeFacts(*study, entry);
    QCOMPARE(facts.times.size(), std::size_t(10));

    const core::Result<core::LoadedVolume> first = core::loadVolume(data.unpacked);
    QVERIFY(first);
    QCOMPARE(first->volume.voxelsSha256, facts.times[0].voxelsSha256);
    const core::Result<core::LoadedVolume> seventh =
        core::loadVolume(data.unpacked, entry.key + QStringLiteral("@7"));
    QVERIFY(seventh);
    QCOMPARE(seventh->volume.voxelsSha256, facts.times[6].voxelsSha256);
    QCOMPARE(seventh->volume.geometry.indexToWorld, first->volume.geometry.indexToWorld);
    QVERIFY(std::any_of(seventh->volume.problems.begin(), seventh->volume.problems.end(),
        [](const core::VolumeProblem& problem) {
            return problem.kind == core::VolumeProblem::Kind::MixedSlices && !problem.caution
                && ui::problemText(problem.said).contains(QLatin1String("this is point 7"));
        }));
    for (const char* nowhere : {"@0", "@11", "@x", "@"}) {
        const core::Result<core::LoadedVolume> none =
            core::loadVolume(data.unpacked, entry.key + QLatin1String(nowhere));
        QVERIFY(!none);
        QCOMPARE(none.error().code, core::ErrorCode::SeriesNotFound);
    }
}

void SharedSeriesTest::filesOfAnEnhancedSeriesAreOneVolume()
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("edge_multiframe"));
    if (data.source.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const QTemporaryDir folder;
    for (const char* name : {"siemens_xa10_6_1.dcm", "siemens_xa10_6_2.dcm"}) {
        const QString file = QString::fromLatin1(name);
        QVERIFY(
            QFile::copy(data.unpacked + QStringLiteral("/dicom/") + file, folder.filePath(file)));
    }
    const core::Result<core::StudyListing> listing = core::scanStudies(folder.path());
    QVERIFY(listing);
    QCOMPARE(listing->candidates().size(), std::size_t(1));
    const QStringList times = listing->candidates().front()->times;
    QCOMPARE(times,
        (QStringList{
            QStringLiteral("temporal position 1"), QStringLiteral("temporal position 2")}));
}

void SharedSeriesTest::singleFilesOpenOrSayWhy_data()
{
    QTest::addColumn<QString>("file");
    for (const char* name : {"edge_pixels_colour", "edge_transfer_syntaxes", "edge_broken"}) {
        const test::SharedCase data = test::sharedCase(QString::fromLatin1(name));
        for (const QJsonValue& file : data.expected[QStringLiteral("single_files")].toArray()) {
            const QString path = file[QStringLiteral("file")].toString();
            const QString packed = data.unpacked + QLatin1Char('/') + path;
            QTest::newRow(qPrintable(path))
                << (QFile::exists(packed) ? packed : data.source + QLatin1Char('/') + path);
        }
    }
    if (test::sharedDataFolder().isEmpty())
        QTest::newRow("no shared data") << QString();
}

void SharedSeriesTest::singleFilesOpenOrSayWhy()
{
    QFETCH(QString, file);
    if (file.isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    const core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
    if (!loaded)
        QVERIFY(!loaded.error().arguments.value(1).isEmpty());
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
    QVERIFY2(ui::problemText(stack.problems.front().said).contains(QStringLiteral("18.5°")),
        qPrintable(ui::problemText(stack.problems.front().said)));
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

BURIN_TEST(SharedSeriesTest)

} // namespace sharedSeriesTest

#include "SharedSeriesTest.moc"
