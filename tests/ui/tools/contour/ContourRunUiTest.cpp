// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourRun.h"

#include "core/contour/ContourRule.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/Edit.h"
#include "tests/reference/filling/Contour.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <vector>

namespace contourRunUiTest {

namespace {

/// The small head with a segment, and a contour of its brain and ventricle from a bubble.
struct Fixture : test::WorkspaceFixture {
    Fixture()
        : run(workspace)
    {
        apply(test::newSegment(QStringLiteral("Organ")));
        run.setPace(1);
        // Answers come when they are asked for.
        QObject::connect(&poll, &QTimer::timeout, &run, [this] {
            if (workspace.session())
                session().poll();
        });
        poll.start(1);
    }
    /// 40 and 8 HU are in its interval, bone and air are not.
    [[nodiscard]] core::EvolveContour edit(int generations) const
    {
        return {.segment = 1,
            .lower = -30.0,
            .upper = 80.0,
            .softness = 10.0,
            .smoothness = 30,
            .bubbleLps = glm::dvec3(0.3, -0.2, 0.1),
            .bubbleMm = 2.0001,
            .generations = generations};
    }
    [[nodiscard]] bool isThere(int generation) const
    {
        return run.track() && run.track()->shown() == generation;
    }
    /// What is shown against the oracle, for the edit that would write it.
    [[nodiscard]] bool isAsExpected(const core::EvolveContour& wanted)
    {
        const core::LoadedVolume head = test::smallHead::volume();
        const std::vector<std::uint8_t> none(head.codes.size(), 0);
        const std::vector<bool> inside = reference::evolvedContour(wanted,
            core::contourRule(wanted, session().document()).value(), head, none,
            [](int) { return false; });
        // A state is worked out beside the window.
        if (!QTest::qWaitFor([this] { return run.isInSight(); }))
            return false;
        std::size_t place = 0;
        for (int z = 0; z < test::smallHead::side; ++z) {
            for (int y = 0; y < test::smallHead::side; ++y) {
                for (int x = 0; x < test::smallHead::side; ++x, ++place) {
                    if (run.state()->isInside({x, y, z}) != inside[place])
                        return false;
                }
            }
        }
        return true;
    }

    ui::ContourRun run;
    QTimer poll;
};

core::EvolveContour rounded(const core::EvolveContour& edit)
{
    return core::quantised(edit).get<core::EvolveContour>();
}

} // namespace

class ContourRunUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A generation that is not known yet is shown as soon as it is, and then stays.
    void oneMayGoAhead()
    {
        Fixture fixture;
        QVERIFY(!fixture.run.isOpen());
        fixture.run.goTo(3); // of nothing
        fixture.run.begin(fixture.edit(9));
        QVERIFY(fixture.run.isOpen() && fixture.run.isWorking() && fixture.run.isPlaying());
        QVERIFY(!fixture.run.track());
        fixture.run.goTo(7);
        QVERIFY(!fixture.run.isPlaying());
        QTRY_VERIFY(!fixture.run.isWorking());
        QVERIFY(fixture.isThere(7));
        QCOMPARE(fixture.run.track()->known(), 9);
        QVERIFY(!fixture.run.rests());
        core::EvolveContour expected = rounded(fixture.edit(7));
        QVERIFY(expected.bubbleMm != fixture.edit(7).bubbleMm); // it had to be rounded
        QVERIFY(fixture.run.shownEdit() == expected);
        QVERIFY(fixture.isAsExpected(expected));
        fixture.run.goTo(1000);
        QVERIFY(fixture.isThere(9));
        fixture.run.goTo(-4);
        QVERIFY(fixture.isThere(0));
        QVERIFY(!fixture.run.shownEdit()); // nothing has moved
        QVERIFY(!fixture.run.isPlaying());
    }

    /// It is played generation by generation, and stops at the end.
    void itPlays()
    {
        Fixture fixture;
        std::vector<int> shown;
        QObject::connect(&fixture.run, &ui::ContourRun::changed, &fixture.run, [&] {
            const int now = fixture.run.track() ? fixture.run.track()->shown() : 0;
            if (shown.empty() || shown.back() != now)
                shown.push_back(now);
        });
        fixture.run.begin(fixture.edit(100));
        QTRY_VERIFY(fixture.run.track() && !fixture.run.isWorking() && !fixture.run.isPlaying());
        const int known = fixture.run.track()->known();
        QVERIFY(fixture.run.rests() && known >= 11 && known < 100);
        QCOMPARE(shown.size(), std::size_t(known + 1));
        for (int generation = 0; generation <= known; ++generation)
            QCOMPARE(shown[std::size_t(generation)], generation);
        QVERIFY(fixture.isAsExpected(rounded(fixture.edit(100))));
        QCOMPARE(fixture.run.track()->gained(),
            std::int64_t(test::smallHead::voxelsOf(test::smallHead::ventricleHu)
                + test::smallHead::voxelsOf(test::smallHead::brainHu)));
    }

    /// Of several wishes the last one counts, whether rule or start has changed.
    void theLastWishCounts_data()
    {
        QTest::addColumn<bool>("known"); // the first one was worked out before
        QTest::addColumn<bool>("start"); // the start changes, too
        for (const bool known : {false, true}) {
            for (const bool start : {false, true})
                QTest::addRow("known %d, start %d", int(known), int(start)) << known << start;
        }
    }
    void theLastWishCounts()
    {
        QFETCH(const bool, known);
        QFETCH(const bool, start);
        Fixture fixture;
        core::EvolveContour edit = fixture.edit(8);
        fixture.run.begin(edit);
        fixture.run.goTo(5);
        if (known)
            QTRY_VERIFY(!fixture.run.isWorking());
        for (const int smoothness : {0, 60, 100, 70}) {
            edit.smoothness = smoothness;
            fixture.run.begin(edit);
        }
        if (start) {
            edit.bubbleMm = 3.6;
            fixture.run.begin(edit);
            QVERIFY(!fixture.run.shownEdit()); // its ground is not known yet
        } else if (known) {
            QVERIFY(fixture.run.shownEdit()); // what was shown stays in sight
            QCOMPARE(fixture.run.shownEdit()->smoothness, 30);
        }
        QTRY_VERIFY(!fixture.run.isWorking());
        QVERIFY(!fixture.run.isPlaying());
        QVERIFY(fixture.isThere(std::min(5, fixture.run.track()->known())));
        QVERIFY(fixture.run.track()->known() >= 1);
        core::EvolveContour expected = rounded(edit);
        expected.generations = fixture.run.track()->shown();
        QVERIFY(fixture.run.shownEdit() == expected);
        QVERIFY(fixture.isAsExpected(expected));
    }

    /// What is dropped is silent, at whatever moment; the next one begins anew.
    void whatIsDroppedIsSilent()
    {
        Fixture fixture;
        QSignalSpy changed(&fixture.run, &ui::ContourRun::changed);
        QSignalSpy failed(&fixture.run, &ui::ContourRun::failed);
        for (const int milliseconds : {0, 1, 5, 20, 40}) {
            fixture.run.begin(fixture.edit(100));
            QTest::qWait(milliseconds);
            fixture.run.drop();
            changed.clear();
            QTest::qWait(30);
            QCOMPARE(changed.size(), 0);
            QVERIFY(!fixture.run.isOpen() && !fixture.run.isWorking() && !fixture.run.isPlaying());
            QVERIFY(!fixture.run.track() && !fixture.run.state() && !fixture.run.shownEdit());
        }
        fixture.run.begin(fixture.edit(4));
        QTRY_VERIFY(fixture.isThere(4));
        QVERIFY(fixture.isAsExpected(rounded(fixture.edit(4))));
        // With its session it goes, too.
        fixture.workspace.setSession(nullptr);
        QVERIFY(!fixture.run.isOpen());
        fixture.run.begin(fixture.edit(4));
        QVERIFY(!fixture.run.isOpen());
        QCOMPARE(failed.size(), 0);
    }

    void whatCannotBeFails()
    {
        Fixture fixture;
        QSignalSpy failed(&fixture.run, &ui::ContourRun::failed);
        QSignalSpy nothing(&fixture.run, &ui::ContourRun::foundNothing);
        core::EvolveContour edit = fixture.edit(4);
        edit.segment = 7;
        fixture.run.begin(edit);
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(!fixture.run.isOpen());
        edit = fixture.edit(4);
        edit.bubbleLps.reset();
        fixture.run.begin(edit);
        QTRY_COMPARE(nothing.size(), 1);
        QVERIFY(!fixture.run.isOpen());
        // The segment is locked while it is watched.
        fixture.run.begin(fixture.edit(4));
        QTRY_VERIFY(!fixture.run.isWorking());
        fixture.apply(test::lockSegment(1));
        QTRY_COMPARE(failed.size(), 2);
        QVERIFY(!fixture.run.isOpen());
    }
};

BURIN_WINDOW_TEST(ContourRunUiTest)

} // namespace contourRunUiTest

#include "ContourRunUiTest.moc"
