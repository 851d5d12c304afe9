// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QTest>

namespace batchOtherGlTest {

using test::burin;
using test::key;
using test::Outcome;

/// What is finished counts only for the very batch that asks for it: the same study, series, repair
/// and options. Each study of the list is the folder with two series.
class BatchOtherGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    QTemporaryDir m_series;

    static void write(const QString& file, const QByteArray& text);
    [[nodiscard]] QJsonObject record() const;
    void writeRecord(const QJsonObject& record) const;
    /// Runs the batch on this series of the study.
    [[nodiscard]] Outcome batch(const char* series, const QStringList& more = {}) const;
    [[nodiscard]] static QString state(const Outcome& outcome);

private Q_SLOTS:
    void initTestCase();
    void init();
    void anotherSeriesIsDoneOnlyByForce();
    void otherOptionsLikewise();
    void whatWasDoneStaysUntilItIsDoneAnew();
    void resultsAmongTheStudiesAreNone();
    void theTableReplacesNothingElse();
};

void BatchOtherGlTest::write(const QString& file, const QByteArray& text)
{
    QFile written(file);
    if (!written.open(QIODevice::WriteOnly) || written.write(text) != text.size())
        qFatal("cannot write %s", qPrintable(file));
}

QJsonObject BatchOtherGlTest::record() const
{
    QFile file(path("out/one/record.json"));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                          : QJsonObject();
}

void BatchOtherGlTest::writeRecord(const QJsonObject& record) const
{
    write(path("out/one/record.json"), QJsonDocument(record).toJson());
}

Outcome BatchOtherGlTest::batch(const char* series, const QStringList& more) const
{
    write(path("studies.csv"),
        "study,name,series\n" + m_series.path().toUtf8() + ",one," + QByteArray(series) + '\n');
    return burin(QStringList{key("batch"), path("batch.json"), key("--studies"),
                     path("studies.csv"), key("--into"), path("out")}
        + more);
}

QString BatchOtherGlTest::state(const Outcome& outcome)
{
    return outcome.lines.isEmpty() ? QString() : outcome.lines.last()[key("state")].toString();
}

void BatchOtherGlTest::initTestCase()
{
    for (const char* uid : {"2.25.11", "2.25.12"}) {
        test::SyntheticSeries series;
        series.seriesUid = key(uid);
        QCOMPARE(test::writeSeries(series, m_series.filePath(key(uid))).size(), series.size.z);
    }
}

void BatchOtherGlTest::init()
{
    test::failOnUnexpectedMessages();
    makeFolder();
    const QString made = recipe("batch.json",
        {{key("edits"),
             test::toJson({test::addSegment("Part"), test::paintAt(1, {{4, 4, 55}}, 3.0)})},
            {key("export"),
                QJsonArray{
                    QJsonObject{{key("format"), key("csv")}, {key("file"), key("part.csv")}}}}});
    QVERIFY(!made.isEmpty());
}

void BatchOtherGlTest::anotherSeriesIsDoneOnlyByForce()
{
    const auto seriesDone = [this] { return record()[key("source")][key("seriesUid")].toString(); };
    const Outcome done = batch("2.25.11");
    QVERIFY2(done.status == 0, qPrintable(done.complaint));
    QCOMPARE(state(done), key("done"));
    QCOMPARE(seriesDone(), key("2.25.11"));
    QCOMPARE(state(batch("2.25.11")), key("was done"));

    const Outcome refused = batch("2.25.12");
    QCOMPARE(refused.status, 1);
    // As results.csv calls it.
    QCOMPARE(state(refused), key("other"));
    QVERIFY2(refused.complaint.contains(key("another series (2.25.11)"))
            && refused.complaint.contains(key("--force")),
        qPrintable(refused.complaint));
    QCOMPARE(seriesDone(), key("2.25.11"));

    const Outcome forced = batch("2.25.12", {key("--force")});
    QVERIFY2(forced.status == 0, qPrintable(forced.complaint));
    QCOMPARE(state(forced), key("done"));
    QCOMPARE(seriesDone(), key("2.25.12"));
    QCOMPARE(record()[key("series")].toString(), key("2.25.12"));

    // What the record of an older batch does not tell is no reason to refuse.
    QJsonObject older = record();
    for (const char* each : {"series", "repair", "spacing"})
        older.remove(key(each));
    writeRecord(older);
    QCOMPARE(state(batch("2.25.12")), key("was done"));
}

void BatchOtherGlTest::otherOptionsLikewise()
{
    QVERIFY(batch("2.25.11").status == 0);
    const QStringList options{key("--with-images")};
    const Outcome refused = batch("2.25.11", options);
    QCOMPARE(refused.status, 1);
    QVERIFY2(
        refused.complaint.contains(key("other options (none)")), qPrintable(refused.complaint));
    const Outcome forced = batch("2.25.11", options + QStringList{key("--force")});
    QVERIFY2(forced.status == 0, qPrintable(forced.complaint));
    QCOMPARE(state(forced), key("done"));
    // Who it is that asks makes no other results.
    QCOMPARE(state(batch("2.25.11", options + QStringList{key("--author"), key("Somebody")})),
        key("was done"));
    const Outcome back = batch("2.25.11");
    QCOMPARE(back.status, 1);
    QVERIFY2(
        back.complaint.contains(key("other options (--with-images)")), qPrintable(back.complaint));
}

/// A recipe that fails leaves what another one made, however often it is tried.
void BatchOtherGlTest::whatWasDoneStaysUntilItIsDoneAnew()
{
    const auto ask = [this](const QJsonArray& edits) {
        const QJsonArray exports{
            QJsonObject{{key("format"), key("csv")}, {key("file"), key("part.csv")}}};
        static_cast<void>(recipe("batch.json", {{key("edits"), edits}, {key("export"), exports}}));
    };
    QVERIFY(batch("2.25.11").status == 0);
    const QString session = path("out/one/") + record()[key("session")].toString();
    const QByteArray steps = test::bytesOf(session);
    const QByteArray numbers = test::bytesOf(path("out/one/part.csv"));
    QVERIFY(!steps.isEmpty() && !numbers.isEmpty());
    // It fails at its second edit.
    QJsonArray failing = test::toJson({test::addSegment("Other")});
    failing.append(QJsonObject{{key("edit"), key("revert")}, {key("rows"), QJsonArray{99}}});
    ask(failing);
    for (const QStringList& more : {QStringList{key("--force")}, QStringList()}) {
        const Outcome failed = batch("2.25.11", more);
        QCOMPARE(failed.status, 1);
        QCOMPARE(record()[key("state")].toString(), key("failed"));
        QVERIFY2(failed.complaint.contains(key("what was done before stays as it is")),
            qPrintable(failed.complaint));
        QVERIFY(test::bytesOf(session) == steps);
        QCOMPARE(test::bytesOf(path("out/one/part.csv")), numbers);
    }
    ask(test::toJson({test::addSegment("Other"), test::paintAt(1, {{4, 4, 55}}, 5.0)}));
    const Outcome done = batch("2.25.11");
    QVERIFY2(done.status == 0, qPrintable(done.complaint));
    QCOMPARE(record()[key("state")].toString(), key("done"));
    QVERIFY(test::bytesOf(session) != steps);
    QVERIFY(test::bytesOf(path("out/one/part.csv")) != numbers);
    QVERIFY(!record().contains(key("keepsResults")) && !record().contains(key("made")));

    // What a study that was never done has finished when it fails is there.
    QVERIFY(QDir(path("out")).removeRecursively());
    ask(failing);
    QCOMPARE(batch("2.25.11").status, 1);
    QVERIFY(QFile::exists(session));
}

void BatchOtherGlTest::resultsAmongTheStudiesAreNone()
{
    QVERIFY(QDir().mkpath(path("studies")));
    for (const char* each : {"studies/a.nii.gz", "studies/b.nii.gz"}) {
        core::LoadedVolume study = test::smallStudy();
        study.codes[0] = std::uint16_t(study.codes[0] + each[8]); // another study each
        QVERIFY(test::writeStudy(path(each), study));
    }
    write(path("studies/a.json"), "{}");
    const QStringList words{key("batch"),
        recipe("plain.json", {{key("edits"), test::toJson({test::addSegment("Part")})}}),
        key("--studies"), path("studies"), key("--into"), path("studies/out")};
    for (const char* expected : {"done", "was done"}) {
        const Outcome outcome = burin(words);
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QVERIFY2(outcome.complaint.contains(key("taken for no studies: a.json")),
            qPrintable(outcome.complaint));
        QCOMPARE(outcome.lines.size(), 2);
        for (const QJsonObject& line : outcome.lines)
            QCOMPARE(line[key("state")].toString(), key(expected));
    }
}

/// Neither what somebody has called so, nor the list of studies itself.
void BatchOtherGlTest::theTableReplacesNothingElse()
{
    const QString table = path("out/results.csv");
    const auto isRefused = [&](const QString& list, const QByteArray& why) {
        const QByteArray before = test::bytesOf(table);
        const Outcome outcome = burin(
            {key("batch"), path("batch.json"), key("--studies"), list, key("--into"), path("out")});
        return outcome.status == 1 && outcome.complaint.contains(table)
            && outcome.complaint.contains(QString::fromLatin1(why)) && outcome.lines.isEmpty()
            && !QFile::exists(path("out/one")) && test::bytesOf(table) == before;
    };
    QVERIFY(QDir().mkpath(path("out")));
    write(path("studies.csv"), "study,name,series\n" + m_series.path().toUtf8() + ",one,2.25.11\n");
    write(table, "patient,volume\n1,2\n");
    QVERIFY(isRefused(path("studies.csv"), "it is no table of a batch"));
    // One that was made of the table of another batch.
    write(table, "name,study,state,series\none," + m_series.path().toUtf8() + ",x,2.25.11\n");
    QVERIFY(isRefused(table, "it is the list of studies"));
    QVERIFY(QFile::remove(table));
    QCOMPARE(state(batch("2.25.11")), key("done"));
    QVERIFY(test::bytesOf(table).startsWith("name,study,state,"));
    QCOMPARE(state(batch("2.25.11")), key("was done"));
}

BURIN_TEST(BatchOtherGlTest)

} // namespace batchOtherGlTest

#include "BatchOtherGlTest.moc"
