// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/SessionDatabase.h"

#include "core/sessionfile/database/SessionUse.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <memory>
#include <optional>

namespace sessionDatabaseTest {

using namespace core;

/// The file of a database that another program renames while it is open.
class SessionDatabaseTest : public QObject {
    Q_OBJECT

    std::optional<QTemporaryDir> m_folder;
    std::unique_ptr<SessionDatabase> m_database;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QStringList files() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }
    void rename() const
    {
        if (std::rename(QFile::encodeName(path("a.burin")).constData(),
                QFile::encodeName(path("b.burin")).constData())
            != 0)
            qFatal("cannot rename");
    }
    /// What was written last; empty: it is not there.
    QString written() const
    {
        QString value;
        const auto opened = SessionDatabase::open(path("b.burin"), true);
        if (opened)
            (*opened)->query(QStringLiteral("SELECT value FROM state WHERE key='position'"), {},
                [&value](const QSqlQuery& answer) {
                    value = answer.value(0).toString();
                    return true;
                });
        return value;
    }

private Q_SLOTS:
    void init()
    {
        m_folder.emplace();
        QFile empty(path("a.burin"));
        QVERIFY(empty.open(QIODevice::WriteOnly));
        empty.close();
        auto made = SessionDatabase::create(path("a.burin"), [](SessionDatabase&) { return true; });
        QVERIFY2(made, qPrintable(made ? QString() : made.error().arguments.join(u' ')));
        m_database = *std::move(made);
        QVERIFY(m_database->run(QStringLiteral("INSERT INTO state VALUES ('position', '7')")));
    }
    void cleanup() { m_database.reset(); }

    /// Nobody has told it that the file has another name before it is closed.
    void itIsClosedAsOneFileUnderItsNewName()
    {
        rename();
        m_database.reset();
        QCOMPARE(files(), QStringList{QStringLiteral("b.burin")});
        QCOMPARE(sessionLoss(path("b.burin")).leftOpen.english(), QString());
        QCOMPARE(written(), QStringLiteral("7"));
        QVERIFY(!isSessionInUse(path("b.burin")));
    }

    void nothingOfAnotherSessionIsTouched()
    {
        rename();
        // Under the name of before there is another one by now, and something beside it.
        for (const char* name : {"a.burin", "a.burin-journal"}) {
            QFile other(path(name));
            QVERIFY(other.open(QIODevice::WriteOnly) && other.write("other") == 5);
        }
        m_database.reset();
        QCOMPARE(files(),
            (QStringList{QStringLiteral("a.burin"), QStringLiteral("a.burin-journal"),
                QStringLiteral("b.burin")}));
        QCOMPARE(sessionLoss(path("b.burin")).leftOpen.english(), QString());
        QCOMPARE(written(), QStringLiteral("7"));
    }

    /// It was put into the file, and then that could not be opened under its new name.
    void whatIsWholeIsNotMissed()
    {
        QVERIFY(m_database->gather());
        rename();
        m_database->leaveName(path("b.burin"));
        m_database.reset();
        QVERIFY(!isSessionUnfinished(path("b.burin")));
        QCOMPARE(sessionLoss(path("b.burin")).leftOpen.english(), QString());
        QCOMPARE(written(), QStringLiteral("7"));
        QVERIFY(SessionDatabase::open(path("b.burin"), false));
        QCOMPARE(files(), QStringList{QStringLiteral("b.burin")});
    }
};

BURIN_TEST(SessionDatabaseTest)

} // namespace sessionDatabaseTest

#include "SessionDatabaseTest.moc"
