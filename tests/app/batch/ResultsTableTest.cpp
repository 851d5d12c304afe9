// SPDX-License-Identifier: Apache-2.0
#include "app/batch/ResultsTable.h"
#include "app/commands/BatchCommand.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>
#include <memory>

namespace resultsTableTest {

using app::StudyTask;

/// The table of a batch, from records and statistics that lie in its folders.
class ResultsTableTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] StudyTask task() const;
    /// Writes that the task was done, with statistics that have these lines.
    void writeDone(const StudyTask& task, const QByteArray& statistics,
        const char* name = "numbers.csv") const;
    /// The table of the one task: names of its columns, with their values.
    [[nodiscard]] QMap<QString, QString> rowOf(const StudyTask& task) const;

private Q_SLOTS:
    void init();
    void whatIsDoneHasItsNumbers();
    void endingsMayBeInCapitals();
    void whatIsOfAnotherBatchHasNone_data();
    void whatIsOfAnotherBatchHasNone();
    void segmentsOfOneNameHaveColumnsOfTheirOwn();
    void attemptsOfEarlierBatchesCount();
};

StudyTask ResultsTableTest::task() const
{
    return {.study = {.path = QStringLiteral("/data/ct"),
                .name = QStringLiteral("one"),
                .session = QStringLiteral("session.burin"),
                .series = QStringLiteral("2.25.1")},
        .folder = m_folder->filePath(QStringLiteral("one")),
        .recipe = "{}",
        .recipePath = QStringLiteral("/data/recipe.json"),
        .options = {QStringLiteral("--author"), QStringLiteral("Somebody")}};
}

void ResultsTableTest::writeDone(
    const StudyTask& task, const QByteArray& statistics, const char* name) const
{
    const QJsonObject record{{QStringLiteral("state"), QStringLiteral("done")},
        {QStringLiteral("study"), task.study.path}, {QStringLiteral("series"), task.study.series},
        {QStringLiteral("repair"), task.study.repair},
        {QStringLiteral("spacing"), task.study.spacing},
        {QStringLiteral("session"), task.study.session},
        {QStringLiteral("recipeSha256"),
            QString::fromLatin1(
                QCryptographicHash::hash(task.recipe, QCryptographicHash::Sha256).toHex())},
        {QStringLiteral("options"), QJsonArray::fromStringList(task.options)},
        {QStringLiteral("stateHash"), QStringLiteral("abc")}, {QStringLiteral("seconds"), 1.5},
        {QStringLiteral("exports"),
            QJsonArray{QJsonObject{{QStringLiteral("file"), QLatin1String(name)}}}}};
    QVERIFY(QDir().mkpath(task.folder));
    const auto write = [&task](const char* to, const QByteArray& text) {
        QFile file(QDir(task.folder).filePath(QLatin1String(to)));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    };
    QVERIFY(write("record.json", QJsonDocument(record).toJson()));
    QVERIFY(
        write(name, "label,name,codingScheme,code,meaning,unit,voxels,volumeMl\r\n" + statistics));
}

QMap<QString, QString> ResultsTableTest::rowOf(const StudyTask& task) const
{
    QMap<QString, QString> row;
    const auto rows =
        app::readTable(QString::fromUtf8(app::resultsTable({task})), QLatin1Char(','));
    if (!rows || rows->size() != 2)
        return row;
    for (qsizetype i = 0; i < rows->front().size(); ++i)
        row[rows->front()[i]] = rows->back().value(i);
    return row;
}

void ResultsTableTest::init()
{
    test::failOnUnexpectedMessages();
    m_folder = std::make_unique<QTemporaryDir>();
}

void ResultsTableTest::whatIsDoneHasItsNumbers()
{
    StudyTask same = task();
    writeDone(same, "1,Bone,,,,HU,10,0.5\r\n2,Brain,,,,HU,20,1.25\r\n");
    same.options.last() = QStringLiteral("Another");
    const QMap<QString, QString> row = rowOf(same);
    QCOMPARE(row[QStringLiteral("state")], QStringLiteral("done"));
    QCOMPARE(row[QStringLiteral("stateHash")], QStringLiteral("abc"));
    QCOMPARE(row[QStringLiteral("Bone volumeMl")], QStringLiteral("0.5"));
    QCOMPARE(row[QStringLiteral("Brain volumeMl")], QStringLiteral("1.25"));
}

/// An export takes them.
void ResultsTableTest::endingsMayBeInCapitals()
{
    writeDone(task(), "1,Bone,,,,HU,10,0.5\r\n", "numbers.CSV");
    QCOMPARE(rowOf(task())[QStringLiteral("Bone volumeMl")], QStringLiteral("0.5"));
}

void ResultsTableTest::whatIsOfAnotherBatchHasNone_data()
{
    QTest::addColumn<std::function<void(StudyTask&)>>("change");
    QTest::addColumn<QString>("why");
    const auto row = [](const char* name, const char* why,
                         const std::function<void(StudyTask&)>& change) {
        QTest::newRow(name) << change << QString::fromLatin1(why);
    };
    row("study", "another study, /data/ct",
        [](StudyTask& task) { task.study.path = QStringLiteral("/data/mr"); });
    row("recipe", "another recipe", [](StudyTask& task) { task.recipe = "{ }"; });
    row("series", "another series (2.25.1)",
        [](StudyTask& task) { task.study.series = QStringLiteral("2.25.2"); });
    row("repair", "another repair (none)",
        [](StudyTask& task) { task.study.repair = QStringLiteral("order"); });
    row("spacing", "another spacing (none)",
        [](StudyTask& task) { task.study.spacing = QStringLiteral("1x1x2"); });
    row("session file", "another session file (session.burin)",
        [](StudyTask& task) { task.study.session = QStringLiteral("two.burin"); });
    row("option", "other options (none)",
        [](StudyTask& task) { task.options += QStringLiteral("--with-images"); });
}

/// The rows are what the help of --force names.
void ResultsTableTest::whatIsOfAnotherBatchHasNone()
{
    QFETCH(std::function<void(StudyTask&)>, change);
    QFETCH(QString, why);
    writeDone(task(), "1,Bone,,,,HU,10,0.5\r\n");
    StudyTask asked = task();
    change(asked);
    const auto& options = app::batchCommand.options;
    const auto force = std::find_if(options.begin(), options.end(),
        [](const auto& option) { return QLatin1String(option.name) == QLatin1String("force"); });
    QVERIFY(force != options.end());
    QVERIFY2(QString::fromLatin1(force->help).contains(QLatin1String(QTest::currentDataTag())),
        force->help);
    const QMap<QString, QString> row = rowOf(asked);
    QCOMPARE(row[QStringLiteral("state")], QStringLiteral("other"));
    QVERIFY2(
        row[QStringLiteral("failure")].contains(why), qPrintable(row[QStringLiteral("failure")]));
    QCOMPARE(row[QStringLiteral("stateHash")], QString());
    QCOMPARE(row[QStringLiteral("seconds")], QString());
    QVERIFY(!row.contains(QStringLiteral("Bone volumeMl")));
}

void ResultsTableTest::segmentsOfOneNameHaveColumnsOfTheirOwn()
{
    writeDone(task(),
        "1,Metastasis,,,,HU,10,0.5\r\n2,Metastasis,,,,HU,20,1.25\r\n3,Liver,,,,HU,30,1500\r\n");
    const QMap<QString, QString> row = rowOf(task());
    QCOMPARE(row[QStringLiteral("Metastasis (1) volumeMl")], QStringLiteral("0.5"));
    QCOMPARE(row[QStringLiteral("Metastasis (2) volumeMl")], QStringLiteral("1.25"));
    QCOMPARE(row[QStringLiteral("Liver volumeMl")], QStringLiteral("1500"));
    QVERIFY(!row.contains(QStringLiteral("Metastasis volumeMl")));
}

void ResultsTableTest::attemptsOfEarlierBatchesCount()
{
    writeDone(task(), "");
    const QString path = QDir(task().folder).filePath(QStringLiteral("record.json"));
    const auto told = [&](const char* key, int number) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            qFatal("cannot read %s", qPrintable(path));
        QJsonObject record = QJsonDocument::fromJson(file.readAll()).object();
        file.close();
        record[QLatin1String(key)] = number;
        if (!file.open(QIODevice::WriteOnly))
            qFatal("cannot write %s", qPrintable(path));
        file.write(QJsonDocument(record).toJson());
        file.close();
        return rowOf(task())[QStringLiteral("attempts")];
    };
    QCOMPARE(rowOf(task())[QStringLiteral("attempts")], QString());
    QCOMPARE(told("attempts", 2), QStringLiteral("2"));
    QCOMPARE(told("attemptsInAll", 5), QStringLiteral("5"));
}

BURIN_TEST(ResultsTableTest)

} // namespace resultsTableTest

#include "ResultsTableTest.moc"
