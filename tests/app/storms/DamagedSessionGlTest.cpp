// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

namespace damagedSessionGlTest {

using namespace core;
using test::burin;
using test::key;
using test::Outcome;

/// A damaged session on the command line: what is sound of what was asked for is given, the rest is
/// named in one sentence, and the status is 0 where nothing that was asked for is lost.
class DamagedSessionGlTest : public QObject {
    Q_OBJECT

private:
    static constexpr int rows = 13;
    QTemporaryDir m_pattern;
    QString m_study;
    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QStringList files() const { return QDir(m_folder->path()).entryList(QDir::Files); }
    Outcome history(const QStringList& more) const
    {
        return burin(QStringList{key("history"), path("a.burin")} + more);
    }
    Outcome replay(const QStringList& more) const
    {
        return burin(QStringList{key("replay"), path("a.burin"), key("--study"), m_study} + more);
    }
    Outcome append(const Edit& edit) const
    {
        QFile file(path("r.json"));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no recipe");
        file.write(
            QJsonDocument(QJsonObject{{key("edits"), QJsonArray{editToJson(edit)}}}).toJson());
        file.close();
        const Outcome outcome = burin({key("run"), path("r.json"), key("--study"), m_study,
            key("--session"), path("a.burin"), key("--append")});
        file.remove();
        return outcome;
    }
    static QJsonObject listing(const Outcome& outcome)
    {
        return QJsonDocument::fromJson(outcome.output).object();
    }
    /// One line that names the file and holds @p words; empty: nothing is told.
    static bool tells(const Outcome& outcome, const QString& words)
    {
        const QStringList lines = outcome.complaint.split(QLatin1Char('\n'), Qt::SkipEmptyParts)
                                      .filter(QStringLiteral("damaged"));
        return words.isEmpty() ? lines.isEmpty()
                               : lines.size() == 1 && lines.front().contains(words);
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_study = m_pattern.filePath(key("small.nii.gz"));
        QVERIFY(test::writeStudy(m_study, test::smallStudy()));
        QJsonArray steps = test::toJson(test::manyEdits());
        steps.append(QJsonObject{{key("edit"), key("goTo")}, {key("seq"), 4}});
        steps.append(editToJson(test::drillAt(1))); // row 12, behind row 4
        steps.append(editToJson(test::addSegment("Z")));
        steps.append(QJsonObject{{key("edit"), key("undo")}});
        QFile recipe(m_pattern.filePath(key("r.json")));
        QVERIFY(recipe.open(QIODevice::WriteOnly));
        recipe.write(QJsonDocument(QJsonObject{{key("edits"), steps}}).toJson());
        recipe.close();
        const Outcome made = burin({key("run"), recipe.fileName(), key("--study"), m_study,
            key("--session"), m_pattern.filePath(key("a.burin"))});
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QFile::copy(m_pattern.filePath(key("a.burin")), path("a.burin")));
    }

    void historyListsWhatIsSound_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<int>("listed");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("told");
        QTest::newRow("sound") << QString() << rows << 0 << QString();
        QTest::newRow("a row") << key("UPDATE row SET name='X' WHERE id=4") << 3 << 1
                               << key("row 4 'X' and the 9 after it cannot be read");
        QTest::newRow("position") << key("UPDATE state SET value=77 WHERE key='position'") << rows
                                  << 1 << key("where it stood cannot be read");
        QTest::newRow("no number") << key("UPDATE state SET value='x' WHERE key='position'") << rows
                                   << 1 << key("where it stood cannot be read");
        QTest::newRow("visited") << key("DROP TABLE visited") << rows << 1
                                 << key("where it stood cannot be read");
        // Row 7 lies on the old future.
        QTest::newRow("a difference on a branch")
            << key("DELETE FROM delta WHERE row=7") << rows << 0 << key("what row 7 '");
        QTest::newRow("two differences") << key("DELETE FROM delta WHERE row=7 OR row=12") << rows
                                         << 0 << key("what the rows 7, 12 changed");
    }
    void historyListsWhatIsSound()
    {
        QFETCH(QString, sql);
        QFETCH(int, listed);
        QFETCH(int, status);
        QFETCH(QString, told);
        const QByteArray whole = test::fingerprint(path("a.burin"));
        if (!sql.isEmpty())
            static_cast<void>(test::runSql(path("a.burin"), sql));
        const QByteArray before = test::fingerprint(path("a.burin"));
        QCOMPARE(before == whole, sql.isEmpty());
        const Outcome json = history({key("--json")});
        QCOMPARE(json.status, status);
        QVERIFY2(tells(json, told), qPrintable(json.complaint));
        QCOMPARE(listing(json)[key("commands")].toArray().size(), listed);
        const QJsonArray problems = listing(json)[key("problems")].toArray();
        QCOMPARE(problems.size(), told.isEmpty() ? 0 : 1);
        QVERIFY(problems.isEmpty() || problems[0].toString().contains(told));
        const Outcome table = history({});
        QCOMPARE(table.status, status);
        QVERIFY2(tells(table, told), qPrintable(table.complaint));
        QVERIFY(table.output.contains(QByteArray::number(listed)));
        const Outcome asRecipe = history({key("--as-recipe")});
        QCOMPARE(asRecipe.status, status);
        QVERIFY2(tells(asRecipe, told), qPrintable(asRecipe.complaint));
        QVERIFY(!listing(asRecipe)[key("edits")].toArray().isEmpty());
        QCOMPARE(test::fingerprint(path("a.burin")), before);
    }

    void replayGoesUpToTheDamage()
    {
        QVERIFY(test::runSql(path("a.burin"), key("UPDATE row SET name='X' WHERE id=8")));
        const QString told = key("row 8 'X' and the 5 after it cannot be read");
        const QStringList exports{key("--export"), path("x.nii.gz"), key("--force")};

        const Outcome before = replay({key("--to"), key("5"), key("--verify")});
        QCOMPARE(before.status, 0);
        QVERIFY2(tells(before, told), qPrintable(before.complaint));
        QCOMPARE(before.lines.size(), 5);
        QCOMPARE(replay(QStringList{key("--to"), key("7")} + exports).status, 0);
        QVERIFY(QFile::remove(path("x.nii.gz")));

        const Outcome all = replay({key("--verify")});
        QCOMPARE(all.status, 1);
        QVERIFY2(tells(all, told), qPrintable(all.complaint));
        QCOMPARE(all.lines.size(), 7);

        const Outcome behind = replay(QStringList{key("--to"), key("9")} + exports);
        QCOMPARE(behind.status, 1);
        QVERIFY2(tells(behind, told), qPrintable(behind.complaint));
        QCOMPARE(replay({key("--to"), key("99"), key("--verify")}).status, 2);
        // It stood behind the damage: no other state is to be taken for that one.
        const Outcome there = replay(exports);
        QCOMPARE(there.status, 1);
        QVERIFY2(tells(there, key("--to says which")), qPrintable(there.complaint));
        QVERIFY(!QFile::exists(path("x.nii.gz")));
    }

    void replayTellsOfLostDifferences()
    {
        QVERIFY(test::runSql(path("a.burin"), key("DELETE FROM delta WHERE row=7")));
        const Outcome verified = replay({key("--verify")});
        QCOMPARE(verified.status, 1);
        QCOMPARE(verified.lines.size(), rows);
        for (const QJsonObject& line : verified.lines)
            QCOMPARE(line[key("agrees")].toBool(), line[key("row")].toInt() != 7);
        QVERIFY(!verified.lines[6][key("problem")].toString().isEmpty());
        // Where it is not asked for, or not needed, it is only told.
        const Outcome before = replay({key("--verify"), key("--to"), key("6")});
        QCOMPARE(before.status, 0);
        QVERIFY2(tells(before, key("what row 7")), qPrintable(before.complaint));
        const Outcome exported = replay({key("--to"), key("7"), key("--export"), path("x.nii.gz")});
        QCOMPARE(exported.status, 0);
        QVERIFY2(tells(exported, key("what row 7")), qPrintable(exported.complaint));
    }

    void appendGoesOnInANewFile_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<int>("left");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("told");
        QTest::newRow("rows behind it stood on")
            << key("UPDATE row SET name='X' WHERE id=8") << 7 << 1
            << key("The 7 rows before it are open in a (recovered).burin");
        QTest::newRow("a row that it did not stand behind")
            << key("UPDATE row SET name='X' WHERE id=13") << 12 << 0
            << key("The 12 rows before it are open in a (recovered).burin");
        QTest::newRow("position") << key("UPDATE state SET value=77 WHERE key='position'") << rows
                                  << 1 << key("All rows are open in a (recovered).burin");
        QTest::newRow("where redo goes")
            << key("UPDATE visited SET child=99 WHERE parent=4") << rows << 0
            << key("All rows are open in a (recovered).burin");
        QTest::newRow("a difference on its way")
            << key("DELETE FROM delta WHERE row=4") << rows << 0 << key("Nothing is lost");
        QTest::newRow("a difference on a branch")
            << key("DELETE FROM delta WHERE row=7") << rows << 0 << key("Nothing is lost");
    }
    void appendGoesOnInANewFile()
    {
        QFETCH(QString, sql);
        QFETCH(int, left);
        QFETCH(int, status);
        QFETCH(QString, told);
        QVERIFY(test::runSql(path("a.burin"), sql));
        const QByteArray before = test::fingerprint(path("a.burin"));
        const Outcome appended = append(test::addSegment("More"));
        QCOMPARE(appended.status, status);
        QVERIFY2(tells(appended, told), qPrintable(appended.complaint));
        QCOMPARE(appended.lines.size(), 1);
        QCOMPARE(test::fingerprint(path("a.burin")), before);
        QCOMPARE(files(), (QStringList{key("a (recovered).burin"), key("a.burin")}));
        const Outcome verified = burin(
            {key("replay"), path("a (recovered).burin"), key("--verify"), key("--study"), m_study});
        QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
        QCOMPARE(verified.lines.size(), left + 1);

        // What cannot be appended leaves no file behind.
        QVERIFY(QFile::remove(path("a (recovered).burin")));
        const Outcome refused = append(test::seedInBrain(9));
        QCOMPARE(refused.status, 1);
        QCOMPARE(files(), QStringList{key("a.burin")});
        QCOMPARE(test::fingerprint(path("a.burin")), before);
    }

    void whatIsCutOffOpensAsFarAsItGoes()
    {
        QFile file(path("a.burin"));
        const qint64 size = file.size();
        const auto cutOff = [&](qint64 left) {
            static_cast<void>(file.resize(left));
            return QStringLiteral("the file is cut off: %1 of %2 bytes are there")
                .arg(left)
                .arg(size);
        };
        // Of the last page only its end is gone.
        const QString little = cutOff(size - 8);
        const Outcome listed = history({key("--json")});
        QVERIFY2(tells(listed, little), qPrintable(listed.complaint));
        QCOMPARE(listed.status, 0);
        QCOMPARE(listing(listed)[key("commands")].toArray().size(), rows);
        const QByteArray before = test::fingerprint(path("a.burin"));
        const Outcome appended = append(test::addSegment("More"));
        QVERIFY2(appended.status == 0 && tells(appended, key("open in a (recovered).burin")),
            qPrintable(appended.complaint));
        QCOMPARE(test::fingerprint(path("a.burin")), before);
        const Outcome verified = burin(
            {key("replay"), path("a (recovered).burin"), key("--verify"), key("--study"), m_study});
        QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
        QCOMPARE(verified.lines.size(), rows + 1);

        const QString much = cutOff(5000);
        for (const Outcome& outcome : {history({}), replay({key("--verify")})}) {
            QCOMPARE(outcome.status, 1);
            QVERIFY2(tells(outcome, much), qPrintable(outcome.complaint));
            QVERIFY(outcome.complaint.contains(path("a.burin")));
        }
    }

    void whereNothingIsSoundNothingOpens()
    {
        QVERIFY(test::runSql(path("a.burin"), key("UPDATE row SET name='X' WHERE id=1")));
        const QByteArray before = test::fingerprint(path("a.burin"));
        for (const Outcome& outcome :
            {history({key("--json")}), replay({key("--verify")}), append(test::addSegment("B"))}) {
            QCOMPARE(outcome.status, 1);
            QVERIFY2(tells(outcome, key("row 1 'X'")), qPrintable(outcome.complaint));
            QVERIFY(outcome.output.isEmpty());
        }
        QCOMPARE(files(), QStringList{key("a.burin")});
        QCOMPARE(test::fingerprint(path("a.burin")), before);
    }
};

BURIN_TEST(DamagedSessionGlTest)

} // namespace damagedSessionGlTest

#include "DamagedSessionGlTest.moc"
