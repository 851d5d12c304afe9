// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/StormStage.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

namespace failingDiskGlTest {

using test::FileFault;
using test::Outcome;

namespace {

const std::array errors{EIO, ENOSPC, EDQUOT, 0};

QString nameOf(int error)
{
    return error == 0 ? QStringLiteral("short") : QString::fromLocal8Bit(std::strerror(error));
}

} // namespace

/// A storm of disks that fail: the n-th call that opens a file for writing, writes, synchronises or
/// renames fails, once or from then on, or writes a part only, while sessions and exports are made.
/// Afterwards every file is the old one or the new one, whole; what was told is there; who failed
/// says why; nothing is left over.
///
/// BURIN_SEED draws others; BURIN_LONG: every call in turn, with each of the four errors once, and
/// with one of them from then on.
class FailingDiskGlTest : public QObject {
    Q_OBJECT

    std::unique_ptr<test::WatchedHome> m_home;
    std::unique_ptr<test::StormStage> m_stage;
    std::vector<int> m_calls; ///< of each scene
    std::vector<std::vector<int>> m_renames; ///< of each scene, which of its calls they are
    std::uint32_t m_seed = 0;
    int m_faults = 0;
    int m_told = 0;

private Q_SLOTS:
    void initTestCase();
    void sessionsAndExports_data();
    void sessionsAndExports();
    void aDamagedWorkingSession();
    void cleanupTestCase();
};

void FailingDiskGlTest::initTestCase()
{
    m_home = std::make_unique<test::WatchedHome>();
    m_stage = std::make_unique<test::StormStage>(*m_home);
    m_seed = qEnvironmentVariableIsSet("BURIN_SEED")
        ? qEnvironmentVariable("BURIN_SEED").toUInt()
        : 4U; // the same every day: a new one may find something new, which is for the long run
    qInfo("BURIN_SEED=%u", m_seed);
    for (const test::StormStage::Scene& scene : m_stage->scenes()) {
        m_stage->restore();
        static_cast<void>(m_home->events());
        const Outcome counted = m_home->burin(scene.words, {.under = m_stage->folder()});
        QVERIFY2(counted.status == 0, qPrintable(counted.complaint));
        int calls = 0;
        std::vector<int> renames;
        for (const test::FileEvent& event : m_home->events()) {
            if (event.what != "counts")
                continue;
            ++calls;
            if (event.more == QLatin1String("rename"))
                renames.push_back(calls);
        }
        QVERIFY2(calls > 0, scene.name);
        qInfo("%-22s %4d calls, %d ms", scene.name, calls, scene.milliseconds);
        m_calls.push_back(calls);
        m_renames.push_back(std::move(renames));
    }
}

void FailingDiskGlTest::sessionsAndExports_data()
{
    QTest::addColumn<int>("scene");
    QTest::addColumn<int>("call");
    QTest::addColumn<int>("error");
    QTest::addColumn<bool>("lasting");
    const auto add = [this](std::size_t scene, int call, int error, bool lasting) {
        QTest::addRow("%s, call %d of %d: %s%s", m_stage->scenes()[scene].name, call,
            m_calls[scene], qPrintable(nameOf(error)), lasting ? ", from then on" : "")
            << int(scene) << call << error << lasting;
    };
    if (test::longRun()) {
        for (std::size_t scene = 0; scene < m_calls.size(); ++scene) {
            for (int call = 1; call <= m_calls[scene]; ++call) {
                for (const int error : errors)
                    add(scene, call, error, false);
                add(scene, call, errors[std::size_t(call) % errors.size()], true);
            }
        }
        return;
    }
    // Where a new file is to take its place (run --force), and the disk is gone for good.
    for (const int rename : m_renames.front())
        add(0, rename, EDQUOT, true);
    test::Random random(m_seed);
    constexpr int strokes = 18;
    for (int i = 0; i < strokes; ++i) {
        // The first three write most of what there is.
        const auto scene = std::size_t(i % 2 == 0 ? i / 2 % 3 : i / 2 % int(m_calls.size()));
        add(scene, test::randomInt(random, 1, m_calls[scene]),
            errors[std::size_t(test::randomInt(random, 0, int(errors.size()) - 1))],
            test::randomInt(random, 0, 1) == 1);
    }
}

void FailingDiskGlTest::sessionsAndExports()
{
    QFETCH(int, scene);
    QFETCH(int, call);
    QFETCH(int, error);
    QFETCH(bool, lasting);
    const test::StormStage::Scene& struck = m_stage->scenes()[std::size_t(scene)];
    m_stage->restore();
    static_cast<void>(m_home->events());
    const Outcome outcome = m_home->burin(struck.words,
        {.under = m_stage->folder(),
            .first = call,
            .last = lasting ? 1 << 30 : call,
            .error = error});
    QStringList failed;
    for (const test::FileEvent& event : m_home->events()) {
        if (event.what == "fails")
            failed += event.more + QLatin1Char(' ') + event.path;
    }
    m_faults += failed.isEmpty() ? 0 : 1;
    QStringList wrong = m_stage->wrongs(struck, outcome, false);
    if (outcome.status != 0) {
        ++m_told;
        // What half a write ends in is nobody's failure.
        if (error == 0 && !failed.isEmpty())
            wrong += QStringLiteral("part of a write is no reason to fail");
        bool named = false;
        for (const QString& target : struck.targets)
            named = named || outcome.complaint.contains(target);
        bool reasoned = false;
        for (const QString& reason : {nameOf(error), QStringLiteral("database or disk is full"),
                 QStringLiteral("unable to open database file"),
                 QStringLiteral("could not be closed as one file"),
                 QStringLiteral("it was not closed")})
            reasoned = reasoned || outcome.complaint.contains(reason);
        if (!named)
            wrong += QStringLiteral("it does not say which file");
        if (!reasoned)
            wrong += QStringLiteral("it does not say why");
    }
    if (wrong.isEmpty() && (test::longRun() ? call % 10 == 0 : outcome.status != 0))
        wrong += m_stage->wrongsOfSessions(struck);
    QVERIFY2(wrong.isEmpty(),
        qPrintable(QStringLiteral("\n  wrong: %1\n  failed: %2\n  status: %3\n  said: %4")
                       .arg(wrong.join(QStringLiteral("\n         ")),
                           failed.mid(0, 3).join(QStringLiteral("\n          ")))
                       .arg(outcome.status)
                       .arg(outcome.complaint)));
}

/// A working session that is damaged gives its name to what was sound of it. Where one of the files
/// that lie there cannot be renamed, the damaged one stays what and where it was.
void FailingDiskGlTest::aDamagedWorkingSession()
{
    const QString folder = m_home->path(QStringLiteral("state/burin/sessions"));
    const QString file = folder + QStringLiteral("/w.burin");
    m_stage->restore();
    QVERIFY(QDir().mkpath(folder));
    const QStringList words{QStringLiteral("run"), m_home->path(QStringLiteral("more.json")),
        QStringLiteral("--session"), file, QStringLiteral("--append"), QStringLiteral("--study"),
        m_home->path(QStringLiteral("ct"))};
    const auto damage = [&] {
        const QString whole = m_stage->folder() + QStringLiteral("/a.burin");
        for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden))
            QFile::remove(QDir(folder).filePath(name));
        for (const QString& name : {QStringLiteral("z.csv"), QStringLiteral("z.obj")})
            QFile::remove(QDir(m_stage->folder()).filePath(name));
        QVERIFY(QFile::copy(whole, file));
        QVERIFY(test::runSql(file, QStringLiteral("UPDATE row SET name='X' WHERE id=5")));
        // As a program leaves it that is killed.
        QFile beside(file + QStringLiteral("-wal"));
        QVERIFY(beside.open(QIODevice::WriteOnly));
        static_cast<void>(m_home->events());
    };
    for (int call = 1; call <= 8; ++call) {
        damage();
        const QByteArray before = test::bytesOf(file);
        const Outcome outcome = m_home->burin(
            words, {.under = folder, .calls = "rename", .first = call, .last = call, .error = EIO});
        QStringList failed;
        for (const test::FileEvent& event : m_home->events()) {
            if (event.what == "fails")
                failed += event.path;
        }
        // Those that come later are of the session that goes on.
        if (failed.isEmpty()) {
            QVERIFY2(call > 3, "fewer files are renamed than there are");
            return;
        }
        QVERIFY2(outcome.status == 1, qPrintable(failed.join(u' ') + outcome.complaint));
        QVERIFY2(outcome.complaint.contains(file), qPrintable(outcome.complaint));
        QVERIFY2(outcome.complaint.contains(nameOf(EIO)), qPrintable(outcome.complaint));
        QVERIFY2(test::bytesOf(file) == before, qPrintable(failed.join(u' ')));
        QStringList left = QDir(folder).entryList(QDir::Files | QDir::Hidden);
        left.removeAll(QStringLiteral("w.burin"));
        left.removeAll(QStringLiteral("w.burin-wal"));
        QVERIFY2(left.isEmpty(), qPrintable(left.join(u' ')));
    }
}

void FailingDiskGlTest::cleanupTestCase()
{
    qInfo("%d faults, %d of them ended the command", m_faults, m_told);
}

BURIN_TEST(FailingDiskGlTest)

} // namespace failingDiskGlTest

#include "FailingDiskGlTest.moc"
