// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

#include <sys/stat.h>

namespace batchCommandGlTest {

using test::burin;
using test::key;
using test::Outcome;

/// `burin batch`: many studies, each as `burin run` does it, and none of them twice.
class BatchCommandGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    QStringList m_several;

    /// A list of the studies, with one that is none where asked for.
    [[nodiscard]] QString list(bool withBroken) const
    {
        QByteArray text = "study,name,segment\n";
        for (qsizetype i = 0; i < m_several.size(); ++i)
            text += m_several[i].toUtf8() + ",s" + QByteArray::number(i) + ",Skull\n";
        if (withBroken)
            text += "missing.nii.gz,broken,Skull\n";
        QFile file(path("studies.csv"));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write the list");
        return file.fileName();
    }
    [[nodiscard]] QString writtenRecipe() const
    {
        QJsonArray edits = test::toJson({test::addSegment("${segment}")});
        for (const QJsonValue& edit : test::toJson({test::seedInBone(1), test::growBone()}))
            edits.append(edit);
        return recipe("batch.json",
            {{key("edits"), edits},
                {key("export"),
                    QJsonArray{QJsonObject{{key("format"), key("nifti")},
                                   {key("file"), key("mask.nii.gz")}},
                        QJsonObject{
                            {key("format"), key("csv")}, {key("file"), key("${name}.csv")}}}}});
    }
    [[nodiscard]] QStringList words(const QString& studies, const QStringList& more = {}) const
    {
        return QStringList{key("batch"), path("batch.json"), key("--studies"), studies,
                   key("--into"), path("out")}
        + more;
    }
    [[nodiscard]] QByteArray recordBytes(const QString& name) const
    {
        QFile file(QDir(path("out")).filePath(name + key("/record.json")));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] QJsonObject record(const QString& name) const
    {
        return QJsonDocument::fromJson(recordBytes(name)).object();
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(prepareStudy());
        for (int i = 0; i < 4; ++i) {
            core::LoadedVolume study = test::smallStudy();
            study.codes[0] = std::uint16_t(study.codes[0] + i); // another study, the same bone
            m_several += otherStudy(qPrintable(QStringLiteral("study%1.nii.gz").arg(i)), study);
            QVERIFY(!m_several.last().isEmpty());
        }
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
        QVERIFY(!writtenRecipe().isEmpty());
    }

    void everyStudyIsDoneOnceAsRunDoesIt()
    {
        const QString studies = list(false);
        const Outcome done = burin(words(studies, {key("--jobs"), key("2")}));
        QVERIFY2(done.status == 0, qPrintable(done.complaint));
        QCOMPARE(done.lines.size(), m_several.size());
        QFile filled(path("out/s1/recipe.json"));
        QVERIFY(filled.open(QIODevice::ReadOnly));
        const QByteArray text = filled.readAll();
        QVERIFY(text.contains("Skull") && text.contains("s1.csv") && !text.contains("${"));
        for (qsizetype i = 0; i < m_several.size(); ++i) {
            const QJsonObject made = record(key("s") + QString::number(i));
            QCOMPARE(made[key("state")].toString(), key("done"));
            QCOMPARE(made[key("starts")].toInt(), 1);
            QCOMPARE(made[key("exports")].toArray().size(), 2);
            QVERIFY(!made[key("renderer")].toString().isEmpty());
            QVERIFY(made[key("source")].isObject());
            // By itself it comes to the same.
            const QString alone = path(qPrintable(QStringLiteral("alone%1.burin").arg(i)));
            const QJsonObject plain{
                {key("edits"), QJsonDocument::fromJson(text).object().value(key("edits"))}};
            const Outcome run = burin({key("run"), recipe("plain.json", plain), key("--study"),
                m_several[i], key("--session"), alone});
            QVERIFY2(run.status == 0, qPrintable(run.complaint));
            QVERIFY(!made[key("stateHash")].toString().isEmpty());
            QCOMPARE(made[key("stateHash")], run.lines.last()[key("hash")]);
        }
        QFile table(path("out/results.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = table.readAll().split('\n');
        QCOMPARE(lines.size(), m_several.size() + 2);
        QVERIFY2(lines.first().contains("Skull volumeMl"), lines.first().constData());

        // A second time nothing is touched.
        const QByteArray before = recordBytes(key("s0"));
        const Outcome again = burin(words(studies));
        QCOMPARE(again.status, 0);
        QCOMPARE(again.lines.first()[key("state")].toString(), key("was done"));
        QCOMPARE(recordBytes(key("s0")), before);
    }

    void aStudyThatFailsDoesNotStopTheOthers()
    {
        const Outcome done = burin(words(list(true), {key("--retries"), key("2")}));
        QCOMPARE(done.status, 1);
        QVERIFY2(done.complaint.contains(key("missing.nii.gz")), qPrintable(done.complaint));
        QCOMPARE(record(key("broken"))[key("state")].toString(), key("failed"));
        // It would fail again.
        QCOMPARE(record(key("broken"))[key("attempts")].toInt(), 1);
        for (qsizetype i = 0; i < m_several.size(); ++i)
            QCOMPARE(record(key("s") + QString::number(i))[key("state")].toString(), key("done"));
    }

    void aBatchThatWasKilledGoesOn()
    {
        const QString studies = list(false);
        QProcess killed;
        killed.start(QStringLiteral(BURIN_PROGRAM), words(studies));
        QVERIFY(killed.waitForStarted());
        // The first is finished, and others are not.
        QElapsedTimer clock;
        clock.start();
        while (record(key("s1"))[key("state")].toString().isEmpty() && clock.elapsed() < 120000)
            QTest::qWait(5);
        killed.kill();
        QVERIFY(killed.waitForFinished(60000));
        QCOMPARE(killed.exitStatus(), QProcess::CrashExit);
        const QByteArray first = recordBytes(key("s0"));
        QCOMPARE(record(key("s0"))[key("state")].toString(), key("done"));

        const Outcome goneOn = burin(words(studies));
        QVERIFY2(goneOn.status == 0, qPrintable(goneOn.complaint));
        QCOMPARE(recordBytes(key("s0")), first);
        int starts = 0;
        for (qsizetype i = 0; i < m_several.size(); ++i) {
            const QJsonObject made = record(key("s") + QString::number(i));
            QCOMPARE(made[key("state")].toString(), key("done"));
            starts += made[key("starts")].toInt();
        }
        QVERIFY(starts <= m_several.size() + 1); // the one at which it was killed
    }

    void whatIsNotABatchsStays()
    {
        QVERIFY(QDir().mkpath(path("out/s0")));
        QFile own(path("out/s0/session.burin"));
        QVERIFY(own.open(QIODevice::WriteOnly) && own.write("mine") == 4);
        own.close();
        const Outcome refused = burin(words(list(false), {key("--only"), key("s0")}));
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.complaint.contains(key("session.burin")), qPrintable(refused.complaint));
        QVERIFY(own.open(QIODevice::ReadOnly));
        QCOMPARE(own.readAll(), QByteArray("mine"));
    }

    /// A pipe would be read for ever.
    void aPipeIsNoFile()
    {
        const QString pipe = path("pipe.csv");
        QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        QStringList ofPipes = words(list(false));
        ofPipes[1] = pipe; // the recipe
        for (const QStringList& each : {words(pipe), ofPipes}) {
            const Outcome refused = burin(each);
            QCOMPARE(refused.status, 1);
            QVERIFY2(refused.complaint.contains(key("pipe.csv")), qPrintable(refused.complaint));
        }
    }

    void listsAreChecked_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("complaint");
        QTest::newRow("no column") << QByteArray("path\na\n") << key("line 1");
        QTest::newRow("cells") << QByteArray("study,name\na\n") << key("line 2: 1 cells");
        QTest::newRow("twice") << QByteArray("study\na.nii\nb/a.nii\n")
                               << key("line 2 has the name");
        QTest::newRow("name") << QByteArray("study,name\na,../b\n") << key("line 2: the name");
        QTest::newRow("quote") << QByteArray("study\n\"a\n") << key("quote");
        QTest::newRow("variable") << QByteArray("study\na\n") << key("no variable 'segment'");
    }
    void listsAreChecked()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, complaint);
        QFile file(path("bad.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        file.close();
        const Outcome refused = burin(words(file.fileName()));
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.complaint.contains(complaint), qPrintable(refused.complaint));
        QVERIFY(!QFile::exists(path("out")));
    }
};

BURIN_TEST(BatchCommandGlTest)

} // namespace batchCommandGlTest

#include "BatchCommandGlTest.moc"
