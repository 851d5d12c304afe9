// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/texts/ProblemTexts.h"
#include "ui/workspace/InitialDisplay.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>

namespace runCommandGlTest {

using namespace core;
using test::burin;
using test::key;
using test::Outcome;
using test::toJson;

class RunCommandGlTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_studies;
    QString m_study;
    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QString write(const char* name, const QByteArray& content) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", name);
        return file.fileName();
    }
    QString recipe(const QJsonObject& content) const
    {
        return write("recipe.json", QJsonDocument(content).toJson());
    }
    QStringList runArguments(const QString& recipeFile) const
    {
        return {key("run"), recipeFile, key("--study"), m_study, key("--session"), path("a.burin")};
    }
    QStringList files() const { return QDir(m_folder->path()).entryList(QDir::Files); }

private Q_SLOTS:
    void initTestCase()
    {
        m_study = m_studies.filePath(QStringLiteral("small.nii.gz"));
        QVERIFY(test::writeStudy(m_study, test::smallStudy()));
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
    }

    void printsOneLinePerEditAndEqualsTheOracle()
    {
        const QString file = recipe({{key("edits"), toJson(test::manyEdits())},
            {key("export"),
                QJsonArray{
                    QJsonObject{{key("format"), key("nifti")}, {key("file"), path("out.nii.gz")}},
                    QJsonObject{
                        {key("format"), key("seg-nrrd")}, {key("file"), path("out.seg.nrrd")}}}}});
        const Outcome outcome = burin(runArguments(file));
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QCOMPARE(outcome.lines.size(), qsizetype(test::manyEdits().size() + 2));
        QVERIFY(files().contains(key("out.nii.gz")));
        QVERIFY(files().contains(key("out.seg.nrrd")));
        QVERIFY(!outcome.lines.last()[key("checked")].toString().isEmpty());

        reference::ReferenceEngine oracle;
        Result<LoadedVolume> volume = loadVolume(m_study);
        QVERIFY(volume);
        const auto session = *EditSession::create(oracle, *std::move(volume), {});
        for (std::size_t i = 0; i < test::manyEdits().size(); ++i) {
            QVERIFY(session->apply(test::manyEdits()[i]));
            QVERIFY(session->settle());
            const HistoryRow& row = session->history().rows().back();
            const QJsonObject& line = outcome.lines[qsizetype(i)];
            QCOMPARE(line[key("edit")].toString(), editName(test::manyEdits()[i]));
            QCOMPARE(line[key("row")].toInteger(), qint64(i + 1));
            QCOMPARE(line[key("name")].toString(), row.name);
            QCOMPARE(line[key("voxelsChanged")].toInteger(), qint64(row.statistics.voxelsChanged));
            QCOMPARE(line[key("bricks")].toInt(), row.statistics.bricks);
            QCOMPARE(line[key("hash")].toString().toLatin1(), row.stateHash);
            QVERIFY(line[key("ms")].isDouble());
        }
        const Outcome replayed = burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        QCOMPARE(replayed.lines.size(), qsizetype(test::manyEdits().size()));
    }

    void whatWasNoticedAboutTheStudyIsTold()
    {
        // One voxel so far out that steps between values are huge.
        QByteArray nrrd("NRRD0004\ntype: float\ndimension: 3\nsizes: 8 8 8\nencoding: ascii\n"
                        "space: left-posterior-superior\nspace origin: (0,0,0)\n"
                        "space directions: (1,0,0) (0,1,0) (0,0,1)\n\n3e38");
        for (int voxel = 1; voxel < 512; ++voxel)
            nrrd += ' ' + QByteArray::number(voxel);
        const QString study = write("far.nrrd", nrrd);
        const QString file = recipe({{key("edits"), toJson({test::newSegment(key("A"), 1)})}});
        const Outcome outcome =
            burin({key("run"), file, key("--study"), study, key("--session"), path("a.burin")});
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        const Result<LoadedVolume> loaded = loadVolume(study);
        QVERIFY(loaded);
        QCOMPARE(loaded->volume.problems.size(), std::size_t(1));
        QVERIFY(loaded->volume.problems.front().kind == VolumeProblem::Kind::InexactValues);
        QVERIFY2(outcome.complaint.contains(ui::problemText(loaded->volume.problems.front().said)),
            qPrintable(outcome.complaint));
    }

    void carvedVolumeAndCoverageAreExports()
    {
        const QJsonArray exports{QJsonObject{{key("format"), key("coverage")}, {key("layer"), 1},
                                     {key("file"), path("coverage.nii.gz")}},
            QJsonObject{{key("format"), key("carved-volume")}, {key("file"), path("carved.nii")},
                {key("fill"), -2000}}};
        const Outcome run = burin(runArguments(
            recipe({{key("edits"), toJson({test::drillAt(0)})}, {key("export"), exports}})));
        QVERIFY2(run.status == 0, qPrintable(run.complaint));
        const Result<LoadedVolume> study = loadVolume(m_study);
        const Result<LoadedVolume> coverage = loadVolume(path("coverage.nii.gz"));
        const Result<LoadedVolume> carved = loadVolume(path("carved.nii"));
        QVERIFY(study && coverage && carved);
        int cut = 0;
        for (std::size_t i = 0; i < study->codes.size(); ++i) {
            const bool gone = coverage->volume.encoding.value(coverage->codes[i]) >= 128.0;
            cut += gone ? 1 : 0;
            QCOMPARE(carved->volume.encoding.value(carved->codes[i]),
                gone ? -2000.0 : study->volume.encoding.value(study->codes[i]));
        }
        QVERIFY(cut > 0);
    }

    /// Issue 4: a stroke written by hand need not say what is seen.
    void aCutWithoutSurfaceStartsOnTheOneThatTheWindowShows()
    {
        const std::vector<glm::dvec2> outline{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}};
        const Edit peel = test::peelWith({.view = test::frontView()}, outline);
        const Edit scissors =
            test::scissorsWith({.view = test::frontView(), .depthMm = 6.0}, outline);
        const Edit drill = test::drillAt(0);
        const test::StrokeFacts said = test::factsOfStroke(drill);
        const Edit laser =
            test::laserWith({.view = said.view, .mask = said.mask, .samples = said.samples});
        QJsonArray edits;
        for (const QJsonValue& cut : toJson({drill, laser, peel, scissors, drill})) {
            QJsonObject edit = cut.toObject();
            edit.remove(key("surface"));
            edits.append(edit);
        }
        QJsonObject back = edits.takeAt(4).toObject();
        back.insert(key("as"), back.value(key("edit")));
        back.insert(key("edit"), key("restore"));
        back.remove(key("restore"));
        edits.append(back);
        const Outcome run = burin(runArguments(recipe({{key("edits"), edits}})));
        QVERIFY2(run.status == 0, qPrintable(run.complaint));
        QCOMPARE(run.lines.size(), 5);
        QVERIFY(run.lines.first()[key("voxelsChanged")].toInt() > 0);
        const Result<LoadedVolume> study = loadVolume(m_study);
        QVERIFY(study);
        const double shown = ui::initialVolumeDisplay(study->volume).surfaceThreshold;
        const auto session = SessionFile::open(path("a.burin"), SessionFile::Access::ReadOnly);
        QVERIFY(session);
        QVERIFY((*session)->contents().rows.size() >= 4);
        for (const HistoryRow& row : (*session)->contents().rows)
            QCOMPARE(editToJson(row.edit)[key("surface")].toObject()[key("threshold")].toDouble(),
                shown);

        QJsonObject half = edits.first().toObject();
        half[key("surface")] = QJsonObject();
        const Outcome refused =
            burin(runArguments(recipe({{key("edits"), QJsonArray{half}}})) << key("--force"));
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.complaint.contains(key("drill.surface.threshold")),
            qPrintable(refused.complaint));
        const Outcome documented = burin({key("edits"), key("--json")});
        int told = 0;
        for (const QJsonValue& edit : QJsonDocument::fromJson(documented.output).array()) {
            for (const QJsonValue& field : edit.toObject()[key("fields")].toArray()) {
                if (field.toObject()[key("name")] != QJsonValue(key("surface")))
                    continue;
                ++told;
                QVERIFY(!field.toObject()[key("required")].toBool());
            }
        }
        QCOMPARE(told, 4);
    }

    void anEditThatChangesNothingSaysSo()
    {
        const QString file = recipe({{key("edits"),
            toJson({test::addSegment("A"), test::growBrain(), test::addSegment("B")})}});
        const Outcome outcome = burin(runArguments(file));
        QCOMPARE(outcome.status, 0);
        QCOMPARE(outcome.lines.size(), 3);
        QVERIFY(outcome.lines[1][key("row")].isNull());
        QCOMPARE(outcome.lines[1][key("hash")], outcome.lines[0][key("hash")]);
        QCOMPARE(outcome.lines[2][key("row")].toInt(), 2);
    }

    void seedsThatAreNoneSayWhy()
    {
        const QString file = recipe({{key("edits"),
            toJson({test::addSegment("A"), test::addSegment("B"), test::seedInBrain(1),
                test::growBrain(1), test::seedInBrain(2)})}});
        const Outcome outcome = burin(runArguments(file));
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QCOMPARE(outcome.lines.size(), 5);
        QVERIFY(outcome.lines[4][key("row")].isNull());
        QCOMPARE(outcome.lines[4][key("name")].toString(),
            key("nothing changed: 0 of 2 voxels (2 belong to 'A')"));
    }

    void refusesInOneLineAndLeavesNothing_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* name, QByteArray content, const char* named) {
            QTest::newRow(name) << content.replace('\'', '"') << QString(QLatin1String(named));
        };
        row("unknown edit", "{'edits':[{'edit':'growl'}]}", "growl");
        row("which edit",
            "{'edits':[{'edit':'addSegment','name':'A','color':'#000000'},{'edit':'growl'}]}",
            "edit 2");
        row("missing field", "{'edits':[{'edit':'grow','lower':1,'steps':1}]}", "grow.upper");
        row("wrong type", "{'edits':[{'edit':'grow','lower':'1','upper':2,'steps':1}]}",
            "grow.lower");
        row("unknown field", "{'edits':[{'edit':'grow','lower':1,'upper':2,'steps':1,'mode':2}]}",
            "grow.mode");
        row("unknown segment", "{'edits':[{'edit':'seed','segment':1,'pointsLps':[[0,0,120]]}]}",
            "segment 1");
        row("seed outside",
            "{'edits':[{'edit':'addSegment','name':'A','color':'#000000'},{'edit':'seed','segment':"
            "1,'pointsLps':[[0,0,9000]]}]}",
            "9000");
        row("crossed bounds", "{'edits':[{'edit':'grow','lower':3,'upper':2,'steps':1}]}",
            "grow.upper");
        row("no edits", "{}", "edits");
        row("unknown part", "{'edits':[],'exports':[]}", "exports");
        row("no JSON", "{'edits':[\n}", "line 2");
        row("another format", "{'edits':[],'export':[{'format':'3mf','file':'OUT/a.3mf'}]}", "3mf");
        row("coverage of what", "{'edits':[],'export':[{'format':'coverage','file':'OUT/a.nii'}]}",
            "layer");
        row("coverage of no layer",
            "{'edits':[],'export':[{'format':'coverage','layer':7,'file':'OUT/a.nii'}]}",
            "sculpt layer 7");
        row("a DICOM series of a NIfTI file",
            "{'edits':[],'export':[{'format':'carved-volume','file':'OUT/carved'}]}",
            "NIfTI can be exported");
        row("another ending", "{'edits':[],'export':[{'format':'nifti','file':'OUT/a.img'}]}",
            "a.img");
        row("another ending for 3D Slicer",
            "{'edits':[],'export':[{'format':'seg-nrrd','file':'OUT/a.nrrd'}]}", ".seg.nrrd");
        row("no such folder", "{'edits':[],'export':[{'format':'nifti','file':'OUT/no/a.nii'}]}",
            "no");
        row("SEG of a NIfTI volume",
            "{'edits':[],'export':[{'format':'dicom-seg','file':'OUT/a.dcm'}]}", "a.dcm");
        row("the export exists",
            "{'edits':[],'export':[{'format':'nifti','file':'OUT/recipe.json.nii'}]}",
            "recipe.json.nii");
    }
    void refusesInOneLineAndLeavesNothing()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, named);
        write("recipe.json.nii", "here before");
        const QString file =
            write("recipe.json", content.replace("OUT", m_folder->path().toUtf8()));
        const QStringList before = files();
        const Outcome outcome = burin(runArguments(file));
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.lines.isEmpty());
        QVERIFY2(outcome.complaint.contains(named), qPrintable(outcome.complaint));
        QCOMPARE(outcome.complaint.count(QLatin1Char('\n')), 1);
        QCOMPARE(files(), before);
    }

    void badPathsAreNamed_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("no recipe") << 0;
        QTest::newRow("no study") << 1;
        QTest::newRow("an empty folder") << 2;
        QTest::newRow("a truncated study") << 3;
        QTest::newRow("a session in no folder") << 4;
        QTest::newRow("the session exists") << 5;
    }
    void badPathsAreNamed()
    {
        QFETCH(int, what);
        QString recipeFile = recipe({{key("edits"), toJson({test::addSegment("A")})}});
        QString study = m_study;
        QString session = path("a.burin");
        QString named;
        if (what == 0)
            recipeFile = named = path("none.json");
        if (what == 1)
            study = named = path("none");
        if (what == 2) {
            study = named = path("empty");
            QVERIFY(QDir().mkdir(study));
        }
        if (what == 3) {
            study = named = path("cut.nii.gz");
            QVERIFY(QFile::copy(m_study, study));
            QVERIFY(QFile::resize(study, QFile(study).size() / 2));
        }
        if (what == 4)
            session = named = path("no/such/a.burin");
        if (what == 5)
            named = write("a.burin", "here before");
        const QStringList before = files();
        const Outcome outcome =
            burin({key("run"), recipeFile, key("--study"), study, key("--session"), session});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(named), qPrintable(outcome.complaint));
        QCOMPARE(outcome.complaint.count(QLatin1Char('\n')), 1);
        QCOMPARE(files(), before);
        if (what == 5) {
            QFile file(session);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.readAll(), QByteArray("here before"));
        }
    }

    void wrongArgumentsAreStatusTwo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("nothing") << QStringList{key("run")};
        QTest::newRow("no study") << QStringList{
            key("run"), key("r.json"), key("--session"), key("s")};
        QTest::newRow("no session")
            << QStringList{key("run"), key("r.json"), key("--study"), key("s")};
        QTest::newRow("unknown") << QStringList{key("run"), key("r.json"), key("--fast")};
        QTest::newRow("no value") << QStringList{key("run"), key("r.json"), key("--study")};
        QTest::newRow("replay nothing") << QStringList{key("replay"), key("--verify")};
        QTest::newRow("replay without verify") << QStringList{key("replay"), key("a.burin")};
    }
    void wrongArgumentsAreStatusTwo()
    {
        QFETCH(QStringList, arguments);
        QCOMPARE(burin(arguments).status, 2);
    }

    void forceReplaces()
    {
        const QString file =
            recipe({{key("edits"), toJson({test::addSegment("A"), test::drillAt(0)})}});
        QCOMPARE(burin(runArguments(file)).status, 0);
        QCOMPARE(burin(runArguments(file)).status, 1);
        QCOMPARE(burin(runArguments(file) + QStringList{key("--force")}).status, 0);
        QCOMPARE(burin({key("replay"), path("a.burin"), key("--verify")}).status, 0);
    }

    void replayNamesTheFirstRowThatDisagrees()
    {
        // A session whose chain is whole but whose hashes are not those of its edits: made by
        // writing the file by its own writer, with one hash made up.
        const Result<LoadedVolume> volume = loadVolume(m_study);
        {
            const auto file =
                SessionFile::create(path("a.burin"), SessionSource::of(volume->volume));
            QVERIFY(file);
            HistoryRow first;
            first.id = 1;
            first.name = key("Add segment 'A'");
            first.edit = test::addSegment("A");
            (*file)->addRow(first);
            (*file)->completeRow(1, QByteArray(64, 'a'), {});
            QVERIFY((*file)->flush());
        }
        const Outcome outcome = burin({key("replay"), path("a.burin"), key("--verify")});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(key("row 1")), qPrintable(outcome.complaint));
    }

    void replayRefusesATamperedSession()
    {
        const QString file =
            recipe({{key("edits"), toJson({test::addSegment("A"), test::drillAt(0)})}});
        QCOMPARE(burin(runArguments(file)).status, 0);
        {
            QSqlDatabase database = QSqlDatabase::addDatabase(key("QSQLITE"), key("test"));
            database.setDatabaseName(path("a.burin"));
            QVERIFY(database.open());
            QSqlQuery query(database);
            QVERIFY(query.exec(key(
                "UPDATE row SET edit=replace(edit,'\"depthMm\":5','\"depthMm\":4') WHERE id=2")));
            QCOMPARE(query.numRowsAffected(), 1);
        }
        QSqlDatabase::removeDatabase(key("test"));
        const Outcome outcome = burin({key("replay"), path("a.burin"), key("--verify")});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(key("row 2")), qPrintable(outcome.complaint));
    }

    void replayWalksBranches()
    {
        {
            reference::ReferenceEngine oracle;
            const auto session =
                *EditSession::create(oracle, *loadVolume(m_study), {.file = path("a.burin")});
            for (const Edit& edit : test::manyEdits())
                QVERIFY(session->apply(edit));
            QVERIFY(session->settle());
            QVERIFY(session->goTo(3));
            QVERIFY(session->apply(test::growBrain(1)));
            QVERIFY(session->settle());
            QVERIFY(session->goTo(8));
            QVERIFY(session->apply(test::drillAt(2)));
            QVERIFY(session->settle());
        }
        const Outcome outcome = burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QCOMPARE(outcome.lines.size(), qsizetype(test::manyEdits().size() + 2));
        const Outcome elsewhere =
            burin({key("replay"), path("a.burin"), key("--verify"), key("--study"), path("none")});
        QCOMPARE(elsewhere.status, 1);
    }

    void whatWasAcknowledgedSurvivesAKill()
    {
        std::vector<Edit> edits{test::addSegment("Brain"), test::seedInBrain(1)};
        for (int i = 0; i < 60; ++i)
            edits.push_back(i % 2 ? Edit(test::drillAt(i % 17 - 8)) : Edit(test::growBrain(1)));
        const QString file = recipe({{key("edits"), toJson(edits)}});
        const int kills = qEnvironmentVariableIsSet("BURIN_LONG") ? 10 : 2;
        for (int round = 0; round < kills; ++round) {
            QVERIFY(core::removeSession(path("a.burin")));
            QProcess process;
            process.start(QStringLiteral(BURIN_PROGRAM), runArguments(file));
            QList<QJsonObject> acknowledged;
            while (acknowledged.size() < 5 + round * 2 && process.waitForReadyRead(60000)) {
                while (process.canReadLine())
                    acknowledged.append(QJsonDocument::fromJson(process.readLine()).object());
            }
            process.kill(); // SIGKILL
            process.waitForFinished();
            while (process.canReadLine())
                acknowledged.append(QJsonDocument::fromJson(process.readLine()).object());
            QVERIFY(acknowledged.size() >= 5);

            reference::ReferenceEngine oracle;
            const auto session = EditSession::open(oracle, *loadVolume(m_study), path("a.burin"));
            QVERIFY2(
                session, qPrintable(session ? QString() : session.error().arguments.join(u' ')));
            qint64 lastRow = 0;
            for (const QJsonObject& line : acknowledged) {
                if (line[key("row")].isNull())
                    continue;
                lastRow = line[key("row")].toInteger();
                QCOMPARE((*session)->history().row(lastRow).stateHash,
                    line[key("hash")].toString().toLatin1());
            }
            // The stroke under way may be there or not; no more than that one.
            const auto rows = qint64((*session)->history().rows().size());
            QVERIFY(rows == lastRow || rows == lastRow + 1);
            QCOMPARE((*session)->history().position(), RowId(rows));
        }
    }
};

BURIN_TEST(RunCommandGlTest)

} // namespace runCommandGlTest

#include "RunCommandGlTest.moc"
