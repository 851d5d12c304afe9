// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditDocumentation.h"
#include "core/recipe/Recipe.h"
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/sessions/GoldenSessions.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace houseGoldenTest {

using namespace core;

/// However the house is rebuilt: recipes, sessions, names and hashes stay what they were when they
/// were recorded (tests/data/gold). On the oracle; HouseGoldenGlTest does the same by the program.
class HouseGoldenTest : public QObject {
    Q_OBJECT

    static void everyName()
    {
        QTest::addColumn<QString>("name");
        for (const QString& name : test::goldenNames())
            QTest::newRow(qUtf8Printable(name)) << name;
    }
    static QString gold(const QString& name) { return test::goldenFolder() + u'/' + name; }
    /// The name of the edit of a row, as rowsOf() tells of it; empty if the line is none.
    static QString editOfRow(const QString& line)
    {
        const QString edit = line.section(QStringLiteral(" | "), -1);
        return QJsonDocument::fromJson(edit.toUtf8())
            .object()
            .value(QStringLiteral("edit"))
            .toString();
    }
    /// As the program reads it, from wherever it lies.
    LoadedVolume loadedStudy() const
    {
        LoadedVolume study = *loadVolume(m_studies.filePath(QStringLiteral("golden.nii.gz")));
        study.volume.sourcePath = QStringLiteral("golden.nii.gz");
        return study;
    }

    QTemporaryDir m_studies;

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(test::writeStudy(
            m_studies.filePath(QStringLiteral("golden.nii.gz")), test::goldenStudy()));
    }
    void init() { test::failOnUnexpectedMessages(); }

    /// An edit that no recipe here holds, or that changed nothing when it was recorded, would be
    /// held to nothing: who adds a kind adds it to one of them.
    void everyEditIsThere()
    {
        QStringList inNoRecipe;
        for (const EditDocumentation& edit : editDocumentation())
            inNoRecipe += edit.name;
        QCOMPARE(std::size_t(inNoRecipe.size()), AllEdits::count);
        QStringList inNoRow = inNoRecipe;
        for (const QString& name : test::goldenNames()) {
            const Result<Recipe> recipe = readRecipe(gold(name + QStringLiteral(".json")));
            QVERIFY2(recipe, qPrintable(name));
            for (const RecipeStep& step : recipe->steps)
                inNoRecipe.removeAll(stepName(step));
            QFile recorded(gold(name + QStringLiteral(".txt")));
            QVERIFY2(recorded.open(QIODevice::ReadOnly), qPrintable(recorded.fileName()));
            const QString text = QString::fromUtf8(recorded.readAll());
            for (const QString& line : text.split(u'\n'))
                inNoRow.removeAll(editOfRow(line));
        }
        QVERIFY2(inNoRecipe.isEmpty(), qPrintable(inNoRecipe.join(QStringLiteral(", "))));
        // What goes on with a growth is a growth in its row.
        QCOMPARE(inNoRow, QStringList{QStringLiteral("resume")});
    }

    void recipesComeToTheSame_data() { everyName(); }
    void recipesComeToTheSame()
    {
        QFETCH(const QString, name);
        Result<Recipe> recipe = readRecipe(gold(name + QStringLiteral(".json")));
        QVERIFY(recipe);
        LoadedVolume study = loadedStudy();
        fillSurfaces(*recipe, study.volume);
        QVERIFY(readMasks(*recipe, study.volume));
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("s.burin"));
        reference::ReferenceEngine engine;
        auto session = *EditSession::create(engine, std::move(study), {.file = file});
        QString steps;
        for (const RecipeStep& step : recipe->steps) {
            const auto* edit = std::get_if<Edit>(&step);
            const auto* move = std::get_if<HistoryMove>(&step);
            const Result<void> done = edit              ? session->apply(*edit)
                : move->kind == HistoryMove::Kind::Undo ? session->undo()
                : move->kind == HistoryMove::Kind::Redo ? session->redo()
                                                        : session->goTo(move->row);
            QVERIFY2(done && session->settle(), qPrintable(stepName(step)));
            steps += QStringLiteral("%1 | %2 | %3\n")
                         .arg(stepName(step))
                         .arg(session->history().position())
                         .arg(QString::fromLatin1(session->stateHash()));
        }
        session.reset();
        const QString difference = test::differenceFromGold(
            name + QStringLiteral(".txt"), steps + u'\n' + test::rowsOf(file));
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
        // What each row says is kept beside its name.
        const Result<SessionContents> kept = checkSession(file);
        QVERIFY(kept && kept->isWhole());
        for (const HistoryRow& row : kept->rows)
            QVERIFY2(row.title && canonicalName(*row.title) == row.name, qPrintable(row.name));
        if (qEnvironmentVariableIsSet("BURIN_RECORD_GOLD")) {
            QFile::remove(gold(name + QStringLiteral(".burin")));
            QVERIFY(QFile::copy(file, gold(name + QStringLiteral(".burin"))));
        }
    }

    /// A session of before opens, and every row of it has the voxels that it had.
    void sessionsHoldWhatTheyHeld_data() { everyName(); }
    void sessionsHoldWhatTheyHeld()
    {
        QFETCH(const QString, name);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("s.burin"));
        QVERIFY(QFile::copy(gold(name + QStringLiteral(".burin")), file));
        QVERIFY(QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner));
        reference::ReferenceEngine engine;
        auto session = EditSession::open(engine, loadedStudy(), file);
        QVERIFY2(session,
            session ? "" : qUtf8Printable(session.error().arguments.join(QStringLiteral(", "))));
        const std::size_t rows = (*session)->history().rows().size();
        QVERIFY(rows > 0);
        for (std::size_t row = rows; row > 0; --row) {
            QVERIFY((*session)->goTo(RowId(row)) && (*session)->settle());
            QCOMPARE((*session)->stateHash(), (*session)->history().row(RowId(row)).stateHash);
        }
        // The rows that the text tells of are those of the file.
        const QString recorded = test::rowsOf(gold(name + QStringLiteral(".burin")));
        QFile text(gold(name + QStringLiteral(".txt")));
        QVERIFY(text.open(QIODevice::ReadOnly));
        QVERIFY(QString::fromUtf8(text.readAll()).endsWith(u'\n' + recorded));
    }
};

BURIN_TEST(HouseGoldenTest)

} // namespace houseGoldenTest

#include "HouseGoldenTest.moc"
