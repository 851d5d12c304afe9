// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionImages.h"
#include "core/base/files/SystemFile.h"
#include "core/session/SessionKeyframes.h"
#include "core/session/SessionStorage.h"

#include "core/export/common/ExportMask.h"
#include "core/nifti/NiftiHeader.h"
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "core/sessionfile/records/ImagePieces.h"
#include "core/sessionfile/records/VolumeJson.h"
#include "core/study/StudyLoader.h"
#include "core/volume/encoding/VolumeEncoder.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/faults/SmallFileSystem.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SessionFiles.h"
#include "tests/support/series/SyntheticSeries.h"
#include "ui/texts/ReportTexts.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cerrno>
#include <future>
#include <random>

namespace sessionImagesTest {

using namespace core;

namespace {

Result<void> saveAs(EditSession& session, const QString& target, SavedImages images)
{
    std::promise<Result<void>> promise;
    session.storage().saveAs(
        target, true, [&promise](const Result<void>& result) { promise.set_value(result); },
        std::move(images));
    return promise.get_future().get();
}

/// Noise, which nothing compresses, of two pieces and a bit.
LoadedVolume largeStudy()
{
    LoadedVolume loaded;
    Volume& volume = loaded.volume;
    volume.geometry.size = {256, 128, 70};
    volume.geometry.slicePositions.resize(70);
    for (int k = 0; k < 70; ++k)
        volume.geometry.slicePositions[std::size_t(k)] = {0.1, 0.2, k * k / 3.0};
    volume.encoding = {.rescaleSlope = 0.1, .rescaleIntercept = -7.3};
    volume.sourcePath = QStringLiteral("/nowhere/large.nii");
    volume.sourceFormat = QStringLiteral("NIfTI");
    std::mt19937 random(7);
    loaded.codes.resize(volume.geometry.voxelCount());
    for (std::uint16_t& code : loaded.codes)
        code = std::uint16_t(random());
    volume.voxelsSha256 = sha256OfValues(loaded);
    return loaded;
}

void writeNifti(const QString& path)
{
    const LoadedVolume small = test::smallStudy();
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    const NiftiHeader header =
        makeNiftiHeader(small.volume.geometry, NiftiHeader::DataType::Int16, "test");
    file.write(header.bytes.data(), NiftiHeader::voxelOffset);
    file.write(reinterpret_cast<const char*>(small.codes.data()), qint64(small.codes.size() * 2));
}

} // namespace

/// Sessions that carry their study's images.
class SessionImagesTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QStringList files() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden);
    }
    /// A session file of that name with the images of a study and nothing else.
    void embed(const LoadedVolume& study, const char* name) const
    {
        Result<StagedFile> staged = stageImages(path(name), true, study);
        QVERIFY2(staged, qPrintable(staged ? QString() : test::errorText(staged.error())));
        const Result<void> placed = staged->commit();
        QVERIFY2(placed, qPrintable(placed ? QString() : test::errorText(placed.error())));
    }
    /// A session with the steps of manyEdits() and the images of the small series, which is in ct.
    void makeSession(const char* name) const
    {
        const LoadedVolume study = test::openVolume(path("ct"));
        embed(study, name);
        reference::ReferenceEngine engine;
        auto session = EditSession::open(engine, study, path(name));
        QVERIFY(session);
        for (const Edit& edit : test::manyEdits())
            QVERIFY((*session)->apply(edit));
        QVERIFY((*session)->settle());
    }
    void verifySame(const LoadedVolume& got, const LoadedVolume& expected) const
    {
        QCOMPARE(got.codes.size(), expected.codes.size());
        QVERIFY(got.codes == expected.codes);
        QCOMPARE(got.volume.voxelsSha256, expected.volume.voxelsSha256);
        QCOMPARE(volumeToJson(got.volume), volumeToJson(expected.volume));
        QVERIFY(got.volume.geometry.indexToWorld == expected.volume.geometry.indexToWorld);
        QVERIFY(got.volume.geometry.slicePositions == expected.volume.geometry.slicePositions);
        QCOMPARE(got.volume.sources.size(), expected.volume.sources.size());
        QVERIFY(got.volume.keptHeaders != nullptr);
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSmallSeries(path("ct"), "2.25.1", 0, "Head");
    }

    void comeBackAsTheyWere_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("DICOM") << 0;
        QTest::newRow("DICOM, a slope per slice") << 1;
        QTest::newRow("NIfTI") << 2;
        QTest::newRow("three pieces of noise") << 3;
    }
    void comeBackAsTheyWere()
    {
        QFETCH(int, kind);
        LoadedVolume study;
        if (kind == 0) {
            study = test::openVolume(path("ct"));
        } else if (kind == 1) {
            test::SyntheticSeries series;
            series.slope = [](int k) { return 0.37 + 0.01 * k; };
            writeSeries(series, path("pet"));
            study = test::openVolume(path("pet"));
            QVERIFY(study.volume.encoding.maxError > 0.0);
            QVERIFY(!study.volume.problems.empty());
            QCOMPARE(study.volume.codesSha256, sha256OfCodes(study));
        } else if (kind == 2) {
            writeNifti(path("small.nii"));
            study = test::openVolume(path("small.nii"));
            QCOMPARE(study.volume.codesSha256, QByteArray());
        } else {
            study = largeStudy();
        }
        embed(study, "s.burin");
        const Result<LoadedVolume> got = loadSessionImages(path("s.burin"));
        QVERIFY2(got, qPrintable(got ? QString() : test::errorText(got.error())));
        verifySame(*got, study);
        QCOMPARE(QFile::permissions(path("s.burin"))
                & (QFileDevice::ReadGroup | QFileDevice::ReadOther | QFileDevice::WriteGroup
                    | QFileDevice::WriteOther),
            QFileDevice::Permissions());
        // What came out of a session can go into another one.
        embed(*got, "again.burin");
        const Result<LoadedVolume> again = loadSessionImages(path("again.burin"));
        QVERIFY(again);
        verifySame(*again, study);
        QVERIFY(*again->volume.keptHeaders == *got->volume.keptHeaders);
        if (kind == 3) {
            QCOMPARE(test::text(path("s.burin"), QStringLiteral("SELECT COUNT(*) FROM pixels")),
                QStringLiteral("3"));
            QVERIFY(
                test::text(path("s.burin"), QStringLiteral("SELECT MAX(LENGTH(bytes)) FROM pixels"))
                    .toInt()
                <= 4 << 20);
        }
    }

    void thePatientStandsAmongTheReferencesOnly()
    {
        test::SyntheticSeries series;
        series.adjust = [](DcmDataset& set, int) {
            set.putAndInsertString(DCM_PatientName, "SECRET^NAME");
            set.putAndInsertString(DCM_InstitutionName, "SECRET HOSPITAL");
        };
        writeSeries(series, path("named"));
        const LoadedVolume study = test::openVolume(path("named"));
        embed(study, "s.burin");
        for (const char* table : {"row", "delta", "visited", "state", "keyframe", "pixels"}) {
            const QString all = test::text(path("s.burin"),
                QStringLiteral("SELECT COUNT(*) FROM %1").arg(QLatin1String(table)));
            QCOMPARE(all.toInt(), qstrcmp(table, "pixels") == 0 ? 1 : 0);
        }
        QVERIFY(test::text(path("s.burin"), QStringLiteral("SELECT images FROM source"))
                    .contains(QStringLiteral("SECRET")));
        QVERIFY(!test::text(path("s.burin"), QStringLiteral("SELECT json FROM source"))
                     .contains(QStringLiteral("SECRET")));
        const Result<LoadedVolume> got = loadSessionImages(path("s.burin"));
        QVERIFY(got);
        QCOMPARE(got->volume.identity.patientName, study.volume.identity.patientName);
        for (const auto& [file, header] : *got->volume.keptHeaders)
            QVERIFY(header.contains("SECRET^NAME") && !header.contains("HOSPITAL"));
        // Left out again, nothing of it is left in the file.
        {
            reference::ReferenceEngine engine;
            const auto session = EditSession::open(engine, study, path("s.burin"));
            QVERIFY((*session)->storage().holdsImages());
            QVERIFY(saveAs(**session, path("t.burin"), {.kept = false}));
            QVERIFY(!(*session)->storage().holdsImages());
        }
        QFile file(path("t.burin"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(!file.readAll().contains("SECRET"));
        QCOMPARE(loadSessionImages(path("t.burin")).error().code, ErrorCode::NoImages);
    }

    void aSessionGoesOnWithThem()
    {
        const LoadedVolume study = test::openVolume(path("ct"));
        const QString file = path("a.burin");
        reference::ReferenceEngine engine;
        std::unique_ptr<EditSession> session = *EditSession::create(engine, study, {.file = file});
        for (const Edit& edit : test::manyEdits())
            QVERIFY(session->apply(edit));
        QVERIFY(session->settle());
        const QByteArray hash = session->stateHash();
        const std::size_t rows = session->history().rows().size();
        const std::vector<RowId> keyframes = session->keyframes().rows();
        Result<StagedFile> staged = stageImages(path("b.burin"), true, study);
        QVERIFY(staged);
        const Result<void> saved = saveAs(*session, path("b.burin"),
            {.staged = std::make_shared<StagedFile>(*std::move(staged))});
        QVERIFY2(saved, qPrintable(saved ? QString() : test::errorText(saved.error())));
        QVERIFY(session->storage().holdsImages());
        QCOMPARE(session->stateHash(), hash);
        QVERIFY(session->apply(test::drillAt(5)));
        QVERIFY(session->goTo(2));
        QVERIFY(session->goTo(RowId(rows)));
        QVERIFY(session->settle());
        QCOMPARE(session->stateHash(), hash);
        // Kept when it is saved once more, as it is.
        QVERIFY(saveAs(*session, path("c.burin"), {}));
        session.reset();
        for (const char* name : {"b.burin", "c.burin"}) {
            const Result<SessionContents> contents = checkSession(path(name));
            QVERIFY(contents && !contents->damage && contents->redo.empty());
            QVERIFY(contents->holdsImages);
            const Result<LoadedVolume> got = loadSessionImages(path(name));
            QVERIFY(got);
            const auto again = EditSession::open(engine, *got, path(name));
            QVERIFY2(again, qPrintable(again ? QString() : test::errorText(again.error())));
            QCOMPARE((*again)->history().rows().size(), rows + 1);
            QCOMPARE((*again)->stateHash(), hash);
            QCOMPARE((*again)->keyframes().rows(), keyframes);
        }
    }

    void theOpenFileTakesThemIn()
    {
        const LoadedVolume study = test::openVolume(path("ct"));
        const QString file = path("a.burin");
        reference::ReferenceEngine engine;
        {
            const auto session = *EditSession::create(engine, study, {.file = file});
            QVERIFY(session->apply(test::drillAt(0)));
            Result<StagedFile> staged = stageImages(file, true, study);
            QVERIFY(staged);
            QVERIFY(session->apply(test::drillAt(3))); // while they were written
            QVERIFY(saveAs(
                *session, file, {.staged = std::make_shared<StagedFile>(*std::move(staged))}));
            QVERIFY(session->storage().holdsImages());
            QVERIFY(session->apply(test::drillAt(6)));
            QVERIFY(session->settle());
        }
        QCOMPARE(files(), QStringList{QStringLiteral("a.burin")});
        const Result<LoadedVolume> got = loadSessionImages(file);
        QVERIFY(got);
        const auto session = EditSession::open(engine, *got, file);
        QVERIFY(session);
        QCOMPARE((*session)->history().rows().size(), std::size_t(3));
    }

    void theStudyComesFirst()
    {
        makeSession("s.burin");
        const SessionSource source =
            (*SessionFile::open(path("s.burin"), SessionFile::Access::ReadOnly))->contents().source;
        const auto load = [&](const QString& place = {}) {
            return loadSessionStudy(path("s.burin"), source, place);
        };
        Result<LoadedVolume> got = load();
        QVERIFY(got);
        QVERIFY(!got->notFromStudy);
        QVERIFY(!got->volume.keptHeaders);
        const LoadedVolume study = *std::move(got);

        QVERIFY(QDir().rename(path("ct"), path("gone")));
        got = load();
        QVERIFY2(got, qPrintable(got ? QString() : test::errorText(got.error())));
        verifySame(*got, study);
        QCOMPARE(got->notFromStudy->code, ErrorCode::StudyMissing);
        QCOMPARE(got->notFromStudy->arguments, (QStringList{path("s.burin"), path("ct")}));

        test::writeSmallSeries(path("ct"), "2.25.1", 1); // another one in its place
        got = load();
        QVERIFY(got);
        verifySame(*got, study);
        QCOMPARE(got->notFromStudy->code, ErrorCode::SessionMismatch);
        // Who names a place means it.
        QCOMPARE(load(path("ct")).error().code, ErrorCode::SessionMismatch);
        QVERIFY(!load(path("gone"))->notFromStudy);
    }

    void damageIsNamed_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("words");
        QTest::newRow("a piece") << QStringLiteral(
            "UPDATE pixels SET bytes=SUBSTR(bytes, 1, 99) || X'00' || SUBSTR(bytes, 101)"
            " WHERE piece=1") << QStringLiteral("piece 2 of 3 of its images was changed");
        QTest::newRow("no piece") << QStringLiteral("DELETE FROM pixels WHERE piece=2")
                                  << QStringLiteral("piece 3 of 3 of its images is missing");
        QTest::newRow("description")
            << QStringLiteral("UPDATE source SET images=REPLACE(images, 'NIfTI', 'DICOM')")
            << QStringLiteral("what describes its images was changed");
        QTest::newRow("headers") << QStringLiteral("UPDATE source SET headers=X'00'")
                                 << QStringLiteral("the headers of its images were changed");
    }
    void damageIsNamed()
    {
        QFETCH(QString, sql);
        QFETCH(QString, words);
        embed(largeStudy(), "s.burin");
        QVERIFY(test::runSql(path("s.burin"), sql));
        const QByteArray before = test::fingerprint(path("s.burin"));
        const Result<LoadedVolume> got = loadSessionImages(path("s.burin"));
        QVERIFY(!got);
        QCOMPARE(got.error().code, ErrorCode::SessionDamaged);
        QCOMPARE(got.error().arguments.value(0), path("s.burin"));
        QVERIFY2(got.error().arguments.value(1).contains(words),
            qPrintable(got.error().arguments.value(1)));
        const Result<LoadedVolume> study =
            loadSessionStudy(path("s.burin"), SessionSource::of(largeStudy().volume), QString());
        QCOMPARE(study.error().code, ErrorCode::StudyMissing);
        QVERIFY(study.error().arguments.value(2).contains(words));
        QCOMPARE(test::fingerprint(path("s.burin")), before);
    }

    /// Pieces and hashes that agree with each other but not with what the session was made on.
    void otherImagesAreNotTaken()
    {
        LoadedVolume study = largeStudy();
        study.codes[1234] ^= 1;
        embed(study, "s.burin");
        const Result<LoadedVolume> got = loadSessionImages(path("s.burin"));
        QVERIFY(!got);
        QVERIFY(got.error().arguments.value(1).contains(QStringLiteral("not those")));
    }

    void historyOpensWithoutThem()
    {
        makeSession("s.burin");
        QVERIFY(test::runSql(path("s.burin"), QStringLiteral("DELETE FROM pixels")));
        const auto contents = checkSession(path("s.burin"));
        QVERIFY(contents && !contents->damage);
        const Result<LoadedVolume> study = loadSessionStudy(path("s.burin"), contents->source);
        QVERIFY(study && !study->notFromStudy);
        reference::ReferenceEngine engine;
        const auto session = EditSession::open(engine, *study, path("s.burin"));
        QVERIFY(session);
        QCOMPARE((*session)->history().rows().size(), test::manyEdits().size());
    }

    void salvageTakesThemAlong()
    {
        makeSession("s.burin");
        QVERIFY(
            test::runSql(path("s.burin"), QStringLiteral("UPDATE row SET name='X' WHERE id=5")));
        const Result<SessionContents> sound = checkSession(path("s.burin"));
        QVERIFY(sound && sound->damage);
        QVERIFY(salvageSession(path("s.burin"), *sound, path("t.burin")));
        const Result<LoadedVolume> got = loadSessionImages(path("t.burin"));
        QVERIFY2(got, qPrintable(got ? QString() : test::errorText(got.error())));
        verifySame(*got, test::openVolume(path("ct")));
        QVERIFY(test::runSql(path("s.burin"), QStringLiteral("DELETE FROM pixels")));
        QVERIFY(salvageSession(path("s.burin"), *sound, path("u.burin")));
        QCOMPARE(loadSessionImages(path("u.burin")).error().code, ErrorCode::NoImages);
        QCOMPARE((*SessionFile::open(path("u.burin"), SessionFile::Access::ReadOnly))
                     ->contents()
                     .rows.size(),
            std::size_t(4));
    }

    void aFullDiskLeavesNothing()
    {
        const LoadedVolume study = largeStudy();
        const QStringList before = files();
        {
            const test::FileSizeLimit limit(1 << 20);
            const auto staged = stageImages(path("s.burin"), true, study);
            QVERIFY(!staged);
            QCOMPARE(staged.error().code, ErrorCode::FileUnwritable);
            QCOMPARE(staged.error().arguments.value(0), path("s.burin"));
        }
        QCOMPARE(files(), before);
        const test::SmallFileSystem disk(3000);
        if (!disk.problem().isEmpty())
            QSKIP(qPrintable(QStringLiteral("no small file system: ") + disk.problem()));
        const auto staged = stageImages(disk.filePath(QStringLiteral("s.burin")), true, study);
        QVERIFY(!staged);
        QCOMPARE(staged.error().code, ErrorCode::FileUnwritable);
        QCOMPARE(staged.error().arguments.value(1), systemReason(ENOSPC));
        QVERIFY(QDir(disk.filePath(QString())).isEmpty(QDir::Files | QDir::Hidden));
    }

    void writingAndReadingAreCancelled()
    {
        const LoadedVolume study = largeStudy();
        embed(study, "s.burin");
        const QStringList before = files();
        int told = 0;
        Progress* mine = nullptr;
        Progress progress([&](core::ProgressStep, int done, int total) {
            QCOMPARE(total, 3);
            told += 1;
            if (done == 1)
                mine->cancel();
        });
        mine = &progress;
        QCOMPARE(
            stageImages(path("t.burin"), true, study, progress).error().code, ErrorCode::Cancelled);
        QCOMPARE(told, 2);
        QCOMPARE(files(), before);
        QCOMPARE(loadSessionImages(path("s.burin"), progress).error().code, ErrorCode::Cancelled);
    }

    /// DICOM SEG and NIfTI need the headers of the source's files; those in the session will do.
    void exportsWithoutTheStudy_data()
    {
        QTest::addColumn<bool>("nifti");
        QTest::newRow("DICOM") << false;
        QTest::newRow("NIfTI") << true;
    }
    void exportsWithoutTheStudy()
    {
        QFETCH(bool, nifti);
        if (nifti)
            writeNifti(path("small.nii"));
        const QString source = nifti ? path("small.nii") : path("ct");
        embed(test::openVolume(source), "s.burin");
        QVERIFY(QDir().rename(source, path("gone")));
        const Result<LoadedVolume> loaded = loadSessionImages(path("s.burin"));
        QVERIFY(loaded);
        std::vector<std::uint8_t> labels(loaded->codes.size());
        for (std::size_t i = 0; i < labels.size(); ++i)
            labels[i] = loaded->codes[i] > 1500 ? 1 : 0;
        Segment segment;
        segment.label = 1;
        segment.name = QStringLiteral("Bone");
        segment.code = {QStringLiteral("SCT"), QStringLiteral("272673000"), QStringLiteral("Bone")};
        ExportRequest request{.format = ExportFormat::Nifti,
            .file = path("mask.nii.gz"),
            .segments = {segment},
            .planes = {{.plane = 0, .labels = labels}}};
        Result<ExportReport> report = exportMask(loaded->volume, request, Progress());
        QVERIFY2(report, qPrintable(report ? QString() : test::errorText(report.error())));
        QVERIFY(ui::reportTexts(report->cautions)
                    .join(u' ')
                    .contains(QStringLiteral("headers that the session")));
        request.format = ExportFormat::DicomSeg;
        request.file = path("mask.dcm");
        report = exportMask(loaded->volume, request, Progress());
        if (nifti) {
            QVERIFY(!report);
            QCOMPARE(report.error().code, ErrorCode::UnsupportedFormat);
            return;
        }
        QVERIFY2(report, qPrintable(report ? QString() : test::errorText(report.error())));
        // Without the headers it is refused in words.
        Volume bare = loaded->volume;
        bare.keptHeaders = std::make_shared<const KeptHeaders>();
        request.file = path("other.dcm");
        const Result<ExportReport> refused = exportMask(bare, request, Progress());
        QVERIFY(!refused);
        QVERIFY(refused.error().arguments.value(1).contains(QStringLiteral("not its header")));
        QVERIFY(!QFile::exists(path("other.dcm")));
    }
};

BURIN_TEST(SessionImagesTest)

} // namespace sessionImagesTest

#include "SessionImagesTest.moc"
