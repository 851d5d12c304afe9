// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/DeidentifySession.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/session/EditSession.h"
#include "core/session/SessionKeyframes.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/MarkedSeries.h"
#include "tests/support/series/SessionFiles.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace deidentifySessionTest {

using namespace core;

namespace {

StudyIdentity patient()
{
    StudyIdentity identity;
    identity.patientName = QStringLiteral("MARKERNAME^Otto");
    identity.patientId = QStringLiteral("MARKERID");
    identity.birthDate = QStringLiteral("1933-02-14");
    identity.studyUid = QStringLiteral("2.25.7700770077001");
    return identity;
}

/// A session on a study that lies in a folder of a telling name, by a user who gave theirs.
QByteArray makeMarked(const QString& path, const QString& segment)
{
    reference::ReferenceEngine engine;
    LoadedVolume study = test::smallStudy();
    study.volume.sourcePath = QStringLiteral("/somewhere/MARKERPATH");
    study.volume.identity = patient();
    study.volume.identity.seriesUid = QStringLiteral("2.25.7700770077002");
    study.volume.identity.seriesDescription = QStringLiteral("Kopf MARKERTEXT");
    study.volume.identity.studyDate = QStringLiteral("1933-02-14");
    const auto session = *EditSession::create(engine, std::move(study), {.file = path});
    session->setOrigin([] { return presentOrigin(QStringLiteral("MARKERUSER")); });
    if (!session->apply(AddSegment{.name = segment, .rgb = 0xE0C068}) || !session->settle()
        || !session->apply(test::drillAt(-6)) || !session->settle())
        return {};
    session->keyframes().add(1, "MARKERTEXT in a picture");
    static_cast<void>(session->settle());
    return session->stateHash();
}

} // namespace

/// A session for others: the same steps, and nobody's name.
class DeidentifySessionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A mask's file may be named after the patient: in the row that imported it, and in those that
    /// quote that row.
    void noNameOfAMasksFileIsKept()
    {
        QTemporaryDir folder;
        const QString from = folder.filePath(QStringLiteral("from.burin"));
        const QString to = folder.filePath(QStringLiteral("to.burin"));
        {
            VoxelRuns runs;
            runs.append(5000, 12);
            ImportMask mask{.file = QStringLiteral("smith_ct.nrrd")};
            mask.size = test::smallStudy().volume.geometry.size;
            mask.segments = {{.name = QStringLiteral("Liver"),
                .rgb = 0x804020,
                .code = {},
                .voxels = packedRuns(runs)}};
            reference::ReferenceEngine engine;
            const auto session = *EditSession::create(engine, test::smallStudy(), {.file = from});
            // Into a segment that is there: an import that adds one is not undone alone.
            mask.as = SegmentWord{.number = 1, .name = {}};
            QVERIFY(session->apply(test::addSegment("Liver")) && session->settle());
            QVERIFY(session->apply(mask) && session->settle());
            QVERIFY(session->apply(test::drillAt(-6)) && session->settle());
            QVERIFY(session->apply(RevertRows{.rows = {2}}) && session->settle());
            const std::vector<HistoryRow>& rows = session->history().rows();
            QVERIFY(rows[1].name.contains(QStringLiteral("smith_ct.nrrd")));
            QVERIFY(rows.back().name.contains(QStringLiteral("smith_ct.nrrd")));
        }
        QVERIFY(deidentifySession(from, to, false, Deidentifier({}, patient())));
        const auto contents = checkSession(to);
        QVERIFY(contents && contents->isWhole());
        QCOMPARE(contents->rows.size(), std::size_t(4));
        for (const HistoryRow& row : contents->rows) {
            QVERIFY2(!row.name.contains(QStringLiteral("smith")), qPrintable(row.name));
            QVERIFY(!row.title || canonicalName(*row.title) == row.name);
        }
        QVERIFY(contents->rows.back().name.contains(QStringLiteral("mask.nrrd")));
        QFile written(to);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QVERIFY(!written.readAll().contains("smith"));
    }

    void theSameStepsWithoutThePatient()
    {
        QTemporaryDir folder;
        const QString from = folder.filePath(QStringLiteral("from.burin"));
        const QString to = folder.filePath(QStringLiteral("to.burin"));
        const QByteArray hash = makeMarked(from, QStringLiteral("Leber"));
        QVERIFY(!hash.isEmpty());
        QCOMPARE(test::markersIn(from).size(), 5);
        const auto done = deidentifySession(from, to, false, Deidentifier({}, patient()));
        QVERIFY2(done, qPrintable(done ? QString() : done.error().arguments.join(u'|')));
        QCOMPARE(*done,
            (DeidentifiedSession{
                .steps = 2, .method = QStringLiteral("PS3.15 basic profile; dates removed")}));
        QVERIFY2(test::markersIn(to).isEmpty(), test::markersIn(to).join(' ').constData());
        QVERIFY(QFile::exists(from));

        const auto contents = checkSession(to);
        QVERIFY(contents && contents->isWhole());
        QCOMPARE(contents->rows.size(), std::size_t(2));
        QCOMPARE(contents->rows.back().stateHash, hash);
        QVERIFY(!contents->rows.back().origin.at.isValid());
        for (const HistoryRow& row : contents->rows)
            QVERIFY(row.title && canonicalName(*row.title) == row.name);
        // It goes on where the study is, wherever that lies and whatever it is called now.
        reference::ReferenceEngine engine;
        const auto opened = EditSession::open(engine, test::smallStudy(), to);
        QVERIFY2(opened, qPrintable(opened ? QString() : opened.error().arguments.join(u'|')));
        QCOMPARE((*opened)->stateHash(), hash);
    }

    void datesAreShifted()
    {
        QTemporaryDir folder;
        const QString from = folder.filePath(QStringLiteral("from.burin"));
        const QString to = folder.filePath(QStringLiteral("to.burin"));
        QVERIFY(!makeMarked(from, QStringLiteral("Leber")).isEmpty());
        const DeidentifyOptions options{
            .dates = DeidentifyOptions::Dates::Shift, .shiftDays = -100};
        QVERIFY(deidentifySession(from, to, false, Deidentifier(options, patient())));
        QVERIFY(test::markersIn(to).isEmpty());
        const auto before = checkSession(from);
        const auto after = checkSession(to);
        QVERIFY(before && after);
        QCOMPARE(after->rows.front().origin.at, before->rows.front().origin.at.addDays(-100));
        QVERIFY(after->rows.front().origin.author.isEmpty());
        QCOMPARE(after->source.studyDate, QStringLiteral("1932-11-06"));
    }

    /// No step can be rewritten: one that names the patient keeps the whole from being written.
    void aSegmentThatNamesThePatientIsRefused()
    {
        QTemporaryDir folder;
        const QString from = folder.filePath(QStringLiteral("from.burin"));
        const QString to = folder.filePath(QStringLiteral("to.burin"));
        QVERIFY(!makeMarked(from, QStringLiteral("Leber Markername")).isEmpty());
        const auto done = deidentifySession(from, to, false, Deidentifier({}, patient()));
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::UnsupportedFormat);
        QVERIFY(done.error().arguments.value(1).contains(QStringLiteral("step 1")));
        QVERIFY(!QFile::exists(to));
    }

    void namesOfAllLengthsAndScriptsAreFound_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("segment");
        QTest::addColumn<bool>("isRefused");
        const auto row = [](const char* what, const char* name, const char* segment,
                             bool isRefused) {
            QTest::newRow(what) << QString::fromUtf8(name) << QString::fromUtf8(segment)
                                << isRefused;
        };
        row("three letters", "Kim^Sun", "Kim liver", true);
        row("three letters of another word", "Kim^Sun", "Kimono", false);
        row("Hangul", "김^철수", "철수", true);
        row("Hangul without a gap", "김^철수", "철수간", true);
        row("another name in Hangul", "김^철수", "영희", false);
        // What the program says itself names nobody: a row's name, and the name of a field.
        row("a word of the program", "Add^Max", "Leber", false);
        row("a field", "Code^Otto", "Leber", false);
    }

    /// Short names are looked for as whole words, those of scripts without gaps within others, too.
    void namesOfAllLengthsAndScriptsAreFound()
    {
        QFETCH(QString, name);
        QFETCH(QString, segment);
        QFETCH(bool, isRefused);
        QTemporaryDir folder;
        const QString from = folder.filePath(QStringLiteral("from.burin"));
        const QString to = folder.filePath(QStringLiteral("to.burin"));
        QVERIFY(!makeMarked(from, segment).isEmpty());
        StudyIdentity named;
        named.patientName = name;
        const auto done = deidentifySession(from, to, false, Deidentifier({}, named));
        QCOMPARE(!done, isRefused);
        QCOMPARE(QFile::exists(to), !isRefused);
        if (!isRefused)
            return;
        QCOMPARE(done.error().code, ErrorCode::UnsupportedFormat);
        QVERIFY(done.error().arguments.value(1).contains(QStringLiteral("step 1")));
    }

    /// Only a closed session is replaced. What another one has beside its name would be taken for
    /// the new one's, with all that it tells.
    void nothingElseIsReplaced()
    {
        QTemporaryDir folder;
        const QString from = folder.filePath(QStringLiteral("from.burin"));
        const QString to = folder.filePath(QStringLiteral("to.burin"));
        const QString beside = to + QStringLiteral("-wal");
        QVERIFY(!makeMarked(from, QStringLiteral("Leber")).isEmpty());
        const auto write = [](const QString& path) {
            QFile file(path);
            return file.open(QIODevice::WriteOnly) && file.write("somebody's") == 10;
        };
        const auto isRefused = [&] {
            const auto done = deidentifySession(from, to, true, Deidentifier({}, patient()));
            return !done && done.error().code == ErrorCode::FileUnwritable
                && done.error().arguments.value(0) == to;
        };
        QVERIFY(write(to) && isRefused());
        QCOMPARE(QFile(to).size(), qint64(10));
        QVERIFY(QFile::remove(to) && write(beside) && isRefused());
        QVERIFY(!QFile::exists(to));
        QCOMPARE(QFile(beside).size(), qint64(10));
        QVERIFY(QFile::remove(beside));

        // One that is open, and as its program leaves it that is killed.
        const QString open = folder.filePath(QStringLiteral("open.burin"));
        {
            reference::ReferenceEngine engine;
            const auto session = *EditSession::create(engine, test::smallStudy(), {.file = to});
            QVERIFY(session->apply(test::drillAt(-6)) && session->settle());
            QVERIFY(isRefused());
            QVERIFY(QFile::exists(beside));
            QVERIFY(QFile::copy(to, open) && QFile::copy(beside, open + QStringLiteral("-wal")));
        }
        // It was closed.
        QVERIFY(deidentifySession(from, to, true, Deidentifier({}, patient())));
        QVERIFY(QFile::remove(to) && QFile::rename(open, to)
            && QFile::rename(open + QStringLiteral("-wal"), beside));
        const QByteArray before = test::fingerprint(to) + test::fingerprint(beside);
        QVERIFY(isRefused());
        QCOMPARE(test::fingerprint(to) + test::fingerprint(beside), before);
    }

    void existingFileIsRefused()
    {
        QTemporaryDir folder;
        const QString from = folder.filePath(QStringLiteral("from.burin"));
        QVERIFY(!makeMarked(from, QStringLiteral("Leber")).isEmpty());
        const auto done = deidentifySession(from, from, false, Deidentifier({}, patient()));
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::FileExists);
    }
};

BURIN_TEST(DeidentifySessionTest)

} // namespace deidentifySessionTest

#include "DeidentifySessionTest.moc"
