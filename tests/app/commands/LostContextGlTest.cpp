// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QDir>
#include <QFile>
#include <QTest>

namespace lostContextGlTest {

using test::key;
using test::Outcome;

namespace {

/// What the lines tell, but for how long it took and where files lie.
QStringList told(const Outcome& outcome)
{
    QStringList all;
    for (const QJsonObject& line : outcome.lines)
        all += line[key("edit")].toString() + u' ' + line[key("row")].toVariant().toString() + u' '
            + line[key("name")].toString() + u' ' + line[key("hash")].toString();
    return all;
}

} // namespace

/// The graphics driver loses its context while a command works: the context is made anew, and what
/// comes of it is the same as if nothing had been; or the reason is told.
class LostContextGlTest : public QObject, test::CommandFixture {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void aRecipeComesToTheSame_data();
    void aRecipeComesToTheSame();
    void aReplayComesToTheSame_data();
    void aReplayComesToTheSame();
    void endsWithTheReason();
    void aSessionGoesOn();
    void aSessionWithImagesIsBegunAnew();

private:
    [[nodiscard]] test::Surroundings losing(int nth, int every = 0, bool byStatus = false) const;
    [[nodiscard]] Outcome carryOut(const test::Surroundings& around) const;
    [[nodiscard]] Outcome replay(const test::Surroundings& around) const;
    /// How many looks for errors there were in the last run, and how many contexts were lost.
    [[nodiscard]] int looks() const
    {
        return test::bytesOf(path("count.txt")).split(' ').value(0).toInt();
    }
    [[nodiscard]] int lost() const
    {
        return test::bytesOf(path("count.txt")).trimmed().split(' ').value(1).toInt();
    }
    [[nodiscard]] static bool saysSo(const Outcome& outcome)
    {
        return outcome.complaint.contains(key("burin: the graphics driver broke off its work"));
    }
    static void instants(int count);

    int m_looks = 0; ///< of an undisturbed run
    QStringList m_told;
    QStringList m_hashes;
    QByteArray m_mask;
    QByteArray m_carved;
    QByteArray m_again; ///< by replay
    int m_replayLooks = 0;
    QStringList m_replayTold;
};

test::Surroundings LostContextGlTest::losing(int nth, int every, bool byStatus) const
{
    test::Surroundings around;
    around.variables = {{key("LD_PRELOAD"), key(BURIN_LOST_CONTEXT)},
        {key("BURIN_LOSE_NTH"), QString::number(nth)},
        {key("BURIN_LOSE_EVERY"), QString::number(every)},
        {key("BURIN_LOSE_STATUS"), byStatus ? key("1") : key("0")},
        {key("BURIN_LOSE_REPORT"), path("count.txt")}};
    return around;
}

Outcome LostContextGlTest::carryOut(const test::Surroundings& around) const
{
    QJsonArray steps = test::toJson(test::manyEdits());
    for (const QJsonValue& edit : test::toJson({test::drillAt(-3), test::drillAt(4)}))
        steps.append(edit);
    for (const char* move : {"undo", "undo", "redo"})
        steps.append(QJsonObject{{key("edit"), key(move)}});
    steps.append(test::goTo(5));
    steps.append(test::goTo(9));
    const QJsonArray exports{
        QJsonObject{{key("format"), key("nifti")}, {key("file"), path("mask.nii.gz")}},
        QJsonObject{{key("format"), key("coverage")}, {key("layer"), 1},
            {key("file"), path("carved.nii.gz")}}};
    const QString words = recipe("r.json", {{key("edits"), steps}, {key("export"), exports}});
    return test::burin(
        {key("run"), words, key("--study"), study(), key("--session"), path("s.burin")}, around);
}

Outcome LostContextGlTest::replay(const test::Surroundings& around) const
{
    return test::burin({key("replay"), path("s.burin"), key("--verify"), key("--to"), key("9"),
                           key("--export"), path("again.nii.gz")},
        around);
}

/// In the middle of each of so many parts of a run.
void LostContextGlTest::instants(int count)
{
    QTest::addColumn<int>("part");
    QTest::addColumn<int>("parts");
    QTest::addColumn<bool>("onAndOn");
    QTest::addColumn<bool>("byStatus");
    for (int part = 0; part < count; ++part)
        QTest::addRow("part %d of %d", part + 1, count)
            << part << count << false << (part % 2 == 1);
    QTest::addRow("again and again") << 1 << count << true << false;
}

void LostContextGlTest::initTestCase()
{
    QVERIFY(prepareStudy());
    makeFolder();
    const Outcome outcome = carryOut(losing(0));
    QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
    QVERIFY(!saysSo(outcome));
    m_looks = looks();
    QVERIFY(m_looks > 100);
    m_told = told(outcome);
    m_hashes = hashes("s.burin");
    m_mask = test::bytesOf(path("mask.nii.gz"));
    m_carved = test::bytesOf(path("carved.nii.gz"));
    QVERIFY(!m_mask.isEmpty() && !m_carved.isEmpty());
    const Outcome replayed = replay(losing(0));
    QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
    m_replayLooks = looks();
    m_replayTold = told(replayed);
    m_again = test::bytesOf(path("again.nii.gz"));
    QVERIFY(!m_again.isEmpty());
}

void LostContextGlTest::init()
{
    test::failOnUnexpectedMessages();
    makeFolder();
}

void LostContextGlTest::aRecipeComesToTheSame_data()
{
    instants(test::longRun() ? 120 : 6);
}

void LostContextGlTest::aRecipeComesToTheSame()
{
    QFETCH(int, part);
    QFETCH(int, parts);
    QFETCH(bool, onAndOn);
    QFETCH(bool, byStatus);
    const int first = (2 * part + 1) * m_looks / (2 * parts);
    const Outcome outcome = carryOut(losing(first, onAndOn ? m_looks / 3 : 0, byStatus));
    QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
    // How often is looked depends on how fast pictures are drawn.
    QVERIFY(looks() < first || (onAndOn ? lost() >= 1 : lost() == 1));
    qInfo("%d contexts lost in %d looks", lost(), looks());
    QCOMPARE(hashes("s.burin"), m_hashes);
    QCOMPARE(test::bytesOf(path("mask.nii.gz")), m_mask);
    QCOMPARE(test::bytesOf(path("carved.nii.gz")), m_carved);
    QCOMPARE(told(outcome), m_told);
    const Outcome verified = test::burin({key("replay"), path("s.burin"), key("--verify")});
    QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
}

void LostContextGlTest::aReplayComesToTheSame_data()
{
    instants(test::longRun() ? 60 : 3);
}

void LostContextGlTest::aReplayComesToTheSame()
{
    QFETCH(int, part);
    QFETCH(int, parts);
    QFETCH(bool, onAndOn);
    QFETCH(bool, byStatus);
    QCOMPARE(carryOut({}).status, 0);
    const int first = (2 * part + 1) * m_replayLooks / (2 * parts);
    // What is begun anew needs as many looks as a replay, and some more where it is slow.
    const Outcome outcome = replay(losing(first, onAndOn ? 2 * m_replayLooks : 0, byStatus));
    QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
    QVERIFY(looks() < first || lost() >= 1);
    QCOMPARE(told(outcome), m_replayTold);
    QCOMPARE(test::bytesOf(path("again.nii.gz")), m_again);
}

/// A processor that is reset each time: a few tries, then an end in words; what is done stays.
void LostContextGlTest::endsWithTheReason()
{
    const Outcome outcome = carryOut(losing(m_looks / 4, 3));
    QCOMPARE(outcome.status, 1);
    QVERIFY2(saysSo(outcome), qPrintable(outcome.complaint));
    const QString last = outcome.complaint.trimmed().section(u'\n', -1);
    QVERIFY2(last.contains(key("every step so far is in its session")), qPrintable(last));
    QVERIFY(lost() >= 3 && lost() <= 8);
    QVERIFY(!outcome.lines.isEmpty());
    QStringList there = hashes("s.burin");
    QVERIFY(!there.isEmpty());
    if (there.last().isEmpty())
        there.removeLast(); // told, and carried out again when it is opened next
    QCOMPARE(there, m_hashes.first(there.size()));
    const Outcome verified = test::burin({key("replay"), path("s.burin"), key("--verify")});
    QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
}

/// One that goes on, and one that replaces another.
void LostContextGlTest::aSessionGoesOn()
{
    QCOMPARE(carryOut({}).status, 0);
    const QString more = recipe("more.json", {{key("edits"), test::toJson({test::drillAt(1)})}});
    const auto appended = [&](const test::Surroundings& around) {
        return test::burin(
            {key("run"), more, key("--append"), key("--session"), path("s.burin")}, around);
    };
    QVERIFY(QFile::copy(path("s.burin"), path("copy.burin")));
    const Outcome calm = appended(losing(0));
    QVERIFY2(calm.status == 0, qPrintable(calm.complaint));
    const QString hash = lastHash("s.burin");
    const int count = looks();
    for (const int first : {count / 3, 2 * count / 3}) {
        QVERIFY(QFile::remove(path("s.burin")));
        QVERIFY(QFile::copy(path("copy.burin"), path("s.burin")));
        const Outcome outcome = appended(losing(first));
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QVERIFY(looks() < first || lost() == 1);
        QCOMPARE(lastHash("s.burin"), hash);
    }
    const Outcome replaced = test::burin({key("run"), more, key("--study"), study(), key("--force"),
                                             key("--session"), path("s.burin")},
        losing(count / 2));
    QVERIFY2(replaced.status == 0, qPrintable(replaced.complaint));
    QCOMPARE(history("s.burin")[key("commands")].toArray().size(), 1);
}

/// Its file is there before the volume is on the graphics processor.
void LostContextGlTest::aSessionWithImagesIsBegunAnew()
{
    const QString words = recipe("once.json", {{key("edits"), test::toJson({test::drillAt(1)})}});
    const auto carriedOut = [&](const test::Surroundings& around) {
        return test::burin({key("run"), words, key("--study"), study(), key("--session"),
                               path("i.burin"), key("--with-images")},
            around);
    };
    const Outcome calm = carriedOut(losing(0));
    QVERIFY2(calm.status == 0, qPrintable(calm.complaint));
    const QString hash = lastHash("i.burin");
    const int count = looks();
    constexpr int parts = 8;
    for (int part = 0; part < parts; ++part) {
        QVERIFY(QFile::remove(path("i.burin")));
        const int first = 1 + part * count / parts;
        const Outcome outcome = carriedOut(losing(first));
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QVERIFY(looks() < first || lost() == 1);
        QCOMPARE(lastHash("i.burin"), hash);
        QCOMPARE(QDir(path("")).entryList({key("*burin*")}, QDir::Files | QDir::Hidden),
            QStringList{key("i.burin")});
    }
}

BURIN_TEST(LostContextGlTest)

} // namespace lostContextGlTest

#include "LostContextGlTest.moc"
