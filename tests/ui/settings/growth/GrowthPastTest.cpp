// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/growth/GrowthPast.h"

#include "core/session/EditSession.h"
#include "core/session/past/RecentGrowth.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/settings/growth/SeedValues.h"

#include <QTest>

#include <random>

namespace growthPastTest {

class GrowthPastTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Wherever the history goes, what is kept is what a walk through it finds.
    void isWhatTheHistorySays()
    {
        reference::ReferenceEngine engine;
        const auto session = *core::EditSession::create(engine, test::smallHead::volume(), {});
        ui::GrowthPast past;
        std::mt19937 random(7);
        const auto one = [&random](int most) { return int(random() % unsigned(most)); };
        int differing = 0;
        int seedsBefore = 0;
        for (const int label : {1, 2}) {
            QVERIFY(session->apply(test::newSegment(QString::number(label), 1)));
            QVERIFY(session->settle());
        }
        for (int step = 0; step < 120; ++step) {
            const int label = 1 + one(2);
            const double at = one(20) - 10.0;
            switch (one(7)) {
            case 0:
            case 1:
                static_cast<void>(session->apply(test::seedAt(label, {{at, 0.0, 0.0}})));
                break;
            case 2:
                static_cast<void>(session->apply(test::growBetween(at, 60.0, 1)));
                break;
            case 3:
                static_cast<void>(session->apply(test::lockSegment(label, one(2) == 0)));
                break;
            case 4:
                static_cast<void>(session->undo());
                break;
            case 5:
                static_cast<void>(session->redo());
                break;
            default:
                static_cast<void>(session->goTo(one(int(session->history().rows().size()) + 1)));
            }
            static_cast<void>(session->settle()); // what is refused is no matter here
            const core::History& history = session->history();
            for (int time = 0; time < 2; ++time) {
                const ui::GrowthPast::Known& known = past.of(*session, 0);
                QCOMPARE(known.seeds, ui::sketchedSeeds(*session, 0));
                QVERIFY(known.criteria == core::recentCriteria(history, 0));
                QVERIFY(known.growing == core::growingSegments(history, session->document(), 0));
            }
            differing += ui::sketchedSeeds(*session, 0) != seedsBefore ? 1 : 0;
            seedsBefore = ui::sketchedSeeds(*session, 0);
        }
        QVERIFY2(differing > 10, qPrintable(QString::number(differing)));
    }

    void anotherSessionIsAnotherPast()
    {
        ui::GrowthPast past;
        for (const int seeds : {2, 1}) {
            reference::ReferenceEngine engine;
            const auto session = *core::EditSession::create(engine, test::smallHead::volume(), {});
            QVERIFY(session->apply(test::newSegment(QStringLiteral("A"), 1)));
            std::vector<glm::dvec3> places;
            for (int i = 0; i < seeds; ++i)
                places.emplace_back(double(i), 0.0, 0.0);
            QVERIFY(session->apply(test::seedAt(1, places)));
            QVERIFY(session->settle());
            past.clear();
            QCOMPARE(past.of(*session, 0).seeds, seeds);
        }
    }
};

BURIN_TEST(GrowthPastTest)

} // namespace growthPastTest

#include "GrowthPastTest.moc"
