// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/PacsSend.h"
#include "core/pacs/retrieve/DownloadFolder.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"
#include "tests/support/servers/WebArchive.h"

#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QMap>
#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>

namespace retrieveStormTest {

using test::FileEvent;
using test::Outcome;

namespace {

constexpr int slices = 9;
const std::array errors{EIO, ENOSPC, EDQUOT, 0};
constexpr QDir::Filters everything =
    QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot;

QString nameOf(int error)
{
    return error == 0 ? QStringLiteral("short") : QString::fromLocal8Bit(std::strerror(error));
}

/// Whether a file is the whole object that its name says.
bool isSound(const QString& path)
{
    const auto uid = core::soundObject(path);
    return uid && *uid + QStringLiteral(".dcm") == QFileInfo(path).fileName();
}

} // namespace

/// A storm on downloads: `burin get` gathers a series from a web server, or from dcmqrscp, and is
/// killed at any instant, or the n-th call that opens, writes, synchronises or renames fails.
/// Afterwards the target is whole or not there, nothing lies beside it but what a next download
/// goes on with, and that makes it whole, from what can be believed.
///
/// BURIN_SEED draws other instants, BURIN_KILLS another number; BURIN_LONG: every call in turn,
/// with each of the four errors once, and with one of them from then on.
class RetrieveStormTest : public QObject {
    Q_OBJECT

    struct Way {
        const char* name = "";
        QString source;
        QString absent; ///< the program that is not installed
        int milliseconds = 0;
        QMap<QByteArray, int> calls; ///< of an undisturbed download, by kind
    };

    test::WatchedHome m_home;
    test::SyntheticSeries m_series;
    std::optional<test::WebArchive> m_archive;
    std::atomic<bool> m_drips = false; ///< the web server takes its time
    std::unique_ptr<test::WebServer> m_web;
    std::unique_ptr<test::PacsServer> m_node;
    std::vector<Way> m_ways;
    int m_kills = 0; ///< that came in time
    int m_faults = 0; ///< that came to pass

    [[nodiscard]] QString folder() const { return m_home.path(QStringLiteral("out")); }
    [[nodiscard]] QString target() const { return folder() + QStringLiteral("/got"); }
    [[nodiscard]] QString gathering() const
    {
        return folder() + QStringLiteral("/.got.burin-download");
    }
    [[nodiscard]] QString note() const { return gathering() + QStringLiteral("/.download"); }
    [[nodiscard]] QStringList words(const Way& way) const;
    void empty() const;
    void prepare(Way& way);
    /// What is wrong with what a download left. @param killed whether it did not end by itself
    [[nodiscard]] QStringList wrongs(const Outcome& outcome, bool killed) const;
    /// Downloads again, undisturbed.
    [[nodiscard]] QStringList wrongsOfTheNext(const Way& way) const;

private Q_SLOTS:
    void initTestCase();
    void kills_data();
    void kills();
    void failingDisk_data();
    void failingDisk();
    void cleanupTestCase();
};

void RetrieveStormTest::initTestCase()
{
    m_series.size = {64, 64, slices};
    const QStringList files = test::writeSeries(m_series, m_home.path(QStringLiteral("sent")));
    m_archive.emplace(files);
    m_web = std::make_unique<test::WebServer>([this](const QByteArray& line, const QByteArray&) {
        test::WebReply reply = m_archive->answer(line);
        reply.dripMs = m_drips ? 1 : 0;
        return reply;
    });
    m_node = std::make_unique<test::PacsServer>(test::PacsServer::Program::Dcmqrscp);
    QVERIFY2(m_node->problem().isEmpty(), qPrintable(m_node->problem()));
    if (m_node->absent().isEmpty()) {
        const auto sent = core::sendFiles(m_node->node(), files, core::Progress());
        VERIFY_DONE(sent);
    }
    m_ways.resize(2);
    m_ways[0].name = "web";
    m_ways[0].source = m_web->url().toString();
    m_ways[1].name = "node";
    m_ways[1].source = m_node->node().name();
    m_ways[1].absent = m_node->absent();
    for (Way& way : m_ways) {
        if (way.absent.isEmpty())
            prepare(way);
        if (QTest::currentTestFailed())
            return;
    }
}

QStringList RetrieveStormTest::words(const Way& way) const
{
    return {QStringLiteral("get"), way.source, QStringLiteral("--study"), m_series.studyUid,
        QStringLiteral("--to"), target(), QStringLiteral("--json")};
}

void RetrieveStormTest::empty() const
{
    if (!QDir(folder()).removeRecursively() || !QDir().mkpath(folder()))
        qFatal("the folder cannot be emptied");
    static_cast<void>(m_home.events());
}

void RetrieveStormTest::prepare(Way& way)
{
    empty();
    m_drips = true;
    QElapsedTimer clock;
    clock.start();
    const Outcome counted = m_home.burin(words(way), {.under = folder()});
    way.milliseconds = int(clock.elapsed());
    m_drips = false;
    QVERIFY2(counted.status == 0, qPrintable(counted.complaint));
    const QStringList wrong = wrongs(counted, false);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    for (const FileEvent& event : m_home.events()) {
        if (event.what == "counts")
            ++way.calls[event.more.toLatin1()];
    }
    // The lock, the note and each object are opened, and each gets its name.
    QCOMPARE(way.calls["open"], 2 + slices);
    QCOMPARE(way.calls["rename"], slices + 1);
    QVERIFY(way.calls["write"] >= 2 + slices && way.calls["sync"] > slices);
    qInfo("%s: %d ms, %d calls", way.name, way.milliseconds,
        way.calls["open"] + way.calls["write"] + way.calls["sync"] + way.calls["rename"]);
}

QStringList RetrieveStormTest::wrongs(const Outcome& outcome, bool killed) const
{
    QStringList wrong;
    const bool done = outcome.status == 0;
    if (outcome.status < 0 && !killed)
        wrong += QStringLiteral("it crashed");
    if (done && !QFileInfo::exists(target()))
        wrong += QStringLiteral("it was content, and nothing is there");
    for (const QFileInfo& info : QDir(folder()).entryInfoList(everything)) {
        const QString path = info.filePath();
        const bool isPart = path == gathering();
        const bool isLock = path == gathering() + QStringLiteral(".lock");
        if (path != target() && (done || !(isPart || (killed && isLock))))
            wrong += info.fileName() + QStringLiteral(" is left over");
    }
    const QFileInfoList got = QDir(target()).entryInfoList(everything);
    if (QFileInfo::exists(target()) && got.size() != slices)
        wrong += QStringLiteral("the target has %1 files").arg(got.size());
    for (const QFileInfo& info : got + QDir(gathering()).entryInfoList(everything)) {
        const bool isPart = info.fileName().startsWith(QLatin1String(".part-"));
        const bool isNote = info.filePath() == note();
        if (!isNote && !(isPart && killed) && !isSound(info.filePath()))
            wrong += info.filePath() + QStringLiteral(" is no whole object");
    }
    return wrong;
}

QStringList RetrieveStormTest::wrongsOfTheNext(const Way& way) const
{
    QFile file(note());
    const bool isBelieved = file.open(QIODevice::ReadOnly) && !file.readAll().isEmpty();
    const QDir held(QFileInfo::exists(target()) ? target() : gathering());
    const bool counts = isBelieved || held.path() == target();
    const int kept = counts ? int(held.entryList(QDir::Files).size()) : 0;
    const Outcome next = m_home.burin(words(way));
    if (next.status != 0)
        return {QStringLiteral("the next one: ") + next.complaint};
    QStringList wrong = wrongs(next, false);
    const QJsonObject told = next.lines.value(0);
    const QJsonValue received = told[QStringLiteral("received")];
    if (told[QStringLiteral("kept")] != kept || received != slices - kept)
        wrong += QStringLiteral("the next one took %1, where %2 were there")
                     .arg(received.toInt(-1))
                     .arg(kept);
    return wrong;
}

void RetrieveStormTest::kills_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<int>("afterMs");
    const int usual = test::longRun() ? 150 : 3;
    const int kills = qEnvironmentVariableIsSet("BURIN_KILLS")
        ? qEnvironmentVariableIntValue("BURIN_KILLS")
        : usual;
    const std::uint32_t seed = qEnvironmentVariableIsSet("BURIN_SEED")
        ? qEnvironmentVariable("BURIN_SEED").toUInt()
        : std::uint32_t(QDateTime::currentMSecsSinceEpoch());
    qInfo("BURIN_SEED=%u", seed);
    test::Random random(seed);
    for (int i = 0; i < kills; ++i) {
        const Way& way = m_ways[std::size_t(i % 2)];
        const int after = test::randomInt(random, way.milliseconds / 4, way.milliseconds);
        QTest::addRow("%d: %s after %d ms", i, way.name, after) << i % 2 << after;
    }
}

void RetrieveStormTest::kills()
{
    QFETCH(int, way);
    QFETCH(int, afterMs);
    const Way& struck = m_ways[std::size_t(way)];
    if (!struck.absent.isEmpty())
        QSKIP(qPrintable(struck.absent));
    empty();
    m_drips = true;
    const Outcome outcome = test::burinKilled(words(struck), m_home.environment(), afterMs);
    m_drips = false;
    const bool inTime = outcome.status < 0;
    m_kills += inTime ? 1 : 0;
    QStringList wrong = wrongs(outcome, inTime);
    wrong += wrongsOfTheNext(struck);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n') + u'\n' + outcome.complaint));
}

void RetrieveStormTest::failingDisk_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<QByteArray>("kind");
    QTest::addColumn<int>("call");
    QTest::addColumn<int>("error");
    QTest::addColumn<bool>("lasting");
    const auto add = [this](int way, const QByteArray& kind, int call, int error, bool lasting) {
        QTest::addRow("%s, %s %d: %s%s", m_ways[std::size_t(way)].name, kind.constData(), call,
            qPrintable(nameOf(error)), lasting ? ", from then on" : "")
            << way << kind << call << error << lasting;
    };
    if (!test::longRun()) {
        add(0, "open", 1, EIO, false); // the lock
        add(0, "write", 8, ENOSPC, true);
        add(0, "sync", 5, EIO, false); // an object, after all of them came
        add(0, "rename", slices + 1, EDQUOT, false); // the folder
        return;
    }
    for (int way = 0; way < int(m_ways.size()); ++way) {
        const QMap<QByteArray, int>& calls = m_ways[std::size_t(way)].calls;
        for (auto kind = calls.begin(); kind != calls.end(); ++kind) {
            for (int call = 1; call <= kind.value(); ++call) {
                for (const int error : errors) {
                    // Only of what is written a part may be.
                    if (error != 0 || kind.key() == "write")
                        add(way, kind.key(), call, error, false);
                }
                add(way, kind.key(), call, errors[std::size_t(call) % 3], true);
            }
        }
    }
}

void RetrieveStormTest::failingDisk()
{
    QFETCH(int, way);
    QFETCH(QByteArray, kind);
    QFETCH(int, call);
    QFETCH(int, error);
    QFETCH(bool, lasting);
    const Way& struck = m_ways[std::size_t(way)];
    empty();
    const Outcome outcome = m_home.burin(words(struck),
        {.under = folder(),
            .calls = kind,
            .first = call,
            .last = lasting ? 1 << 30 : call,
            .error = error});
    QStringList failed;
    bool refused = false; // what was gathered
    for (const FileEvent& event : m_home.events()) {
        if (event.what != "fails")
            continue;
        failed += event.more + u' ' + event.path;
        refused = refused
            || (event.more == u"sync"
                && (event.path == gathering() || event.path.startsWith(gathering() + u'/')));
    }
    m_faults += failed.isEmpty() ? 0 : 1;
    QStringList wrong = wrongs(outcome, false);
    if (outcome.status != 0 && (error == 0 || failed.isEmpty()))
        wrong += QStringLiteral("it failed without a reason");
    if (outcome.status != 0 && !outcome.complaint.contains(target()))
        wrong += QStringLiteral("it does not say which folder");
    if (outcome.status != 0 && !outcome.complaint.contains(nameOf(error)))
        wrong += QStringLiteral("it does not say why");
    if (refused && (outcome.status == 0 || QFileInfo::exists(note())))
        wrong += QStringLiteral("what the disk refused is believed");
    wrong += wrongsOfTheNext(struck);
    QVERIFY2(wrong.isEmpty(),
        qPrintable(QStringLiteral("\n  wrong: %1\n  failed: %2\n  status: %3\n  said: %4")
                       .arg(wrong.join(QStringLiteral("\n         ")),
                           failed.mid(0, 3).join(QStringLiteral("\n          ")))
                       .arg(outcome.status)
                       .arg(outcome.complaint)));
}

void RetrieveStormTest::cleanupTestCase()
{
    qInfo("%d killed before they were done, %d faults", m_kills, m_faults);
}

BURIN_TEST(RetrieveStormTest)

} // namespace retrieveStormTest

#include "RetrieveStormTest.moc"
