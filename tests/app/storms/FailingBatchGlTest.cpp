// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/DownloadFolder.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/TestVolumes.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QMap>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <set>

namespace failingBatchGlTest {

using test::FileEvent;
using test::key;
using test::Outcome;

namespace {

const std::array errors{EIO, ENOSPC, EDQUOT, 0};
/// A batch and what it starts are two programs, which fail apart.
const std::array programs{"batch", "run"};

QString nameOf(int error)
{
    return error == 0 ? QStringLiteral("short") : QString::fromLocal8Bit(std::strerror(error));
}

} // namespace

/// `burin batch` on a disk that fails: the n-th call of the batch, or of the run of a study, that
/// opens a file for writing, writes, synchronises or renames fails, once or from then on, or writes
/// a part only. Afterwards each result is the old one or the new one, whole; a study that failed
/// says which file and why, and the others are done; nothing is left over; and the same batch, once
/// more, comes to what an undisturbed one comes to. Likewise a batch that is killed at any instant,
/// but that what it had begun lies there under hidden names.
///
/// BURIN_SEED draws others. BURIN_LONG: of each kind of call on each kind of file the first one
/// fails once, and the last one from then on, with the errors in turn; and eight more of each
/// program, evenly spread. Each call in turn would take hours, since it takes two batches, and most
/// are alike: of one file, or of one slice of many.
class FailingBatchGlTest : public QObject {
    Q_OBJECT

    struct Scene {
        const char* name = "";
        bool anew = false; ///< --force, over the results of another recipe
        QMap<QString, QByteArray> made; ///< the results of an undisturbed one, by path
        /// Its calls by program, in order: the kind of the call, and of the file.
        std::array<std::vector<QString>, 2> calls{};
        int milliseconds = 0;
    };
    /// One call that fails: once, or all from there on.
    struct Fault {
        int call = 0;
        int error = 0;
        bool lasting = false;
    };
    /// What a killed batch may leave besides.
    enum class Hidden {
        None,
        Files, ///< that it was writing; nobody knows whose they are
        All, ///< and the folders of its attempts, which the next one removes
    };

    test::WatchedHome m_home;
    QString m_list;
    QMap<QString, QByteArray> m_old; ///< what is there before --force, by path
    std::vector<Scene> m_scenes;
    int m_faults = 0;
    int m_told = 0;
    int m_kills = 0; ///< that came in time

    [[nodiscard]] QString folder() const { return m_home.path(QStringLiteral("out")); }
    [[nodiscard]] QString text(const char* name, const QByteArray& content) const;
    [[nodiscard]] QString recipe(const char* name, double depthMm) const;
    [[nodiscard]] QStringList words(const Scene& scene) const;
    void restore(const Scene& scene) const;
    [[nodiscard]] QMap<QString, QByteArray> everything() const;
    [[nodiscard]] QString kindOf(const FileEvent& call) const;
    [[nodiscard]] static std::vector<Fault> faultsOf(const std::vector<QString>& calls);
    /// Of a session the hashes of its rows.
    [[nodiscard]] static QByteArray contentOf(const QString& path);
    [[nodiscard]] static bool isAsMade(const QString& path, const Scene& scene, bool mayBeBegun);
    [[nodiscard]] QStringList wrongs(
        const Scene& scene, const Outcome& outcome, int error, bool lasting) const;
    [[nodiscard]] QStringList wrongsOfFiles(const Scene& scene, bool done, Hidden allowed) const;
    [[nodiscard]] QStringList wrongsOfRecord(const QString& record, const Scene& scene) const;
    [[nodiscard]] QStringList wrongsOfTheNext(const Scene& scene, Hidden allowed) const;

private Q_SLOTS:
    void initTestCase();
    void studies_data();
    void studies();
    void kills_data();
    void kills();
    void cleanupTestCase();
};

QString FailingBatchGlTest::text(const char* name, const QByteArray& content) const
{
    QFile file(m_home.path(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write %s", name);
    return file.fileName();
}

/// Exports into the study's folder, a folder of its own, and a file beside those of all others.
QString FailingBatchGlTest::recipe(const char* name, double depthMm) const
{
    const QJsonArray code{key("SCT"), key("10200004"), key("Liver")};
    const auto target = [](const char* format, const QString& file) {
        return QJsonObject{{key("format"), key(format)}, {key("file"), file}};
    };
    return text(name,
        QJsonDocument(
            QJsonObject{
                {key("edits"),
                    QJsonArray{
                        QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Liver")},
                            {key("color"), key("#336699")}, {key("code"), code}},
                        QJsonObject{{key("edit"), key("drill")},
                            {key("view"),
                                QJsonObject{{key("eyeLps"), QJsonArray{0, -300, 50}},
                                    {key("targetLps"), QJsonArray{0, 0, 50}},
                                    {key("up"), QJsonArray{0, 0, 1}}, {key("heightMm"), 60},
                                    {key("orthographic"), true}}},
                            {key("mask"),
                                QJsonObject{{key("shape"), key("circle")}, {key("radiusMm"), 4}}},
                            {key("depthMm"), depthMm},
                            {key("surface"), QJsonObject{{key("threshold"), -2000}}},
                            {key("samples"), QJsonArray{QJsonValue(QJsonArray{0, 0, 1.0, 0.0})}}},
                        QJsonObject{{key("edit"), key("layerToSegment")}, {key("layer"), 1},
                            {key("segment"), 1}}}},
                {key("export"),
                    QJsonArray{target("nifti", key("mask.nii.gz")),
                        target("dicom-seg", key("mask.dcm")),
                        target("csv", key("../all/${name}.csv")),
                        target("carved-volume", key("series"))}}})
            .toJson());
}

QStringList FailingBatchGlTest::words(const Scene& scene) const
{
    QStringList all{key("batch"), m_home.path(scene.anew ? key("new.json") : key("old.json")),
        key("--studies"), m_list, key("--into"), folder()};
    if (scene.anew)
        all += key("--force");
    return all;
}

void FailingBatchGlTest::restore(const Scene& scene) const
{
    if (!QDir(folder()).removeRecursively() || !QDir().mkpath(folder() + key("/all")))
        qFatal("the folder cannot be emptied");
    for (auto file = m_old.begin(); scene.anew && file != m_old.end(); ++file) {
        QFile written(file.key());
        if (!QDir().mkpath(QFileInfo(file.key()).path()) || !written.open(QIODevice::WriteOnly)
            || written.write(file.value()) != file.value().size())
            qFatal("cannot write %s", qPrintable(file.key()));
    }
    static_cast<void>(m_home.events());
}

QMap<QString, QByteArray> FailingBatchGlTest::everything() const
{
    QMap<QString, QByteArray> all;
    QDirIterator walk(
        folder(), QDir::Files | QDir::Hidden | QDir::System, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QString file = walk.next();
        all[file] = test::bytesOf(file);
    }
    return all;
}

/// The call and its file, alike for both studies, all slices, and whatever temporary name.
QString FailingBatchGlTest::kindOf(const FileEvent& call) const
{
    static const QRegularExpression temporary(QStringLiteral("\\.burin-[0-9a-f]+"));
    static const QRegularExpression study(QStringLiteral("\\b(one|two)\\b"));
    static const QRegularExpression number(QStringLiteral("[0-9]+"));
    QString file = QDir(folder()).relativeFilePath(call.path);
    file.replace(temporary, QStringLiteral(".burin-"));
    file.replace(study, QStringLiteral("study"));
    file.replace(number, QStringLiteral("0"));
    return call.more + u' ' + file;
}

std::vector<FailingBatchGlTest::Fault> FailingBatchGlTest::faultsOf(
    const std::vector<QString>& calls)
{
    std::map<QString, std::pair<int, int>> ofKind; // the first and the last call
    for (int call = 1; call <= int(calls.size()); ++call)
        ofKind.try_emplace(calls[std::size_t(call) - 1], call, call).first->second.second = call;
    std::vector<Fault> faults;
    std::size_t turn = 0;
    const auto next = [&turn](const QString& kind) {
        // Only a write can be done in part; that error is the last one.
        const std::size_t suiting = errors.size() - (kind.startsWith(key("write")) ? 0 : 1);
        return errors[turn++ % suiting];
    };
    for (const auto& [kind, range] : ofKind) {
        faults.push_back({.call = range.first, .error = next(kind)});
        faults.push_back({.call = range.second, .error = next(kind), .lasting = true});
    }
    const std::size_t further = std::min<std::size_t>(8, calls.size());
    for (std::size_t i = 0; i < further; ++i) {
        const std::size_t call = (2 * i + 1) * calls.size() / (2 * further); // counted from 0
        faults.push_back({.call = int(call) + 1, .error = next(calls[call])});
    }
    return faults;
}

/// Of what holds new UIDs and times that it is whole; of sessions the states that they come to.
QByteArray FailingBatchGlTest::contentOf(const QString& path)
{
    if (path.endsWith(QLatin1String(".dcm")))
        return core::soundObject(path) ? "sound" : "defective";
    if (!path.endsWith(QLatin1String(".burin")))
        return test::bytesOf(path);
    const auto contents = core::checkSession(path);
    if (!contents)
        return contents.error().arguments.join(u' ').toUtf8();
    if (!contents->isWhole() || !contents->leftOpen.isEmpty())
        return "not whole: " + contents->leftOpen.english().toUtf8();
    QByteArray hashes;
    for (const core::HistoryRow& row : contents->rows)
        hashes += row.stateHash + '\n';
    return hashes;
}

void FailingBatchGlTest::initTestCase()
{
    QByteArray list = "study,name\n";
    for (const char* name : {"one", "two"}) {
        test::SyntheticSeries series;
        series.size = {24, 18, 8};
        series.seriesUid = QStringLiteral("2.25.1") + QString::number(qstrlen(name) + name[0]);
        series.slope = [name](int) { return name[0] == 'o' ? 1.0 : 2.0; };
        const QString study = m_home.path(QLatin1String(name));
        test::writeSeries(series, study);
        list += study.toUtf8() + ',' + name + '\n';
    }
    m_list = text("studies.csv", list);
    QVERIFY(!recipe("old.json", 3).isEmpty() && !recipe("new.json", 6).isEmpty());
    m_scenes = {{.name = "new"}, {.name = "--force", .anew = true}};
    for (Scene& scene : m_scenes) {
        restore(scene);
        QElapsedTimer clock;
        clock.start();
        const Outcome done = m_home.burin(words(scene));
        scene.milliseconds = int(clock.elapsed());
        QVERIFY2(done.status == 0, qPrintable(done.complaint));
        const QMap<QString, QByteArray> all = everything();
        for (auto file = all.begin(); file != all.end(); ++file)
            scene.made[file.key()] = contentOf(file.key());
        // The lock, the record, the filled recipe, the session, three exports and eight slices of
        // each, and the table.
        QCOMPARE(scene.made.size(), 2 * (3 + 1 + 3 + 8) + 1);
        if (!scene.anew)
            m_old = all;
        const QStringList wrong = wrongs(scene, done, EIO, false);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
        for (std::size_t program = 0; program < programs.size(); ++program) {
            restore(scene);
            const Outcome counted =
                m_home.burin(words(scene), {.under = folder(), .of = programs[program]});
            QVERIFY2(counted.status == 0, qPrintable(counted.complaint));
            std::vector<QString>& calls = scene.calls[program];
            for (const FileEvent& event : m_home.events()) {
                if (event.what == "counts")
                    calls.push_back(kindOf(event));
            }
            // The runs of both studies are alike, and each counts for itself.
            if (programs[program] == QByteArray("run"))
                calls.resize(calls.size() / 2);
            QVERIFY(!calls.empty());
            qInfo("%s: %d calls of %s, %d kinds", scene.name, int(calls.size()), programs[program],
                int(std::set<QString>(calls.begin(), calls.end()).size()));
        }
    }
    QVERIFY(m_scenes[0].made != m_scenes[1].made);
}

/// What a record says is so.
QStringList FailingBatchGlTest::wrongsOfRecord(const QString& record, const Scene& scene) const
{
    const QJsonObject content = QJsonDocument::fromJson(test::bytesOf(record)).object();
    const QString state = content[key("state")].toString();
    const QString name = QFileInfo(record).dir().dirName() + QStringLiteral("/record.json ");
    if (state == QLatin1String("done")) {
        const bool isOld = test::bytesOf(record) == m_old.value(record);
        for (auto file = scene.made.begin(); file != scene.made.end(); ++file) {
            const bool isResult = file.key().startsWith(QFileInfo(record).path() + u'/')
                && !file.key().endsWith(QLatin1String(".json"))
                && !file.key().endsWith(QLatin1String("/lock"));
            if (isResult && !isOld && contentOf(file.key()) != file.value())
                return {name + QStringLiteral("says done, and it is not: ") + file.key()};
        }
        return {};
    }
    if (state == QLatin1String("failed") && content[key("failure")].toString().isEmpty())
        return {name + QStringLiteral("does not say why it failed")};
    if (state != QLatin1String("failed") && state != QLatin1String("begun"))
        return {name + QStringLiteral("says '%1'").arg(state)};
    return {};
}

/// What a run has finished that failed is whole, too: steps up to one of them.
bool FailingBatchGlTest::isAsMade(const QString& path, const Scene& scene, bool mayBeBegun)
{
    QByteArray content = contentOf(path);
    const QByteArray made = scene.made.value(path);
    if (content == made || !mayBeBegun || !path.endsWith(QLatin1String(".burin")))
        return content == made;
    // A step that lacks its second half is carried out again when the session is opened.
    while (content.endsWith("\n\n") || content == "\n")
        content.chop(1);
    return made.startsWith(content);
}

QStringList FailingBatchGlTest::wrongs(
    const Scene& scene, const Outcome& outcome, int error, bool lasting) const
{
    QStringList wrong;
    if (outcome.status < 0)
        wrong += QStringLiteral("it crashed");
    if (outcome.status != 0 && error == 0)
        wrong += QStringLiteral("part of a write is no reason to fail");
    int failedStudies = 0;
    for (const QJsonObject& line : outcome.lines) {
        const QString why = line[key("failure")].toString();
        if (why.isEmpty())
            continue;
        ++failedStudies;
        bool reasoned = false;
        for (const QString& reason : {nameOf(error), QStringLiteral("database or disk is full"),
                 QStringLiteral("unable to open database file"),
                 QStringLiteral("could not be closed as one file"),
                 QStringLiteral("it was not closed")})
            reasoned = reasoned || why.contains(reason);
        if (!reasoned)
            wrong += QStringLiteral("it does not say why: ") + why;
        if (!why.contains(folder()))
            wrong += QStringLiteral("it does not say which file: ") + why;
        if (why.contains(key("/.burin-")))
            wrong += QStringLiteral("it names what nobody finds: ") + why;
        if (!outcome.complaint.contains(why))
            wrong += QStringLiteral("stderr does not say so");
    }
    if (outcome.lines.size() != 2)
        wrong += QStringLiteral("%1 studies were told of").arg(outcome.lines.size());
    if (!lasting && failedStudies > 1)
        wrong += QStringLiteral("one fault, and two studies failed");
    if (outcome.status > 0 && failedStudies == 0
        && !(outcome.complaint.contains(key("results.csv"))
            && outcome.complaint.contains(nameOf(error))))
        wrong += QStringLiteral("nobody says what failed");
    return wrong + wrongsOfFiles(scene, outcome.status == 0, Hidden::None);
}

QStringList FailingBatchGlTest::wrongsOfFiles(const Scene& scene, bool done, Hidden allowed) const
{
    QStringList wrong;
    const auto isAllowed = [allowed](const QString& name) {
        const bool isFile = QFileInfo(name).fileName().startsWith(QLatin1String(".burin-"));
        return allowed != Hidden::None && name.contains(key(".burin-"))
            && (isFile || allowed == Hidden::All);
    };
    const QMap<QString, QByteArray> all = everything();
    for (auto file = all.begin(); file != all.end(); ++file) {
        const QString name = QDir(folder()).relativeFilePath(file.key());
        const bool isOld =
            scene.anew && m_old.value(file.key()) == file.value() && m_old.contains(file.key());
        if (isAllowed(name))
            continue;
        if (!scene.made.contains(file.key())) {
            wrong += name + QStringLiteral(" is left over");
        } else if (name.endsWith(QLatin1String("/record.json"))) {
            wrong += wrongsOfRecord(file.key(), scene);
        } else if (name == QLatin1String("results.csv")) {
            // Of every study a line, whatever became of it.
            if (file.value().count("\r\n") != 3)
                wrong += QStringLiteral("the table is not whole");
        } else if (!isOld && !isAsMade(file.key(), scene, !done)) {
            wrong += name + QStringLiteral(" is neither the old one nor the new one: ")
                + QString::fromUtf8(contentOf(file.key())).left(300);
        }
        if (done && isOld && !name.endsWith(QLatin1String("lock")))
            wrong += name + QStringLiteral(" is as it was, and the command was content");
    }
    for (auto file = scene.made.begin(); file != scene.made.end(); ++file) {
        const bool isMissed = scene.anew || done;
        if (isMissed && !all.contains(file.key()))
            wrong += file.key() + QStringLiteral(" is gone");
    }
    return wrong;
}

QStringList FailingBatchGlTest::wrongsOfTheNext(const Scene& scene, Hidden allowed) const
{
    const Outcome next = m_home.burin(words(scene));
    if (next.status != 0)
        return {QStringLiteral("the next one: ") + next.complaint};
    QStringList wrong;
    for (auto file = scene.made.begin(); file != scene.made.end(); ++file) {
        const bool tells = file.key().endsWith(QLatin1String("record.json"))
            || file.key().endsWith(QLatin1String("results.csv")); // of times
        if (!tells && contentOf(file.key()) != file.value())
            wrong += QStringLiteral("after the next one: ") + file.key();
    }
    return wrong
        + (allowed == Hidden::None ? wrongs(scene, next, EIO, false)
                                   : wrongsOfFiles(scene, true, allowed));
}

void FailingBatchGlTest::studies_data()
{
    QTest::addColumn<int>("scene");
    QTest::addColumn<int>("program");
    QTest::addColumn<int>("call");
    QTest::addColumn<int>("error");
    QTest::addColumn<bool>("lasting");
    int number = 0;
    const auto add = [this, &number](std::size_t scene, std::size_t program, const Fault& fault) {
        const std::vector<QString>& calls = m_scenes[scene].calls[program];
        QTest::addRow("%d: %s, call %d of %d of %s (%s): %s%s", ++number, m_scenes[scene].name,
            fault.call, int(calls.size()), programs[program],
            qPrintable(calls[std::size_t(fault.call) - 1]), qPrintable(nameOf(fault.error)),
            fault.lasting ? ", from then on" : "")
            << int(scene) << int(program) << fault.call << fault.error << fault.lasting;
    };
    const std::uint32_t seed = qEnvironmentVariableIsSet("BURIN_SEED")
        ? qEnvironmentVariable("BURIN_SEED").toUInt()
        : 4U; // the same every day: a new one may find something new, which is for the long run
    qInfo("BURIN_SEED=%u", seed);
    test::Random random(seed);
    for (std::size_t scene = 0; scene < m_scenes.size(); ++scene) {
        for (std::size_t program = 0; program < programs.size(); ++program) {
            const std::vector<QString>& calls = m_scenes[scene].calls[program];
            for (const Fault& fault : test::longRun() ? faultsOf(calls) : std::vector<Fault>())
                add(scene, program, fault);
            for (int i = 0; !test::longRun() && i < 3; ++i) {
                const int call = test::randomInt(random, 1, int(calls.size()));
                const bool lasting = test::randomInt(random, 0, 2) == 0;
                add(scene, program,
                    {.call = call,
                        .error = errors[(std::size_t(i) + scene) % errors.size()],
                        .lasting = lasting});
            }
        }
    }
}

void FailingBatchGlTest::studies()
{
    QFETCH(int, scene);
    QFETCH(int, program);
    QFETCH(int, call);
    QFETCH(int, error);
    QFETCH(bool, lasting);
    const Scene& struck = m_scenes[std::size_t(scene)];
    restore(struck);
    const Outcome outcome = m_home.burin(words(struck),
        {.under = folder(),
            .first = call,
            .last = lasting ? 1 << 30 : call,
            .error = error,
            .of = programs[std::size_t(program)]});
    QStringList failed;
    for (const FileEvent& event : m_home.events()) {
        if (event.what == "fails")
            failed += event.more + QLatin1Char(' ') + event.path;
    }
    m_faults += failed.isEmpty() ? 0 : 1;
    m_told += outcome.status == 0 ? 0 : 1;
    // Each study has a run of its own, in which the same call fails.
    const bool ofBoth = lasting || programs[std::size_t(program)] == QByteArray("run");
    QStringList wrong = wrongs(struck, outcome, error, ofBoth);
    wrong += wrongsOfTheNext(struck, Hidden::None);
    QVERIFY2(wrong.isEmpty(),
        qPrintable(QStringLiteral("\n  wrong: %1\n  failed: %2\n  status: %3\n  said: %4")
                       .arg(wrong.join(QStringLiteral("\n         ")),
                           failed.mid(0, 3).join(QStringLiteral("\n          ")))
                       .arg(outcome.status)
                       .arg(outcome.complaint)));
}

void FailingBatchGlTest::kills_data()
{
    QTest::addColumn<int>("scene");
    QTest::addColumn<int>("afterMs");
    const int usual = test::longRun() ? 40 : 4;
    const int kills = qEnvironmentVariableIsSet("BURIN_KILLS")
        ? qEnvironmentVariableIntValue("BURIN_KILLS")
        : usual;
    const std::uint32_t seed = qEnvironmentVariableIsSet("BURIN_SEED")
        ? qEnvironmentVariable("BURIN_SEED").toUInt()
        : test::longRun() ? std::uint32_t(QDateTime::currentMSecsSinceEpoch())
                          : 4U;
    qInfo("BURIN_SEED=%u", seed);
    test::Random random(seed);
    for (int i = 0; i < kills; ++i) {
        const std::size_t scene = std::size_t(i) % m_scenes.size();
        const int after = test::randomInt(random, 0, m_scenes[scene].milliseconds);
        QTest::addRow("%d: %s after %d ms", i, m_scenes[scene].name, after) << int(scene) << after;
    }
}

void FailingBatchGlTest::kills()
{
    QFETCH(int, scene);
    QFETCH(int, afterMs);
    const Scene& struck = m_scenes[std::size_t(scene)];
    restore(struck);
    const Outcome outcome = test::burinKilled(words(struck), m_home.environment(), afterMs);
    m_kills += outcome.status < 0 ? 1 : 0;
    // The run of a study ends by itself then; the next batch waits for that.
    QStringList wrong = wrongsOfFiles(struck, outcome.status == 0, Hidden::All);
    wrong += wrongsOfTheNext(struck, Hidden::Files);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n') + u'\n' + outcome.complaint));
}

void FailingBatchGlTest::cleanupTestCase()
{
    qInfo("%d faults, %d of them made a batch fail; %d kills", m_faults, m_told, m_kills);
}

BURIN_TEST(FailingBatchGlTest)

} // namespace failingBatchGlTest

#include "FailingBatchGlTest.moc"
