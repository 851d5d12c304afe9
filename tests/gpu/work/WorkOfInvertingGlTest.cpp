// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/session/EditSession.h"
#include "tests/support/fixtures/WorkTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

namespace workOfInvertingGlTest {

using namespace core;
using test::CountedSession;

/// What it costs to invert a segment, which changes every brick of a volume: it may cost so much
/// for each of them, in a small volume and in a large one. It has a session to itself, which knows
/// all bricks as labelled afterwards. Carving all that lies outside a segment is left out: a
/// software driver works out the radiation of a whole large volume for minutes.
class WorkOfInvertingGlTest : public test::WorkTest {
    Q_OBJECT

public:
    WorkOfInvertingGlTest()
        : WorkTest(QString())
    {
    }

private:
    void prepare(CountedSession& counts) override;
    void takeSteps(CountedSession& counts, int round) override;
    [[nodiscard]] test::MoreWork allowed(const QByteArray& step) const override;
};

void WorkOfInvertingGlTest::prepare(CountedSession& counts)
{
    counts.prepare(test::newSegment(QStringLiteral("Organ")));
    counts.prepare(test::paintAt(1, {test::GradedBall::middle}, 12.0));
}

void WorkOfInvertingGlTest::takeSteps(CountedSession& counts, int /*round*/)
{
    counts.step("inverting", InvertSegment{.segment = 1});
}

test::MoreWork WorkOfInvertingGlTest::allowed(const QByteArray& /*step*/) const
{
    // A group asks, one writes, and one each fetches what was there and what has come; both are
    // read into memory by way of a copy, and packed for the history. Going back, they are unpacked
    // and compared, and one of them is written.
    constexpr int groups = 5;
    constexpr std::int64_t bytes = 6 * std::int64_t(BrickGrid::voxelsPerBrick);
    // A slice has 64 bricks at least, how many more depends on the time that they take, and some
    // dispatches; and there are buffers that are made once.
    constexpr int bricksOfDispatch = 16;
    constexpr std::int64_t madeOnce = 64 * std::int64_t(BrickGrid::voxelsPerBrick);
    return test::MoreWork{.tables = true,
        .dispatches = 16 + int(bricksOf(test::largeWorkSide)) / bricksOfDispatch,
        .bytesWithin = madeOnce,
        .bytesAllocated = madeOnce,
        .forBrick = test::MoreWork::ForBrick{.groups = groups, .bytes = bytes}};
}

BURIN_TEST(WorkOfInvertingGlTest)

} // namespace workOfInvertingGlTest

#include "WorkOfInvertingGlTest.moc"
