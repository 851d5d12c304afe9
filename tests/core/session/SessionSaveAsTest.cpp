// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/SessionDisplay.h"
#include "core/session/SessionKeyframes.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/database/SessionUse.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <future>

namespace sessionSaveAsTest {

using namespace core;

namespace {

Result<void> saveAs(EditSession& session, const QString& target, bool replaceExisting = false)
{
    std::promise<Result<void>> promise;
    session.storage().saveAs(target, replaceExisting,
        [&promise](const Result<void>& result) { promise.set_value(result); });
    return promise.get_future().get();
}

} // namespace

/// A session goes on in a copy; and sessions that are only looked at.
class SessionSaveAsTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    QString m_target;
    QTemporaryDir m_pattern; ///< holds the session that tests copy
    std::size_t m_rows = 0; ///< of that

    QStringList filesIn() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden);
    }
    std::unique_ptr<EditSession> open(reference::ReferenceEngine& engine, const QString& path) const
    {
        auto session = EditSession::open(engine, test::smallStudy(), path);
        if (!session)
            qFatal("%s", qPrintable(session.error().arguments.join(u' ')));
        session->get()->setErrorListener([](const Error&) {});
        return *std::move(session);
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString path = m_pattern.filePath(QStringLiteral("a.burin"));
        QVERIFY(!test::makeSession(path).isEmpty());
        m_rows = (*SessionFile::open(path, SessionFile::Access::ReadOnly))->contents().rows.size();
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("a.burin"));
        m_target = m_folder->filePath(QStringLiteral("b.burin"));
        QVERIFY(QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), m_path));
    }

    void goesOnInTheCopy()
    {
        reference::ReferenceEngine engine;
        QByteArray afterSaving;
        {
            const auto session = open(engine, m_path);
            QVERIFY(session->apply(test::drillAt(3)));
            QVERIFY(saveAs(*session, m_target)); // with the row still on its way
            QCOMPARE(session->file(), m_target);
            QVERIFY(!isSessionInUse(m_path));
            QVERIFY(isSessionInUse(m_target));
            QVERIFY(session->apply(test::drillAt(5)));
            QVERIFY(session->settle());
            afterSaving = session->stateHash();
            // What lies in the copy only comes from there.
            QVERIFY(session->goTo(2));
            QVERIFY(session->goTo(RowId(m_rows + 2)));
            QVERIFY(session->settle());
            QCOMPARE(session->stateHash(), afterSaving);
        }
        QCOMPARE(filesIn(), (QStringList{QStringLiteral("a.burin"), QStringLiteral("b.burin")}));
        QCOMPARE(QFile::permissions(m_target)
                & (QFileDevice::ReadGroup | QFileDevice::ReadOther | QFileDevice::WriteGroup
                    | QFileDevice::WriteOther),
            QFileDevice::Permissions());
        const auto before = open(engine, m_path);
        QVERIFY(before->history().rows().size() - m_rows <= 1);
        reference::ReferenceEngine other;
        const auto after = open(other, m_target);
        QCOMPARE(after->history().rows().size(), m_rows + 2);
        QCOMPARE(after->stateHash(), afterSaving);
        QVERIFY(!after->document().segment(2)->visible);
    }

    void otherSessionsAreReplacedOnlyWhenTold()
    {
        reference::ReferenceEngine engine;
        const auto session = open(engine, m_path);
        QVERIFY(QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), m_target));
        const QByteArray before = test::fingerprint(m_target);
        QCOMPARE(saveAs(*session, m_target).error().code, ErrorCode::FileExists);
        QCOMPARE(test::fingerprint(m_target), before);
        QCOMPARE(session->file(), m_path);
        QVERIFY(saveAs(*session, m_target, true));
        QCOMPARE(session->file(), m_target);
    }

    void whatIsNoSessionIsNeverReplaced_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("a text") << QByteArray("mine");
        QTest::newRow("a database of another program")
            << QByteArray("SQLite format 3").leftJustified(512, '\0');
        QTest::newRow("an empty file") << QByteArray();
    }

    /// A study, a slice, a recipe: whoever confirms in the file dialog that a file is replaced may
    /// have picked the wrong one.
    void whatIsNoSessionIsNeverReplaced()
    {
        QFETCH(QByteArray, content);
        reference::ReferenceEngine engine;
        const auto session = open(engine, m_path);
        QFile other(m_target);
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.write(content);
        other.close();
        const QStringList files = filesIn();
        QCOMPARE(saveAs(*session, m_target).error().code, ErrorCode::FileExists);
        const Result<void> saved = saveAs(*session, m_target, true);
        QVERIFY(!saved);
        QCOMPARE(saved.error().code, ErrorCode::FileUnwritable);
        QCOMPARE(saved.error().arguments.value(0), m_target);
        QVERIFY(saved.error().arguments.value(1).startsWith(QStringLiteral("it is no session")));
        QCOMPARE(filesIn(), files);
        QVERIFY(other.open(QIODevice::ReadOnly));
        QCOMPARE(other.readAll(), content);
        QCOMPARE(session->file(), m_path);
        QVERIFY(session->apply(test::drillAt(3)));
        QVERIFY(session->settle());
    }

    /// Saved over itself: the file is made anew, and goes on.
    void itsOwnFileMayBeReplaced()
    {
        reference::ReferenceEngine engine;
        {
            const auto session = open(engine, m_path);
            QVERIFY(session->apply(test::drillAt(3)));
            QCOMPARE(saveAs(*session, m_path).error().code, ErrorCode::FileExists);
            QVERIFY(saveAs(*session, m_path, true));
            QCOMPARE(session->file(), m_path);
            QVERIFY(isSessionInUse(m_path));
            QVERIFY(session->apply(test::drillAt(5)));
            QVERIFY(session->settle());
            {
                const test::FileSizeLimit limit(20000);
                QCOMPARE(saveAs(*session, m_path, true).error().code, ErrorCode::FileUnwritable);
            }
            QVERIFY(session->apply(test::drillAt(7)));
            QVERIFY(session->settle());
        }
        QCOMPARE(filesIn(), QStringList{QStringLiteral("a.burin")});
        const auto after = open(engine, m_path);
        QCOMPARE(after->history().rows().size(), m_rows + 3);
        QCOMPARE(after->stateHash(), after->history().rows().back().stateHash);
    }

    void aSessionOfAnotherWindowIsNotReplaced()
    {
        reference::ReferenceEngine engine;
        const auto session = open(engine, m_path);
        QVERIFY(QFile::copy(m_pattern.filePath(QStringLiteral("a.burin")), m_target));
        const QByteArray before = test::fingerprint(m_target);
        {
            const test::OtherWindow window(m_target);
            const Result<void> saved = saveAs(*session, m_target, true);
            QCOMPARE(saved.error().code, ErrorCode::FileUnwritable);
            QVERIFY(saved.error().arguments.value(1).contains(QStringLiteral("another window")));
        }
        // Nor one whose last steps still lie beside it.
        QFile beside(m_target + QStringLiteral("-wal"));
        QVERIFY(beside.open(QIODevice::WriteOnly));
        beside.write("steps");
        beside.close();
        QCOMPARE(saveAs(*session, m_target, true).error().code, ErrorCode::FileUnwritable);
        QCOMPARE(test::fingerprint(m_target), before);
        QCOMPARE(session->file(), m_path);
    }

    void aFullDiskChangesNothing()
    {
        reference::ReferenceEngine engine;
        const auto session = open(engine, m_path);
        const QStringList files = filesIn();
        {
            const test::FileSizeLimit limit(20000);
            const Result<void> saved = saveAs(*session, m_target);
            QVERIFY(!saved);
            QCOMPARE(saved.error().code, ErrorCode::FileUnwritable);
            QCOMPARE(saved.error().arguments.value(0), m_target);
        }
        QCOMPARE(filesIn(), files);
        QCOMPARE(session->file(), m_path);
        const Result<void> nowhere =
            saveAs(*session, m_folder->filePath(QStringLiteral("no/such/b.burin")));
        QCOMPARE(nowhere.error().code, ErrorCode::FileUnwritable);
        QVERIFY(session->apply(test::drillAt(3)));
        QVERIFY(session->settle());
        QCOMPARE(session->stateHash(), session->history().rows().back().stateHash);
    }

    /// Steps that the session's own disk has no room for are saved with it to another place.
    void stepsThatWaitAreSavedToo()
    {
        reference::ReferenceEngine engine;
        QByteArray hash;
        {
            const auto session = open(engine, m_path);
            // What is written is written anew, beside the file, until it is closed.
            const QString beside = m_path + QStringLiteral("-wal");
            for (int i = 0; QFileInfo(beside).size() < 2 * QFileInfo(m_path).size(); ++i) {
                session->display().setSegmentVisible(1, i % 2 == 1);
                QVERIFY(session->settle());
            }
            const test::FileSizeLimit limit(rlim_t(QFileInfo(beside).size()));
            QVERIFY(session->apply(test::drillAt(3)));
            QVERIFY(!session->settle());
            QVERIFY(session->storage().trouble());
            hash = session->stateHash();
            const Result<void> saved = saveAs(*session, m_target);
            QVERIFY2(saved, qPrintable(saved ? QString() : saved.error().arguments.join(u' ')));
            QVERIFY(!session->storage().trouble());
            QVERIFY(session->settle());
        }
        reference::ReferenceEngine other;
        const auto after = open(other, m_target);
        QCOMPARE(after->history().rows().size(), m_rows + 1);
        QCOMPARE(after->stateHash(), hash);
    }

    /// Where no file can be made work begins all the same, and nothing of it is lost.
    void withoutAFileEverythingWaits()
    {
        const QString nowhere = m_folder->filePath(QStringLiteral("no/such/a.burin"));
        reference::ReferenceEngine engine;
        QByteArray hash;
        {
            const auto session = *EditSession::create(
                engine, test::smallStudy(), {.file = nowhere, .beginWithoutFile = true});
            std::vector<Error> told;
            session->setErrorListener([&told](const Error& error) { told.push_back(error); });
            QVERIFY(session->storage().whyNoFile());
            QCOMPARE(session->storage().whyNoFile()->code, ErrorCode::FileUnwritable);
            QCOMPARE(session->file(), nowhere);
            // How it looks is nothing to lose.
            session->display().keep({{QStringLiteral("tool"), QStringLiteral("drill")}});
            QVERIFY(session->settle());
            QVERIFY(!session->storage().trouble());
            for (const Edit& edit : test::manyEdits()) {
                QVERIFY(session->apply(edit));
                QCOMPARE(session->settle().error().code, ErrorCode::FileUnwritable);
            }
            QVERIFY(session->storage().trouble());
            session->keyframes().add(2, QByteArrayLiteral("picture"));
            std::promise<QByteArray> png;
            session->keyframes().fetch(2, [&png](const QByteArray& got) { png.set_value(got); });
            QCOMPARE(png.get_future().get(), QByteArrayLiteral("picture"));
            session->storage().setStepMemory(0);
            hash = session->stateHash();
            QVERIFY(session->goTo(0));
            static_cast<void>(session->settle());
            QCOMPARE(session->history().position(), RowId(0));
            QVERIFY(session->goTo(RowId(test::manyEdits().size())));
            static_cast<void>(session->settle());
            QCOMPARE(session->stateHash(), hash);

            const Result<void> refused =
                saveAs(*session, m_folder->filePath(QStringLiteral("nor/such/b.burin")));
            QCOMPARE(refused.error().code, ErrorCode::FileUnwritable);
            QVERIFY(session->storage().whyNoFile());
            QVERIFY(saveAs(*session, m_target));
            QVERIFY(!session->storage().whyNoFile());
            QVERIFY(!session->storage().trouble());
            QCOMPARE(session->file(), m_target);
            QVERIFY(session->apply(test::drillAt(7)));
            QVERIFY(session->settle());
            hash = session->stateHash();
            QVERIFY(told.empty());
        }
        reference::ReferenceEngine other;
        const auto after = open(other, m_target);
        QCOMPARE(after->history().rows().size(), test::manyEdits().size() + 1);
        QCOMPARE(after->stateHash(), hash);
        QCOMPARE(after->keyframes().rows(), std::vector<RowId>{2});
        QCOMPARE(after->display().kept().value(QStringLiteral("tool")).toString(),
            QStringLiteral("drill"));
    }

    void aViewRefusesEditsAndLeavesTheFile_data()
    {
        QTest::addColumn<bool>("unfinished");
        QTest::newRow("closed") << false;
        QTest::newRow("in use, with steps beside it") << true;
    }
    void aViewRefusesEditsAndLeavesTheFile()
    {
        QFETCH(bool, unfinished);
        std::size_t rows = m_rows;
        if (unfinished) {
            // As another window leaves it while it works: its last steps lie beside.
            reference::ReferenceEngine engine;
            const auto session = open(engine, m_path);
            QVERIFY(session->apply(test::drillAt(3)));
            QVERIFY(session->settle());
            for (const char* suffix : {"", "-wal"})
                QVERIFY(
                    QFile::copy(m_path + QLatin1String(suffix), m_target + QLatin1String(suffix)));
            ++rows;
        } else {
            QVERIFY(QFile::copy(m_path, m_target));
        }
        const QByteArray before = test::fingerprint(m_target);
        const QStringList files = filesIn();
        const test::OtherWindow window(m_target);
        QVERIFY(isSessionInUse(m_target));
        reference::ReferenceEngine engine;
        QCOMPARE(EditSession::open(engine, test::smallStudy(), m_target).error().code,
            ErrorCode::FileUnreadable);
        const auto viewed = EditSession::view(
            engine, test::smallStudy(), m_target, QStringLiteral("open in another window"));
        QVERIFY2(viewed, qPrintable(viewed ? QString() : viewed.error().arguments.join(u' ')));
        EditSession& session = **viewed;
        QCOMPARE(session.file(), m_target);
        QCOMPARE(session.whyReadOnly(), QStringLiteral("open in another window"));
        QCOMPARE(session.history().rows().size(), rows);
        QCOMPARE(session.apply(test::drillAt(0)).error().code, ErrorCode::SessionReadOnly);
        const Edit stroke = test::begunStroke(test::drillAt(0));
        QCOMPARE(session.begin(stroke).error().code, ErrorCode::SessionReadOnly);
        QCOMPARE(session.begin(stroke).error().arguments,
            (QStringList{m_target, QStringLiteral("open in another window")}));
        for (const RowId row : {RowId(0), RowId(10), RowId(12)}) {
            QVERIFY(session.goTo(row));
            QVERIFY(session.settle());
            QCOMPARE(session.history().position(), row);
        }
        session.display().setSegmentVisible(1, false);
        QVERIFY(session.settle());
        QCOMPARE(session.history().rows().size(), rows);
        QCOMPARE(test::fingerprint(m_target), before);
        QCOMPARE(filesIn(), files);

        const QString own = m_folder->filePath(QStringLiteral("own.burin"));
        QVERIFY(saveAs(session, own));
        QVERIFY(session.whyReadOnly().isEmpty());
        QVERIFY(session.apply(test::drillAt(-4)));
        QVERIFY(session.settle());
        QCOMPARE(session.history().rows().size(), rows + 1);
        QCOMPARE(test::fingerprint(m_target), before);
        const auto file = SessionFile::open(m_target, SessionFile::Access::ReadOnly);
        QCOMPARE((*file)->contents().rows.size(), rows);
    }
};

BURIN_TEST(SessionSaveAsTest)

} // namespace sessionSaveAsTest

#include "SessionSaveAsTest.moc"
