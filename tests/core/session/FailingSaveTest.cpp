// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionImages.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMap>
#include <QProcess>
#include <QTest>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <future>

namespace failingSaveTest {

using namespace core;
using test::FileEvent;

namespace {

constexpr const char* savedFrom = "BURIN_SAVED_FROM";
constexpr const char* savedTo = "BURIN_SAVED_TO";
/// A copy of the session as it is in the end, on a disk that is in order.
constexpr const char* savedCopy = "BURIN_SAVED_COPY";
/// The study's series, which goes into the session; unset: the small study, and no images.
constexpr const char* savedImages = "BURIN_SAVED_IMAGES";
/// Set: the disk comes to itself, and it is tried until it is saved.
constexpr const char* savedAgain = "BURIN_SAVED_AGAIN";

void tell(const char* what, const QString& more)
{
    std::printf("TOLD %s %s\n", what, qUtf8Printable(more));
    std::fflush(stdout);
}

LoadedVolume studyOf(const QString& series)
{
    return series.isEmpty() ? test::smallStudy() : test::openVolume(series);
}

QString textOf(const Error& error)
{
    return error.arguments.join(u' ').simplified();
}

} // namespace

/// What works on the disk that fails: a session with a step, which is saved under another name, and
/// one step more. It tells on stdout what it was told.
class SessionOnFailingDisk : public QObject {
    Q_OBJECT

    LoadedVolume m_study;
    std::unique_ptr<EditSession> m_session;

    /// Everything that is on disk by now.
    void tellRows() const
    {
        const Result<void> settled = m_session->settle();
        if (!settled)
            return tell("waits", textOf(settled.error()));
        for (const HistoryRow& row : m_session->history().rows())
            tell("row", QString::number(row.id) + u' ' + QString::fromLatin1(row.stateHash));
    }
    [[nodiscard]] Result<void> saved(const QString& target) const
    {
        SavedImages images;
        if (qEnvironmentVariableIsSet(savedImages)) {
            auto staged = stageImages(target, true, m_study, {});
            if (!staged)
                return tl::unexpected(staged.error());
            images.staged = std::make_shared<StagedFile>(*std::move(staged));
        }
        std::promise<Result<void>> promise;
        m_session->storage().saveAs(
            target, true, [&promise](const Result<void>& result) { promise.set_value(result); },
            std::move(images));
        return promise.get_future().get();
    }
    [[nodiscard]] Result<void> copied(const QString& target) const
    {
        std::promise<Result<void>> promise;
        m_session->storage().copyTo(
            target, [&promise](const Result<void>& result) { promise.set_value(result); });
        return promise.get_future().get();
    }

private Q_SLOTS:
    void savesAndGoesOn()
    {
        const QString from = qEnvironmentVariable(savedFrom);
        const QString target = qEnvironmentVariable(savedTo);
        if (target.isEmpty())
            QSKIP("FailingSaveTest starts it");
        m_study = studyOf(qEnvironmentVariable(savedImages));
        reference::ReferenceEngine engine;
        auto opened = QFileInfo::exists(from)
            ? EditSession::open(engine, m_study, from)
            : EditSession::create(engine, m_study, {.file = from, .beginWithoutFile = true});
        if (!opened)
            return tell("refused", textOf(opened.error()));
        m_session = *std::move(opened);
        m_session->setErrorListener([](const Error&) {});
        QVERIFY(m_session->apply(test::drillAt(3)));
        tellRows();
        tell("saving", target);
        if (const Result<void> done = saved(target); done)
            tell("saved", m_session->file());
        else
            tell("refused", textOf(done.error()));
        QVERIFY(m_session->apply(test::drillAt(5)));
        tellRows();
        constexpr int tries = 20;
        bool isSaved = !qEnvironmentVariableIsSet(savedAgain);
        for (int i = 0; i < tries && !isSaved; ++i) {
            const Result<void> done = saved(target);
            isSaved = done.has_value();
            tell(isSaved ? "again" : "refused again", isSaved ? target : textOf(done.error()));
        }
        if (qEnvironmentVariableIsSet(savedAgain)) {
            QVERIFY(m_session->apply(test::drillAt(-5)));
            tellRows();
        }
        tell("file", m_session->file());
        if (const Result<void> done = copied(qEnvironmentVariable(savedCopy)); done)
            tell("copied", {});
        else
            tell("uncopied", textOf(done.error()));
        m_session.reset();
        tell("closed", {});
    }
};

/// "Save session as" on a disk that fails: the n-th call that opens a file for writing, writes,
/// synchronises or renames fails, once, for a while or from then on, or writes a part only.
/// Afterwards the session is where it is said to be, whole, with every step that was on disk; where
/// saving was refused the file that was to be replaced is the old one, or there is none; who was
/// refused was told the file and why; nothing is left over. When the disk has come to itself all
/// steps are saved.
///
/// BURIN_LONG: every call with each of the four errors once, and with one of them for a while and
/// from then on.
class FailingSaveTest : public QObject {
    Q_OBJECT

    struct Way {
        const char* name = "";
        bool fromFile = true; ///< else all steps wait in memory
        bool overItself = false;
        bool overAnother = false;
        bool withImages = false;
        int calls = 0; ///< of an undisturbed one
        std::vector<int> renames; ///< which of them these are
    };
    /// How many calls fail.
    enum class Lasting { Once, AWhile, FromThenOn };
    struct Told {
        int status = -1;
        QByteArray output;
        QString refused; ///< empty: it was not
        QString again; ///< why it was refused later, too; empty: it was not
        QString file; ///< where the session was in the end
        QString uncopied; ///< why it was not copied then; empty: it was
        bool saved = false;
        bool savedAgain = false;
        bool waits = false; ///< the last step was not written
        bool closed = false;
        bool copied = false;
        QMap<RowId, QString> rows; ///< their hashes
        RowId before = 0; ///< the last row that was told of before it was saved
    };

    test::WatchedHome m_home;
    std::vector<Way> m_ways;
    int m_faults = 0;
    int m_refused = 0;

    [[nodiscard]] QString folder() const { return m_home.path(QStringLiteral("as")); }
    [[nodiscard]] QString source(const Way& way) const
    {
        return way.overItself ? target()
            : way.fromFile    ? m_home.path(QStringLiteral("in/a.burin"))
                              : m_home.path(QStringLiteral("no/such/a.burin"));
    }
    [[nodiscard]] QString target() const { return folder() + QStringLiteral("/b.burin"); }
    [[nodiscard]] QString copy() const { return m_home.path(QStringLiteral("copy.burin")); }
    void prepare(const Way& way) const;
    [[nodiscard]] Told saved(const Way& way, const test::FileFault& fault, bool again) const;
    [[nodiscard]] static QString wrongOf(
        const QString& session, const QMap<RowId, QString>& rows, RowId to);
    [[nodiscard]] QString wrongOfRefusal(const QString& refused, int error) const;
    [[nodiscard]] QStringList wrongs(
        const Way& way, const Told& told, int error, Lasting lasting) const;

private Q_SLOTS:
    void initTestCase();
    void everyCall_data();
    void everyCall();
    void withoutExchange();
    void cleanupTestCase() { qInfo("%d faults, %d refused", m_faults, m_refused); }
};

namespace {

const std::array errors{EIO, ENOSPC, EDQUOT, 0};

QString nameOf(int error)
{
    return error == 0 ? QStringLiteral("short") : QString::fromLocal8Bit(std::strerror(error));
}

} // namespace

void FailingSaveTest::initTestCase()
{
    QVERIFY(QDir().mkpath(m_home.path(QStringLiteral("in"))));
    QVERIFY(!test::makeSession(m_home.path(QStringLiteral("pattern.burin"))).isEmpty());
    const QString series = m_home.path(QStringLiteral("ct"));
    test::writeSmallSeries(series, "2.25.32");
    for (const auto& [name, study] :
        {std::pair("other.burin", QString()), std::pair("of-series.burin", series)}) {
        reference::ReferenceEngine engine;
        const auto session = *EditSession::create(
            engine, studyOf(study), {.file = m_home.path(QLatin1String(name))});
        QVERIFY(session->apply(test::drillAt(-3)));
        QVERIFY(session->settle());
    }
    m_ways = {{.name = "to a new name"}, {.name = "over another one", .overAnother = true},
        {.name = "over itself", .overItself = true},
        {.name = "without a file so far", .fromFile = false},
        {.name = "with its images", .withImages = true},
        {.name = "with its images over itself", .overItself = true, .withImages = true}};
    for (Way& way : m_ways) {
        prepare(way);
        const Told told = saved(way, {.under = folder()}, false);
        QVERIFY2(told.status == 0 && told.saved && told.closed, told.output.constData());
        const QStringList wrong = wrongs(way, told, EIO, Lasting::Once);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
        for (const FileEvent& event : m_home.events()) {
            way.calls += event.what == "counts" ? 1 : 0;
            if (event.what == "counts" && event.more == QLatin1String("rename"))
                way.renames.push_back(way.calls);
        }
        QVERIFY(way.calls > 0);
        qInfo("%s: %d calls", way.name, way.calls);
    }
}

void FailingSaveTest::prepare(const Way& way) const
{
    const auto copied = [this](const char* from, const QString& to) {
        QFile::remove(to);
        if (!QFile::copy(m_home.path(QLatin1String(from)), to))
            qFatal("cannot copy %s", from);
    };
    if (!QDir(folder()).removeRecursively() || !QDir().mkpath(folder()))
        qFatal("the folder cannot be emptied");
    if (way.fromFile)
        copied(way.withImages ? "of-series.burin" : "pattern.burin", source(way));
    if (way.overAnother)
        copied("other.burin", target());
    QFile::remove(copy());
    static_cast<void>(m_home.events());
}

FailingSaveTest::Told FailingSaveTest::saved(
    const Way& way, const test::FileFault& fault, bool again) const
{
    QProcess process;
    QProcessEnvironment environment = m_home.environment(fault);
    environment.insert(QLatin1String(savedFrom), source(way));
    environment.insert(QLatin1String(savedTo), target());
    environment.insert(QLatin1String(savedCopy), copy());
    if (way.withImages)
        environment.insert(QLatin1String(savedImages), m_home.path(QStringLiteral("ct")));
    if (again)
        environment.insert(QLatin1String(savedAgain), QStringLiteral("1"));
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QCoreApplication::applicationFilePath(),
        {QStringLiteral("SessionOnFailingDisk"), QStringLiteral("-maxwarnings"),
            QStringLiteral("0")});
    process.waitForFinished(300'000);
    Told told;
    told.status = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    told.output = process.readAll();
    for (const QByteArray& line : told.output.split('\n')) {
        const QString text = QString::fromUtf8(line);
        const QString what = text.section(u' ', 1, 1);
        const QString more = text.section(u' ', 2);
        if (!text.startsWith(QLatin1String("TOLD ")))
            continue;
        if (what == QLatin1String("row"))
            told.rows[more.section(u' ', 0, 0).toLongLong()] = more.section(u' ', 1);
        else if (what == QLatin1String("saving"))
            told.before = told.rows.isEmpty() ? 0 : told.rows.lastKey();
        else if (what == QLatin1String("refused") && !more.startsWith(QLatin1String("again ")))
            told.refused = more;
        else if (what == QLatin1String("refused"))
            told.again = more;
        else if (what == QLatin1String("file"))
            told.file = more;
        else if (what == QLatin1String("uncopied"))
            told.uncopied = more;
        told.saved = told.saved || what == QLatin1String("saved");
        told.savedAgain = told.savedAgain || what == QLatin1String("again");
        told.closed = told.closed || what == QLatin1String("closed");
        told.copied = told.copied || what == QLatin1String("copied");
        if (what == QLatin1String("row") || what == QLatin1String("waits"))
            told.waits = what == QLatin1String("waits");
    }
    return told;
}

/// What is wrong with a session that was told to have these rows.
QString FailingSaveTest::wrongOf(const QString& session, const QMap<RowId, QString>& rows, RowId to)
{
    const QString name = QFileInfo(session).fileName() + QStringLiteral(": ");
    const auto contents = checkSession(session);
    if (!contents)
        return name + textOf(contents.error());
    if (!contents->isWhole())
        return name + QStringLiteral("it is not whole");
    for (auto row = rows.begin(); row != rows.end() && row.key() <= to; ++row) {
        if (row.key() > RowId(contents->rows.size()))
            return name + QStringLiteral("row %1 is not there").arg(row.key());
        if (QString::fromLatin1(contents->rows[std::size_t(row.key() - 1)].stateHash)
            != row.value())
            return name + QStringLiteral("row %1 is not what was told").arg(row.key());
    }
    return {};
}

QString FailingSaveTest::wrongOfRefusal(const QString& refused, int error) const
{
    // What half a write ends in is nobody's failure.
    if (error == 0)
        return QStringLiteral("part of a write is no reason to fail");
    if (!refused.contains(target()))
        return QStringLiteral("it does not say which file");
    for (const QString& reason : {nameOf(error), QStringLiteral("database or disk is full"),
             QStringLiteral("unable to open database file"),
             QStringLiteral("could not be closed as one file")}) {
        if (refused.contains(reason))
            return {};
    }
    return QStringLiteral("it does not say why");
}

QStringList FailingSaveTest::wrongs(
    const Way& way, const Told& told, int error, Lasting lasting) const
{
    QStringList wrong;
    if (told.status != 0)
        return {QStringLiteral("it did not come to its end")};
    const bool again = lasting == Lasting::AWhile;
    if (told.saved == !told.refused.isEmpty())
        wrong += QStringLiteral("it was told neither that it is saved nor that it is not");
    // One that did not even open has none.
    const bool isOpen = !told.file.isEmpty();
    const QString place = told.saved || told.savedAgain ? target() : source(way);
    if (isOpen && told.file != place)
        wrong += QStringLiteral("it goes on elsewhere: ") + told.file;
    if (isOpen && again && (!told.savedAgain || told.waits))
        wrong += QStringLiteral("it is not saved, and the disk is in order again");
    for (const QString& refused : {told.refused, told.again}) {
        if (!refused.isEmpty())
            wrong += wrongOfRefusal(refused, error);
    }
    // Which its folder does not let have its name again, if it is told where it is.
    const QString left = told.refused.section(QLatin1String("is in '"), 1).section(u'\'', 0, 0);
    const QString old = left.isEmpty() ? target() : QDir(folder()).filePath(left);
    if (!told.saved && !told.savedAgain) {
        if (way.overAnother
            && test::bytesOf(old) != test::bytesOf(m_home.path(QStringLiteral("other.burin"))))
            wrong += QStringLiteral("what was to be replaced is not as it was");
        if (!way.overAnother && !way.overItself && QFile::exists(target()))
            wrong += QStringLiteral("it was not saved, and a file is there");
    }
    const RowId last = told.rows.isEmpty() ? 0 : told.rows.lastKey();
    // A copy has all steps, or there is none and it is told why.
    if (told.copied)
        wrong += wrongOf(copy(), told.rows, last);
    else if (isOpen && (told.uncopied.isEmpty() || QFile::exists(copy())))
        wrong += QStringLiteral("it was not copied: ") + told.uncopied;
    if (told.saved || told.savedAgain || way.overItself)
        wrong += wrongOf(target(), told.rows, last);
    if (way.fromFile && !way.overItself)
        wrong +=
            wrongOf(source(way), told.rows, told.saved || told.savedAgain ? told.before : last);
    wrong.removeAll(QString());
    QStringList there = QDir(folder()).entryList(
        QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    there.removeAll(QFileInfo(target()).fileName());
    there.removeAll(left);
    // A session whose disk is still not in order as it is closed keeps what belongs to it.
    if (lasting != Lasting::AWhile && (way.overItself || told.saved)) {
        for (const char* part : {"b.burin-wal", "b.burin-shm", "b.burin-journal"})
            there.removeAll(QLatin1String(part));
    }
    if (!there.isEmpty())
        wrong += QStringLiteral("left over: ") + there.join(u' ');
    return wrong;
}

void FailingSaveTest::everyCall_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<int>("call");
    QTest::addColumn<int>("error");
    QTest::addColumn<int>("lasting");
    const auto add = [this](std::size_t way, int call, int error, Lasting lasting) {
        const char* words = lasting == Lasting::Once ? ""
            : lasting == Lasting::AWhile             ? ", for a while"
                                                     : ", from then on";
        QTest::addRow("%s, call %d of %d: %s%s", m_ways[way].name, call, m_ways[way].calls,
            qPrintable(nameOf(error)), words)
            << int(way) << call << error << int(lasting);
    };
    for (std::size_t way = 0; way < m_ways.size(); ++way) {
        for (int call = 1; call <= m_ways[way].calls; ++call) {
            const int turn = call + int(way);
            const int error = errors[std::size_t(turn) % errors.size()];
            // Around the moment in which the file gets its name most can be lost.
            const bool isClose = std::any_of(m_ways[way].renames.begin(), m_ways[way].renames.end(),
                [call](int rename) { return call >= rename - 1 && call <= rename + 4; });
            if (test::longRun()) {
                for (const int each : errors)
                    add(way, call, each, Lasting::Once);
                add(way, call, error, Lasting::AWhile);
                add(way, call, error, Lasting::FromThenOn);
            } else if (isClose || turn % 16 == 0) {
                add(way, call, error == 0 ? EIO : error, Lasting((turn + turn / 16) % 3));
            }
        }
    }
}

void FailingSaveTest::everyCall()
{
    QFETCH(int, way);
    QFETCH(int, call);
    QFETCH(int, error);
    QFETCH(int, lasting);
    constexpr int whileCalls = 12;
    const Way& struck = m_ways[std::size_t(way)];
    const auto how = Lasting(lasting);
    prepare(struck);
    const int last = how == Lasting::Once ? call
        : how == Lasting::AWhile          ? call + whileCalls
                                          : 1 << 30;
    // A full disk has often room for a name.
    const bool opens = how != Lasting::FromThenOn || call % 2 == 0;
    const Told told = saved(struck,
        {.under = folder(),
            .calls = opens ? "open,write,sync,rename" : "write,sync,rename",
            .first = call,
            .last = last,
            .error = error},
        how == Lasting::AWhile);
    QStringList failed;
    for (const FileEvent& event : m_home.events()) {
        if (event.what == "fails")
            failed += event.more + u' ' + event.path;
    }
    m_faults += failed.isEmpty() ? 0 : 1;
    m_refused += told.refused.isEmpty() ? 0 : 1;
    QStringList wrong = wrongs(struck, told, error, how);
    if (how != Lasting::FromThenOn || !opens) {
        for (const QString& session : {source(struck), target()}) {
            const SessionLoss loss = sessionLoss(session);
            if (!loss.leftOpen.isEmpty())
                wrong += QFileInfo(session).fileName() + QStringLiteral(": ") + loss.leftOpen;
        }
    }
    QStringList said;
    for (const QByteArray& line : told.output.split('\n')) {
        if (line.startsWith("TOLD") && !line.startsWith("TOLD row"))
            said += QString::fromUtf8(line);
    }
    QVERIFY2(wrong.isEmpty(),
        qPrintable(QStringLiteral("\n  wrong: %1\n  failed: %2\n  said: %3")
                       .arg(wrong.join(QStringLiteral("\n         ")),
                           failed.mid(0, 3).join(QStringLiteral("\n          ")),
                           said.join(QStringLiteral("\n        ")))));
}

/// On file systems that cannot exchange two names, and know no rename that replaces nothing: the
/// name that was there leads to a file all the while, whoever pulls the plug.
void FailingSaveTest::withoutExchange()
{
    for (const Way& way : m_ways) {
        if (!way.fromFile)
            continue;
        prepare(way);
        const int rename = way.renames.front();
        const Told told = saved(
            way, {.under = folder(), .first = rename, .last = rename, .error = EINVAL}, false);
        QVERIFY2(told.saved && told.closed, told.output.constData());
        const QStringList wrong = wrongs(way, told, EINVAL, Lasting::Once);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
        int links = 0;
        for (const FileEvent& event : m_home.events()) {
            links += event.what == "link" ? 1 : 0;
            QVERIFY2(event.what != "rename" || event.path != target(), way.name);
        }
        QVERIFY2(links == 1, way.name);
    }
}

BURIN_TEST(SessionOnFailingDisk)
BURIN_TEST(FailingSaveTest)

} // namespace failingSaveTest

#include "FailingSaveTest.moc"
