// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/StormStage.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QDateTime>
#include <QTest>

#include <memory>

namespace killStormGlTest {

using test::Outcome;

/// A storm of SIGKILLs, at any instant of what writes sessions and exports. Afterwards sessions
/// open whole with every row that was told of, and exports are the old or the new ones, whole. What
/// was staged may lie there under its hidden name: nobody was left to remove it.
///
/// BURIN_SEED draws other instants, BURIN_KILLS another number.
class KillStormGlTest : public QObject {
    Q_OBJECT

    std::unique_ptr<test::WatchedHome> m_home;
    std::unique_ptr<test::StormStage> m_stage;
    std::uint32_t m_seed = 0;
    int m_kills = 0; ///< that came in time

private Q_SLOTS:
    void initTestCase();
    void anyInstant_data();
    void anyInstant();
    void cleanupTestCase();
};

void KillStormGlTest::initTestCase()
{
    m_home = std::make_unique<test::WatchedHome>();
    m_stage = std::make_unique<test::StormStage>(*m_home);
    m_seed = qEnvironmentVariableIsSet("BURIN_SEED")
        ? qEnvironmentVariable("BURIN_SEED").toUInt()
        : std::uint32_t(QDateTime::currentMSecsSinceEpoch());
    qInfo("BURIN_SEED=%u", m_seed);
}

void KillStormGlTest::anyInstant_data()
{
    QTest::addColumn<int>("scene");
    QTest::addColumn<int>("afterMs");
    const int usual = test::longRun() ? 350 : 12;
    const int kills = qEnvironmentVariableIsSet("BURIN_KILLS")
        ? qEnvironmentVariable("BURIN_KILLS").toInt()
        : usual;
    test::Random random(m_seed);
    const std::vector<test::StormStage::Scene>& scenes = m_stage->scenes();
    for (int i = 0; i < kills; ++i) {
        const int scene = i % 2 == 0 ? i / 2 % 3 : i / 2 % int(scenes.size());
        const int after = test::randomInt(random, 0, scenes[std::size_t(scene)].milliseconds);
        QTest::addRow("%d: %s after %d ms", i, scenes[std::size_t(scene)].name, after)
            << scene << after;
    }
}

void KillStormGlTest::anyInstant()
{
    QFETCH(int, scene);
    QFETCH(int, afterMs);
    const test::StormStage::Scene& struck = m_stage->scenes()[std::size_t(scene)];
    m_stage->restore();
    const Outcome outcome = test::burinKilled(struck.words, m_home->environment(), afterMs);
    const bool inTime = outcome.status < 0;
    m_kills += inTime ? 1 : 0;
    QStringList wrong = m_stage->wrongs(struck, outcome, inTime);
    if (wrong.isEmpty() && !outcome.lines.isEmpty())
        wrong += m_stage->wrongsOfSessions(struck);
    QVERIFY2(wrong.isEmpty(),
        qPrintable(wrong.join(QLatin1Char('\n')) + QLatin1Char('\n') + outcome.complaint));
}

void KillStormGlTest::cleanupTestCase()
{
    qInfo("%d of them were killed before they were done", m_kills);
}

BURIN_TEST(KillStormGlTest)

} // namespace killStormGlTest

#include "KillStormGlTest.moc"
