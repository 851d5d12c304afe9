// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>

namespace runFarStudyGlTest {

using test::burin;
using test::key;
using test::Outcome;

/// A study lies where no session may send anybody by itself, and the user names it.
class RunFarStudyGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    /// What needs the study's values once more finds them again.
    void exportsReadTheStudyThatWasNamed()
    {
        const QString shared = key("/dev/shm");
        if (!QFileInfo(shared).isWritable())
            QSKIP("/dev/shm cannot be written here");
        const QTemporaryDir folder(shared + key("/burin-test-XXXXXX"));
        QVERIFY(folder.isValid());
        const QString study = folder.filePath(key("small.nii.gz"));
        QVERIFY(test::writeStudy(study, test::smallStudy()));
        const QJsonArray exports{
            QJsonObject{{key("format"), key("csv")}, {key("file"), path("numbers.csv")}},
            QJsonObject{{key("format"), key("carved-volume")}, {key("file"), path("left.nii.gz")}}};
        const QJsonArray edits = test::toJson({test::addSegment("Brain"),
            test::paintAt(1, test::pointsInBrain()), test::carveAt(test::pointsInBone())});
        const QStringList words{key("run"),
            recipe("recipe.json", {{key("edits"), edits}, {key("export"), exports}}),
            key("--study"), study, key("--session"), path("s.burin")};
        const Outcome done = burin(words);
        QVERIFY2(done.status == 0, qPrintable(done.complaint));
        QFile numbers(path("numbers.csv"));
        QVERIFY(numbers.open(QIODevice::ReadOnly));
        QVERIFY(numbers.readAll().contains("Brain"));
        QVERIFY(QFileInfo(path("left.nii.gz")).size() > 0);
    }
};

BURIN_TEST(RunFarStudyGlTest)

} // namespace runFarStudyGlTest

#include "RunFarStudyGlTest.moc"
