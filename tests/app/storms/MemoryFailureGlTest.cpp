// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/pacs/retrieve/DownloadFolder.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>

#include <algorithm>
#include <set>

namespace memoryFailureGlTest {

using test::key;
using test::Outcome;

namespace {

/// smallStudy() with more air around, so that its labels take more than 64 KiB, too.
core::LoadedVolume airyStudy()
{
    core::LoadedVolume loaded = test::smallStudy();
    core::VolumeGeometry& geometry = loaded.volume.geometry;
    const core::VolumeGeometry small = geometry;
    const std::vector<std::uint16_t> inner = std::move(loaded.codes);
    const glm::ivec3 around(12, 12, 11);
    geometry.size = small.size + 2 * around;
    geometry.indexToWorld[3] = glm::dvec4(small.toWorld(-glm::dvec3(around)), 1.0);
    loaded.codes.assign(geometry.voxelCount(), 24);
    for (int k = 0; k < small.size.z; ++k)
        for (int j = 0; j < small.size.y; ++j)
            for (int i = 0; i < small.size.x; ++i) {
                const glm::ivec3 at = glm::ivec3(i, j, k) + around;
                loaded.codes[std::size_t(
                    at.x + geometry.size.x * (at.y + std::int64_t(geometry.size.y) * at.z))] =
                    inner[std::size_t(i + small.size.x * (j + std::int64_t(small.size.y) * k))];
            }
    return loaded;
}

QJsonArray script(const core::VolumeGeometry& geometry)
{
    const glm::dvec3 corner = geometry.toWorld({1, 1, 1});
    const glm::dvec3 middle = geometry.toWorld(glm::dvec3(geometry.size) / 2.0);
    QJsonArray steps = test::toJson({test::addSegment("Brain"), test::seedInBrain(1),
        test::growBrain(), test::addSegment("Air"), test::seedAt(2, {corner}),
        test::growBetween(-2000, -500), core::ShrinkSteps{.steps = 6}, test::drillAt(-6),
        test::paintOverAt(1, {middle, middle + glm::dvec3(4, 3, 2)}, 6.0)});
    for (const char* move : {"undo", "undo", "redo"})
        steps.append(QJsonObject{{key("edit"), key(move)}});
    return steps;
}

const QStringList exported{
    QStringLiteral("o.nii.gz"), QStringLiteral("o.seg.nrrd"), QStringLiteral("o.stl")};

/// What a line of `burin run` promises.
QString promise(const QJsonObject& line)
{
    if (line.contains(key("export")))
        return QString();
    return line[key("edit")].toString() + u' ' + line[key("row")].toVariant().toString() + u' '
        + line[key("hash")].toString();
}

QStringList promises(const Outcome& outcome)
{
    QStringList all;
    for (const QJsonObject& line : outcome.lines)
        if (const QString one = promise(line); !one.isEmpty())
            all += one;
    return all;
}

} // namespace

/// Memory, or a file handle, is refused while a session is worked in, at any place: the step is
/// refused and everything is as it was, or the program ends in one sentence; what is in the session
/// is whole either way.
class MemoryFailureGlTest : public QObject, test::CommandFixture {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void largeOnesOfOurs_data();
    void largeOnesOfOurs();
    void anyOnes_data();
    void anyOnes();
    void noneFromThenOn_data();
    void noneFromThenOn();
    void noneForLibrariesFromThenOn_data();
    void noneForLibrariesFromThenOn();
    void littleAddressSpace_data();
    void littleAddressSpace();
    void fewHandles_data();
    void fewHandles();
    void slicesAreNotAllOpenAtOnce();
    void aReportAndItsMask_data();
    void aReportAndItsMask();

private:
    /// Whose allocations are counted, and refused.
    enum class Whose {
        Anybodys,
        Ours, ///< that the program's own code asks for by operator new
        Libraries, ///< that another library's code asks for by operator new
    };
    [[nodiscard]] test::Surroundings refusing(
        long which, long least, Whose whose, bool onAndOn = false) const;
    [[nodiscard]] Outcome carryOut(const test::Surroundings& around) const;
    [[nodiscard]] long countOf(long least, Whose whose);
    void checkWhole(const Outcome& outcome, bool replayed);
    /// A session on a series, with its report, in a folder that no row empties.
    void prepareReport();
    [[nodiscard]] Outcome reportAnew(const test::Surroundings& around) const;

    QTemporaryDir m_reported;
    QString m_airy;
    QJsonArray m_steps;
    QStringList m_promised; ///< of an undisturbed run
    QStringList m_hashes;
    QList<QByteArray> m_exported;
    std::map<std::pair<long, Whose>, long> m_counts;
};

test::Surroundings MemoryFailureGlTest::refusing(
    long which, long least, Whose whose, bool onAndOn) const
{
    test::Surroundings around;
    around.variables = {{key("LD_PRELOAD"), key(BURIN_REFUSED_MEMORY)},
        {key("BURIN_REFUSE_NTH"), QString::number(which)},
        {key("BURIN_REFUSE_LEAST"), QString::number(least)},
        {key("BURIN_REFUSE_OURS"), whose == Whose::Ours ? key("1") : key("0")},
        {key("BURIN_REFUSE_LIBRARIES"), whose == Whose::Libraries ? key("1") : key("0")},
        {key("BURIN_REFUSE_ON"), onAndOn ? key("1") : key("0")},
        {key("BURIN_REFUSE_REPORT"), path("count.txt")}};
    return around;
}

Outcome MemoryFailureGlTest::carryOut(const test::Surroundings& around) const
{
    QJsonArray exports;
    const QStringList formats{key("nifti"), key("seg-nrrd"), key("stl")};
    for (qsizetype i = 0; i < formats.size(); ++i)
        exports.append(
            QJsonObject{{key("format"), formats[i]}, {key("file"), path(qPrintable(exported[i]))}});
    const QString words = recipe("r.json", {{key("edits"), m_steps}, {key("export"), exports}});
    return test::burin(
        {key("run"), words, key("--study"), m_airy, key("--session"), path("s.burin")}, around);
}

/// How many allocations an undisturbed run makes.
long MemoryFailureGlTest::countOf(long least, Whose whose)
{
    long& count = m_counts[{least, whose}];
    if (count > 0)
        return count;
    makeFolder();
    const Outcome outcome = carryOut(refusing(0, least, whose));
    count = outcome.status == 0 ? test::bytesOf(path("count.txt")).trimmed().toLong() : 0;
    return count;
}

void MemoryFailureGlTest::initTestCase()
{
    const core::LoadedVolume airy = airyStudy();
    m_airy = otherStudy("airy.nii.gz", airy);
    QVERIFY(!m_airy.isEmpty());
    m_steps = script(airy.volume.geometry);
    makeFolder();
    const Outcome outcome = carryOut({});
    QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
    m_promised = promises(outcome);
    QCOMPARE(m_promised.size(), m_steps.size());
    m_hashes = hashes("s.burin");
    QVERIFY(m_hashes.size() >= 8);
    for (const QString& name : exported)
        m_exported += test::bytesOf(path(qPrintable(name)));
    QVERIFY(!m_exported.contains(QByteArray()));
}

void MemoryFailureGlTest::init()
{
    test::failOnUnexpectedMessages();
    makeFolder();
}

/// A run that was disturbed: what it promised and what its session holds is what an undisturbed run
/// does, as far as it came, and nothing else lies there.
void MemoryFailureGlTest::checkWhole(const Outcome& outcome, bool replayed)
{
    QVERIFY2(outcome.status != test::Outcome::hung, qPrintable(outcome.complaint));
    const QStringList promised = promises(outcome);
    QCOMPARE(promised, m_promised.first(std::min(promised.size(), m_promised.size())));
    QVERIFY2(
        outcome.status != 0 || promised.size() == m_promised.size(), qPrintable(outcome.complaint));
    QVERIFY(outcome.status == 0 || !outcome.complaint.isEmpty());
    // A program that ended at once may have left a file in which nothing stands yet.
    const bool isBegun = QFileInfo(path("s.burin")).size() > 0
        || (QFile::exists(path("s.burin")) && (outcome.status == 0 || outcome.status == 1));
    if (isBegun) {
        QStringList there = hashes("s.burin");
        // A row that was told and not carried out to its end is so when it is opened next.
        if (!there.isEmpty() && there.last().isEmpty())
            there.removeLast();
        QVERIFY2(there == m_hashes.first(std::min(there.size(), m_hashes.size())),
            qPrintable(there.join(u' ')));
        std::set<QString> rows;
        for (const QString& one : promised)
            rows.insert(one.section(u' ', 1, 1));
        rows.erase(QString());
        rows.erase(key("0"));
        QVERIFY(std::size_t(there.size()) >= rows.size());
        if (replayed) {
            const Outcome again = test::burin({key("replay"), path("s.burin"), key("--verify")});
            QVERIFY2(again.status == 0,
                qPrintable(QStringLiteral("%1, after status %2: %3")
                               .arg(again.complaint)
                               .arg(outcome.status)
                               .arg(outcome.complaint)));
        }
    } else {
        QVERIFY(promised.isEmpty());
    }
    for (qsizetype i = 0; i < exported.size(); ++i) {
        const QString file = path(qPrintable(exported[i]));
        if (QFile::exists(file))
            QVERIFY2(test::bytesOf(file) == m_exported[i], qPrintable(exported[i]));
    }
    if (outcome.status == 0 || outcome.status == 1) {
        QStringList left = QDir(path("")).entryList(QDir::Files | QDir::Hidden);
        for (const QString& known : exported
                + QStringList{key("r.json"), key("count.txt"), key("s.burin"), key("s.burin-wal"),
                    key("s.burin-shm")})
            left.removeAll(known);
        QVERIFY2(left.isEmpty(), qPrintable(left.join(u' ')));
    }
}

namespace {

constexpr long large = 64 * 1024;

bool saysMemory(const Outcome& outcome)
{
    return outcome.status == 1 && outcome.complaint.contains(key("memory"));
}

/// Rows of so many of them, evenly spread; all in long runs if @p most is 0.
void spread(long count, int daily, int most)
{
    QTest::addColumn<qlonglong>("which");
    const long wanted = test::longRun() ? (most > 0 ? most : count) : daily;
    const long rows = std::min(count, wanted);
    for (long i = 0; i < rows; ++i) {
        const qlonglong which = 1 + i * count / rows;
        QTest::addRow("%lld of %ld", which, count) << which;
    }
}

} // namespace

void MemoryFailureGlTest::largeOnesOfOurs_data()
{
    spread(countOf(large, Whose::Ours), 14, 0);
}

void MemoryFailureGlTest::largeOnesOfOurs()
{
    QFETCH(qlonglong, which);
    const Outcome outcome = carryOut(refusing(which, large, Whose::Ours));
    checkWhole(outcome, test::longRun() || which % 4 == 1);
    // Refused, or had at a second try.
    QVERIFY2(outcome.status == 0 || saysMemory(outcome), qPrintable(outcome.complaint));
}

void MemoryFailureGlTest::anyOnes_data()
{
    spread(countOf(1, Whose::Anybodys), 6, 300);
}

void MemoryFailureGlTest::anyOnes()
{
    QFETCH(qlonglong, which);
    // A library that is refused may give another reason than memory.
    checkWhole(carryOut(refusing(which, 1, Whose::Anybodys)), test::longRun());
}

void MemoryFailureGlTest::noneFromThenOn_data()
{
    spread(countOf(large, Whose::Ours), 3, 40);
}

void MemoryFailureGlTest::noneFromThenOn()
{
    QFETCH(qlonglong, which);
    const Outcome outcome = carryOut(refusing(which, large, Whose::Ours, true));
    checkWhole(outcome, test::longRun());
    QVERIFY2(saysMemory(outcome), qPrintable(outcome.complaint));
}

void MemoryFailureGlTest::noneForLibrariesFromThenOn_data()
{
    // So many are asked for also where the driver has compiled everything earlier.
    constexpr long always = 30000;
    spread(std::min(always, countOf(1, Whose::Libraries)), 5, 60);
}

/// An exception that leaves the graphics driver leaves its locks taken: the program never ended.
void MemoryFailureGlTest::noneForLibrariesFromThenOn()
{
    QFETCH(qlonglong, which);
    const Outcome outcome = carryOut(refusing(which, 1, Whose::Libraries, true));
    checkWhole(outcome, test::longRun());
    QVERIFY2(outcome.status != 0 && outcome.complaint.contains(key("memory")),
        qPrintable(outcome.complaint));
}

void MemoryFailureGlTest::littleAddressSpace_data()
{
    QTest::addColumn<int>("megabytes");
    QList<int> limits{450, 900};
    if (test::longRun())
        limits = {200, 250, 300, 350, 400, 450, 500, 550, 600, 650, 700, 750, 800, 850, 900, 1000,
            1100, 1200, 1400, 1700, 2000, 2500};
    for (const int megabytes : limits)
        QTest::addRow("%d MB", megabytes) << megabytes;
}

/// As under `ulimit -v`: also what the drivers take fails.
void MemoryFailureGlTest::littleAddressSpace()
{
    QFETCH(int, megabytes);
    test::Surroundings around;
    around.addressSpaceBytes = std::size_t(megabytes) << 20;
    const Outcome outcome = carryOut(around);
    checkWhole(outcome, true);
    qInfo("%d MB: status %d %s", megabytes, outcome.status,
        qPrintable(outcome.complaint.trimmed().section(u'\n', -1)));
}

void MemoryFailureGlTest::fewHandles_data()
{
    QTest::addColumn<int>("handles");
    QList<int> limits{8, 16, 32};
    if (test::longRun())
        limits = {6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 18, 20, 22, 24, 28, 32, 40, 48, 64};
    for (const int handles : limits)
        QTest::addRow("%d handles", handles) << handles;
}

/// As under `ulimit -n`.
void MemoryFailureGlTest::fewHandles()
{
    QFETCH(int, handles);
    test::Surroundings around;
    around.openFiles = handles;
    const Outcome outcome = carryOut(around);
    checkWhole(outcome, test::longRun());
    qInfo("%d handles: status %d %s", handles, outcome.status,
        qPrintable(outcome.complaint.trimmed().section(u'\n', -1)));
}

/// A study of more files than may be open at once is read nonetheless.
void MemoryFailureGlTest::slicesAreNotAllOpenAtOnce()
{
    test::SyntheticSeries series;
    series.size = {8, 8, 200};
    QCOMPARE(test::writeSeries(series, path("ct")).size(), 200);
    test::Surroundings around;
    around.openFiles = 64;
    const Outcome outcome = test::burin(
        {key("run"), recipe("r.json", {{key("edits"), test::toJson({test::addSegment("Brain")})}}),
            key("--study"), path("ct"), key("--session"), path("s.burin")},
        around);
    QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
}

namespace {

/// A report, and the masks that it refers to.
const QStringList reportFiles{QStringLiteral("x.dcm"), QStringLiteral("x-seg.dcm")};

} // namespace

void MemoryFailureGlTest::prepareReport()
{
    if (QFile::exists(m_reported.filePath(reportFiles.last())))
        return;
    const test::SyntheticSeries series;
    QVERIFY(!test::writeSeries(series, m_reported.filePath(key("ct"))).isEmpty());
    QJsonArray steps = test::toJson({test::paintAt(1, {{4, 4, 55}}, 3.0)});
    steps.prepend(QJsonObject{{key("edit"), key("addSegment")}, {key("name"), key("Liver")},
        {key("color"), key("#336699")},
        {key("code"), QJsonArray{key("SCT"), key("10200004"), key("Liver")}}});
    const QJsonObject report{
        {key("format"), key("sr")}, {key("file"), m_reported.filePath(reportFiles.first())}};
    makeFolder();
    const Outcome made = test::burin(
        {key("run"), recipe("r.json", {{key("edits"), steps}, {key("export"), QJsonArray{report}}}),
            key("--study"), m_reported.filePath(key("ct")), key("--session"),
            m_reported.filePath(key("s.burin"))});
    QVERIFY2(made.status == 0, qPrintable(made.complaint));
}

/// Over the one that is there.
Outcome MemoryFailureGlTest::reportAnew(const test::Surroundings& around) const
{
    return test::burin({key("replay"), m_reported.filePath(key("s.burin")), key("--export"),
                           path("x.dcm"), key("--format"), key("sr"), key("--force")},
        around);
}

void MemoryFailureGlTest::aReportAndItsMask_data()
{
    QTest::addColumn<qlonglong>("which");
    QTest::addColumn<qlonglong>("least");
    prepareReport();
    if (QTest::currentTestFailed())
        return;
    for (const long least : {large, 1L}) {
        const Whose whose = least == large ? Whose::Ours : Whose::Anybodys;
        makeFolder();
        const Outcome counted = reportAnew(refusing(0, least, whose));
        QVERIFY2(counted.status == 0, qPrintable(counted.complaint));
        const long count = test::bytesOf(path("count.txt")).trimmed().toLong();
        QVERIFY(count > 0);
        // The report comes last, and there are most rows.
        const long rows = std::min(count, test::longRun() ? 150L : 7L);
        for (long i = 0; i < rows; ++i) {
            const qlonglong which = count - count * i * i / (rows * rows);
            QTest::addRow("%ld: %lld of %ld, from %ld bytes on", i, which, count, least)
                << which << qlonglong(least);
        }
    }
}

/// Both are those of before, or both are the new ones; that also where memory is refused once they
/// are in place, so that the program fails at what comes after.
void MemoryFailureGlTest::aReportAndItsMask()
{
    QFETCH(qlonglong, which);
    QFETCH(qlonglong, least);
    QList<QByteArray> before;
    for (const QString& name : reportFiles) {
        QVERIFY(QFile::copy(m_reported.filePath(name), path(qPrintable(name))));
        before += test::bytesOf(path(qPrintable(name)));
    }
    const bool isOurs = least == large;
    const Outcome outcome =
        reportAnew(refusing(long(which), long(least), isOurs ? Whose::Ours : Whose::Anybodys));
    QVERIFY2(outcome.status != test::Outcome::hung, qPrintable(outcome.complaint));
    QVERIFY2(!isOurs || outcome.status == 0 || saysMemory(outcome), qPrintable(outcome.complaint));
    QVERIFY(outcome.status == 0 || !outcome.complaint.isEmpty());
    int fresh = 0;
    for (qsizetype i = 0; i < reportFiles.size(); ++i) {
        const QString file = path(qPrintable(reportFiles[i]));
        const bool isFresh = test::bytesOf(file) != before[i];
        fresh += isFresh ? 1 : 0;
        QVERIFY2(!isFresh || core::soundObject(file), qPrintable(reportFiles[i]));
    }
    if (outcome.status != 0 && outcome.status != 1)
        return; // it ended at once
    QVERIFY(fresh == int(reportFiles.size()) || (fresh == 0 && outcome.status != 0));
    QStringList left = QDir(path("")).entryList(QDir::Files | QDir::Hidden);
    for (const QString& known : reportFiles + QStringList{key("count.txt")})
        left.removeAll(known);
    QVERIFY2(left.isEmpty(), qPrintable(left.join(u' ')));
}

BURIN_TEST(MemoryFailureGlTest)

} // namespace memoryFailureGlTest

#include "MemoryFailureGlTest.moc"
