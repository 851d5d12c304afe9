// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/ProcessTable.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

#include <csignal>

namespace batchResumeGlTest {

using test::burin;
using test::key;
using test::Outcome;
using test::RunningProcess;

/// What attempts leave that were killed, and what a batch replaces: its own results, and nothing
/// else. The study is a DICOM series, since the series that is carved from it is a folder.
class BatchResumeGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    QTemporaryDir m_series;
    QString m_recipe;

    /// With one more export, if it is named.
    void writeRecipe(const QString& elsewhere = {});
    [[nodiscard]] QStringList words(const char* into) const;
    [[nodiscard]] QString at(const char* into, const char* file) const;
    [[nodiscard]] static QByteArray content(const QString& file);
    static void write(const QString& file, const QByteArray& text);
    [[nodiscard]] QJsonObject record(const char* into) const;
    /// As if the last attempt had been killed before it wrote that it is done.
    void setBegun(const char* into) const;
    /// All files of the study's results, with their contents; of a record only the state.
    [[nodiscard]] QMap<QString, QByteArray> everything(const char* into) const;
    [[nodiscard]] bool killWhileExporting(const char* into) const;
    [[nodiscard]] QString hiddenIn(const char* into) const;
    void compareResults(const char* into, const char* other) const;

private Q_SLOTS:
    void initTestCase();
    void init();
    void aStudyThatWasKilledIsDoneAgain();
    void whatNoAttemptMadeStays();
    void elsewhereLikewise();
};

void BatchResumeGlTest::initTestCase()
{
    test::SyntheticSeries series;
    QCOMPARE(test::writeSeries(series, m_series.filePath(key("s0"))).size(), series.size.z);
}

void BatchResumeGlTest::init()
{
    test::failOnUnexpectedMessages();
    makeFolder();
    writeRecipe();
}

void BatchResumeGlTest::writeRecipe(const QString& elsewhere)
{
    QJsonArray exports;
    const auto add = [&exports](const char* format, const QString& file) {
        exports.append(QJsonObject{{key("format"), key(format)}, {key("file"), file}});
    };
    add("carved-volume", key("carved"));
    add("nifti", key("mask.nii.gz"));
    for (const char* surface : {"stl", "obj", "ply"})
        add(surface, key("${name}.") + key(surface));
    add("csv", elsewhere.isEmpty() ? key("${name}.csv") : elsewhere);
    m_recipe = recipe("recipe.json",
        {{key("edits"),
             test::toJson({test::addSegment("Part"), test::carveAt({{0, 0, 50}}),
                 test::paintAt(1, {{4, 4, 55}}, 3.0)})},
            {key("export"), exports}});
}

QStringList BatchResumeGlTest::words(const char* into) const
{
    return {key("batch"), m_recipe, key("--studies"), m_series.path(), key("--into"), path(into)};
}

QString BatchResumeGlTest::at(const char* into, const char* file) const
{
    return QDir(path(into)).filePath(key("s0/") + key(file));
}

QByteArray BatchResumeGlTest::content(const QString& file)
{
    QFile read(file);
    return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
}

void BatchResumeGlTest::write(const QString& file, const QByteArray& text)
{
    QFile written(file);
    if (!written.open(QIODevice::WriteOnly) || written.write(text) != text.size())
        qFatal("cannot write %s", qPrintable(file));
}

QJsonObject BatchResumeGlTest::record(const char* into) const
{
    return QJsonDocument::fromJson(content(at(into, "record.json"))).object();
}

void BatchResumeGlTest::setBegun(const char* into) const
{
    QJsonObject changed = record(into);
    changed[key("state")] = key("begun");
    write(at(into, "record.json"), QJsonDocument(changed).toJson());
}

QMap<QString, QByteArray> BatchResumeGlTest::everything(const char* into) const
{
    QMap<QString, QByteArray> all;
    QDirIterator walk(at(into, ""), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QString file = walk.next();
        if (!file.endsWith(key("/record.json")))
            all[QDir::cleanPath(file)] = content(file);
    }
    return all;
}

/// The hidden folders and files among the results.
QString BatchResumeGlTest::hiddenIn(const char* into) const
{
    return QDir(at(into, ""))
        .entryList({key(".burin-*")}, QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot)
        .join(QLatin1Char(' '));
}

/// Starts the batch, and kills it and its run as soon as something of an export is there.
/// @return whether that came in time
bool BatchResumeGlTest::killWhileExporting(const char* into) const
{
    QProcess whole;
    whole.setStandardOutputFile(QProcess::nullDevice());
    whole.start(QStringLiteral(BURIN_PROGRAM), words(into));
    if (!whole.waitForStarted())
        return false;
    bool isExporting = false;
    while (!isExporting && whole.state() != QProcess::NotRunning) {
        QTest::qWait(1);
        const QString attempt = hiddenIn(into).section(QLatin1Char(' '), 0, 0);
        const QDir made(at(into, "") + attempt + key("/new"));
        isExporting = !attempt.isEmpty()
            && !made.entryList(QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot).isEmpty();
    }
    const bool isHeld = isExporting && test::holdProcess(whole.processId())
        && record(into)[key("state")].toString() == key("begun");
    if (isHeld) {
        for (const RunningProcess& each : test::runningProcesses()) {
            if (each.parent == whole.processId())
                ::kill(pid_t(each.pid), SIGKILL);
        }
    }
    whole.kill();
    whole.waitForFinished(60000);
    return isHeld;
}

/// Both are done, and hold the same; series have UIDs of their own, and the same voxels.
void BatchResumeGlTest::compareResults(const char* into, const char* other) const
{
    const QJsonObject made = record(into);
    const QJsonObject expected = record(other);
    QCOMPARE(made[key("state")].toString(), key("done"));
    QCOMPARE(expected[key("state")].toString(), key("done"));
    QVERIFY(!made[key("stateHash")].toString().isEmpty());
    QCOMPARE(made[key("stateHash")], expected[key("stateHash")]);
    QVERIFY(!made.contains(key("made")) && !made.contains(key("attempt")));
    const QJsonArray files = made[key("exports")].toArray();
    const QJsonArray others = expected[key("exports")].toArray();
    QCOMPARE(files.size(), others.size());
    int same = 0;
    for (qsizetype i = 0; i < files.size(); ++i) {
        const QString file = files[i][key("file")].toString();
        QCOMPARE(file, others[i][key("file")].toString());
        if (file.startsWith(key("carved/")))
            continue;
        QCOMPARE(files[i][key("sha256")].toString(), others[i][key("sha256")].toString());
        ++same;
    }
    QCOMPARE(same, 5);
    const auto volume = core::loadVolume(at(into, "carved"));
    const auto expectedVolume = core::loadVolume(at(other, "carved"));
    QVERIFY(volume && expectedVolume);
    QCOMPARE(volume->volume.geometry.size, expectedVolume->volume.geometry.size);
    QVERIFY(volume->codes == expectedVolume->codes);
}

void BatchResumeGlTest::aStudyThatWasKilledIsDoneAgain()
{
    const Outcome undisturbed = burin(words("undisturbed"));
    QVERIFY2(undisturbed.status == 0, qPrintable(undisturbed.complaint));
    bool killed = false;
    for (int tries = 0; tries < 5 && !killed; ++tries) {
        QDir(path("out")).removeRecursively();
        killed = killWhileExporting("out");
    }
    QVERIFY(killed);
    // Nothing has its name yet, and what there is is on record.
    QVERIFY(
        !QFileInfo::exists(at("out", "carved")) && !QFileInfo::exists(at("out", "mask.nii.gz")));
    const QString left = hiddenIn("out");
    QVERIFY(!left.isEmpty());
    QCOMPARE(QFileInfo(record("out")[key("attempt")][0].toString()).fileName(), left);

    const Outcome again = burin(words("out"));
    QVERIFY2(again.status == 0, qPrintable(again.complaint));
    QCOMPARE(hiddenIn("out"), QString());
    QCOMPARE(record("out")[key("starts")].toInt(), 2);
    compareResults("out", "undisturbed");

    // Killed while results got their names: a part of the series is missing.
    const QMap<QString, QByteArray> before = everything("out");
    setBegun("out");
    const QString image = QDir::cleanPath(QDirIterator(at("out", "carved"), QDir::Files).next());
    QVERIFY(before.contains(image) && QFile::remove(image));
    const Outcome third = burin(words("out"));
    QVERIFY2(third.status == 0, qPrintable(third.complaint));
    compareResults("out", "undisturbed");
    QCOMPARE(everything("out").keys(), before.keys());
    // A new series: its images have names of their own.
    QVERIFY(content(image) != before[image]);
}

void BatchResumeGlTest::whatNoAttemptMadeStays()
{
    QCOMPARE(burin(words("out")).status, 0);
    const QMap<QString, QByteArray> done = everything("out");
    setBegun("out");
    const struct {
        const char* file;
        const char* refused;
    } rows[] = {{"carved/notes.txt", "s0/carved"}, {"carved/IM0003.dcm", "s0/carved"},
        {"mask.nii.gz", "s0/mask.nii.gz"}, {"session.burin", "s0/session.burin"}};
    for (const auto& row : rows) {
        const QString mine = at("out", row.file);
        const QByteArray original = content(mine);
        write(mine, "mine");
        const QMap<QString, QByteArray> before = everything("out");
        const Outcome again = burin(words("out"));
        QCOMPARE(again.status, 1);
        QVERIFY2(again.complaint.contains(key(row.refused)), qPrintable(again.complaint));
        QVERIFY(everything("out") == before);
        QCOMPARE(record("out")[key("state")].toString(), key("failed"));
        if (original.isEmpty())
            QVERIFY(QFile::remove(mine));
        else
            write(mine, original);
    }
    QVERIFY(everything("out") == done);
    // What is in nobody's way does not stop the batch either.
    QVERIFY(QDir().mkpath(at("out", ".burin-0123456789ab")));
    for (const char* file : {"notes.txt", ".burin-0123456789ab/notes.txt"})
        write(at("out", file), "mine");
    const Outcome again = burin(words("out"));
    QVERIFY2(again.status == 0, qPrintable(again.complaint));
    QCOMPARE(record("out")[key("state")].toString(), key("done"));
    QCOMPARE(everything("out").size(), done.size() + 2);
    for (const char* file : {"notes.txt", ".burin-0123456789ab/notes.txt"})
        QCOMPARE(content(at("out", file)), QByteArray("mine"));
}

void BatchResumeGlTest::elsewhereLikewise()
{
    const QString elsewhere = QDir(path("elsewhere")).filePath(key("numbers.csv"));
    QVERIFY(QDir().mkpath(path("elsewhere")));
    writeRecipe(elsewhere);
    write(elsewhere, "mine");
    const Outcome refused = burin(words("out"));
    QCOMPARE(refused.status, 1);
    QVERIFY2(
        refused.complaint.contains(key("elsewhere/numbers.csv")), qPrintable(refused.complaint));
    QCOMPARE(content(elsewhere), QByteArray("mine"));

    QVERIFY(QFile::remove(elsewhere));
    const Outcome done = burin(words("out"));
    QVERIFY2(done.status == 0, qPrintable(done.complaint));
    const QByteArray numbers = content(elsewhere);
    QVERIFY(numbers.contains("Part"));
    setBegun("out");
    const Outcome again = burin(words("out"));
    QVERIFY2(again.status == 0, qPrintable(again.complaint));
    QCOMPARE(content(elsewhere), numbers);
    const QStringList there =
        QDir(path("elsewhere")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    QCOMPARE(there, QStringList{key("numbers.csv")});
}

BURIN_TEST(BatchResumeGlTest)

} // namespace batchResumeGlTest

#include "BatchResumeGlTest.moc"
