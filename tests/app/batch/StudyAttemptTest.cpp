// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyAttempt.h"
#include "app/batch/RecipeTemplate.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SessionFiles.h"

#include <QFile>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace studyAttemptTest {

using app::StudyAttempt;

/// What an attempt at a study has left of a session, and what gets its name.
class StudyAttemptTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void aSessionThatWasLeftOpenIsClosed();
    void theSegOfAReportIsLookedAtBefore();
};

/// Its run could write everything but that it is closed; nothing lies beside it.
void StudyAttemptTest::aSessionThatWasLeftOpenIsClosed()
{
    const auto name = QStringLiteral("session.burin");
    StudyAttempt attempt(m_folder.path(), name, "{}", {});
    QVERIFY(attempt.begin());
    const QString staged = attempt.sessionPath();
    QVERIFY(!test::makeSession(staged).isEmpty());
    const auto sound = core::checkSession(staged);
    QVERIFY(sound && !sound->rows.empty());
    QFile file(staged);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.seek(18) && file.write("\2\2", 2) == 2); // it says that it is in WAL mode
    file.close();
    QVERIFY(!core::sessionLoss(staged).leftOpen.isEmpty());
    QCOMPARE(core::strayPartOf(staged), QString());

    QVERIFY(attempt.survey());
    QVERIFY(attempt.place());
    const QString placed = m_folder.filePath(name);
    QVERIFY(QFile::exists(placed));
    QVERIFY(core::sessionLoss(placed).leftOpen.isEmpty());
    const auto closed = core::checkSession(placed);
    QVERIFY(closed && closed->isWhole() && closed->leftOpen.isEmpty());
    QCOMPARE(closed->rows.size(), sound->rows.size());
    QCOMPARE(closed->rows.back().stateHash, sound->rows.back().stateHash);
    QJsonObject record;
    attempt.concludeIn(record);
    QCOMPARE(record.value(QStringLiteral("sessionSha256")).toString().toLatin1(),
        test::fingerprint(placed));
}

/// What a report brings along takes nobody's name either, and that is known before any work.
void StudyAttemptTest::theSegOfAReportIsLookedAtBefore()
{
    const QTemporaryDir folder;
    const QByteArray recipe = R"({"edits": [], "export": [{"format": "sr", "file": "a.dcm"}]})";
    const auto session = QStringLiteral("session.burin");
    QVERIFY(StudyAttempt(folder.path(), session, recipe, {}).check());
    QFile other(folder.filePath(QStringLiteral("a-seg.dcm")));
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("mine") == 4);
    other.close();
    const core::Result<void> checked = StudyAttempt(folder.path(), session, recipe, {}).check();
    QVERIFY(!checked);
    QVERIFY2(checked.error().arguments.value(0).endsWith(QStringLiteral("a-seg.dcm")),
        qPrintable(checked.error().arguments.value(0)));
    QCOMPARE(app::RecipeTemplate::exportsOf(recipe, QStringLiteral("/out")),
        (QStringList{QStringLiteral("/out/a.dcm"), QStringLiteral("/out/a-seg.dcm")}));
}

BURIN_TEST(StudyAttemptTest)

} // namespace studyAttemptTest

#include "StudyAttemptTest.moc"
