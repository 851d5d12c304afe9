// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionPlan.h"

#include "app/steps/SessionFiles.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

namespace sessionPlanTest {

using core::ErrorCode;
using core::Result;

/// What is told of a damaged session before its sound part goes on, and how that is taken back.
class SessionPlanTest : public QObject {
    Q_OBJECT

    std::optional<QTemporaryDir> m_folder;
    QTemporaryDir m_pattern; ///< holds the session that tests copy

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    [[nodiscard]] QStringList files() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden);
    }
    [[nodiscard]] static Result<app::SessionPlan> planFor(const QString& file, bool redo = true)
    {
        const Result<core::SessionContents> contents = core::checkSession(file);
        if (!contents)
            return tl::unexpected(contents.error());
        return app::planFor(file, *contents, redo);
    }
    /// A working session whose row 7 lacks its difference.
    [[nodiscard]] QString damagedWorkingSession() const
    {
        const QString file = QDir(app::sessionFolder()).filePath(QStringLiteral("w.burin"));
        if (!QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), file)
            || !test::runSql(file, QStringLiteral("DELETE FROM delta WHERE row=7")))
            qFatal("no working session");
        return file;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(!test::makeSession(m_pattern.filePath(QStringLiteral("a.burin"))).isEmpty());
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder.emplace();
        QVERIFY(qputenv("XDG_STATE_HOME", QFile::encodeName(path("state"))));
        QVERIFY(QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), path("a.burin")));
    }

    void whatIsTold_data()
    {
        QTest::addColumn<QStringList>("sql");
        QTest::addColumn<QString>("told");
        const QString kept =
            QStringLiteral("a (recovered).burin; the damaged file keeps its bytes");
        const auto row = [](const char* name, const QStringList& sql, const QString& told) {
            QTest::newRow(name) << sql << told;
        };
        row("nothing", {}, {});
        row("a row", {QStringLiteral("UPDATE row SET name='X' WHERE id=5")},
            QStringLiteral(
                "row 5 'X' and the 8 after it cannot be read: it was changed after it was "
                "written. The 4 rows before it are open in ")
                + kept);
        row("the last row", {QStringLiteral("UPDATE row SET name='X' WHERE id=13")},
            QStringLiteral("row 13 'X' cannot be read: it was changed after it was written. The 12 "
                           "rows before it are open in ")
                + kept);
        row("all but one", {QStringLiteral("UPDATE row SET name='X' WHERE id=2")},
            QStringLiteral("row 2 'X' and the 11 after it cannot be read: it was changed after it "
                           "was written. The row before it is open in ")
                + kept);
        row("the position", {QStringLiteral("UPDATE state SET value=99 WHERE key='position'")},
            QStringLiteral(
                "where it stood cannot be read: its position is no row. All rows are open "
                "in ")
                + kept);
        row("a difference", {QStringLiteral("DELETE FROM delta WHERE row=7")},
            QStringLiteral("what row 7 'Grow 'Brain' 15 steps, +3 619 voxels' changed could not be "
                           "read; it was "
                           "carried out again and came to the same. Nothing is lost; everything is "
                           "open in ")
                + kept);
        row("three differences",
            {QStringLiteral("DELETE FROM delta WHERE row=4 OR row=7 OR row=8")},
            QStringLiteral("(and 2 more) changed could not be read; it was carried out again and "
                           "came to the same. Nothing is lost; everything is open in ")
                + kept);
    }
    void whatIsTold()
    {
        QFETCH(const QStringList, sql);
        QFETCH(const QString, told);
        for (const QString& statement : sql)
            QVERIFY(test::runSql(path("a.burin"), statement));
        const QByteArray before = test::fingerprint(path("a.burin"));
        const Result<app::SessionPlan> plan = planFor(path("a.burin"));
        QVERIFY(plan);
        QCOMPARE(plan->damage.has_value(), !told.isEmpty());
        QCOMPARE(plan->isNew, !told.isEmpty());
        QCOMPARE(plan->file, path(told.isEmpty() ? "a.burin" : "a (recovered).burin"));
        QCOMPARE(test::fingerprint(path("a.burin")), before);
        if (told.isEmpty())
            return;
        QCOMPARE(plan->damage->code, ErrorCode::SessionDamaged);
        QCOMPARE(plan->damage->arguments.value(0), path("a.burin"));
        const QString words = plan->damage->arguments.value(1);
        QVERIFY2(words.endsWith(told), qPrintable(words));
        // What is made for it is taken back, and nothing else.
        QVERIFY(app::withdraw(*plan, path("a.burin")));
        QCOMPARE(files(), QStringList{QStringLiteral("a.burin")});
        QCOMPARE(test::fingerprint(path("a.burin")), before);
    }

    void aDamagedWorkingSessionGetsItsNameBack()
    {
        const QString file = damagedWorkingSession();
        const QByteArray before = test::fingerprint(file);
        const Result<app::SessionPlan> plan = planFor(file);
        QVERIFY(plan);
        QCOMPARE(plan->file, file);
        QVERIFY(plan->damaged != file && !plan->isNew);
        QCOMPARE(test::fingerprint(plan->damaged), before);
        QVERIFY(test::fingerprint(file) != before);
        QVERIFY(app::withdraw(*plan, file));
        QCOMPARE(test::fingerprint(file), before);
        QCOMPARE(QDir(app::sessionFolder()).entryList(QDir::Files | QDir::Hidden),
            QStringList{QStringLiteral("w.burin")});
    }

    /// It is told where it lies, and stays there.
    void aNameThatIsNotGivenBackIsTold()
    {
        const QString file = damagedWorkingSession();
        const QByteArray before = test::fingerprint(file);
        const Result<app::SessionPlan> plan = planFor(file);
        QVERIFY(plan);
        QVERIFY(QFile::remove(file));
        QVERIFY(QDir().mkpath(file + QStringLiteral("/something")));
        const Result<void> withdrawn = app::withdraw(*plan, file);
        QVERIFY(!withdrawn);
        QCOMPARE(withdrawn.error().code, ErrorCode::FileUnwritable);
        QCOMPARE(withdrawn.error().arguments.value(0), plan->damaged);
        QVERIFY2(withdrawn.error().arguments.value(1).startsWith(
                     QStringLiteral("it cannot be renamed to 'w.burin': ")),
            qPrintable(withdrawn.error().arguments.value(1)));
        QCOMPARE(test::fingerprint(plan->damaged), before);
    }

    void whatLiesBesideItGoesAlongOrNothingDoes()
    {
        const auto write = [this](const char* name) {
            QFile file(path(name));
            return file.open(QIODevice::WriteOnly) && file.write("any") == 3;
        };
        for (const char* name : {"a.burin-wal", "a.burin-shm", "c.burin-wal", "d.burin-journal"})
            QVERIFY(write(name));
        QVERIFY(app::renameSession(path("a.burin"), path("b.burin")));
        const QStringList renamed{QStringLiteral("b.burin"), QStringLiteral("b.burin-shm"),
            QStringLiteral("b.burin-wal"), QStringLiteral("c.burin-wal"),
            QStringLiteral("d.burin-journal")};
        QCOMPARE(files(), renamed);
        // Nor does it come to lie beside what belongs to another one.
        for (const char* name : {"c.burin", "d.burin"}) {
            const Result<void> refused = app::renameSession(path("b.burin"), path(name));
            QVERIFY2(!refused, name);
            QCOMPARE(refused.error().code, ErrorCode::FileUnwritable);
            QCOMPARE(files(), renamed);
        }
    }

    /// What goes on of a damaged session does not take over what another one has left.
    void aNameWithSomethingBesideItIsNotTaken()
    {
        QVERIFY(
            test::runSql(path("a.burin"), QStringLiteral("UPDATE row SET name='X' WHERE id=5")));
        QFile stray(path("a (recovered).burin-wal"));
        QVERIFY(stray.open(QIODevice::WriteOnly) && stray.write("somebody's") == 10);
        stray.close();
        const Result<app::SessionPlan> plan = planFor(path("a.burin"));
        QVERIFY(plan);
        QCOMPARE(plan->file, path("a (recovered 2).burin"));
        QCOMPARE(stray.size(), qint64(10));
    }
};

BURIN_TEST(SessionPlanTest)

} // namespace sessionPlanTest

#include "SessionPlanTest.moc"
