// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace backwardShrinkTest {

using namespace core;

namespace {

/// A grown ball of brain, with its seeds in the middle.
struct Ball {
    explicit Ball(bool delayed = false, const QString& file = {})
        : late(inner, 5)
    {
        EditEngine& engine = delayed ? static_cast<EditEngine&>(late) : inner;
        session = *EditSession::create(engine, test::smallStudy(), {.file = file});
        for (const Edit& edit :
            {test::addSegment("Brain"), test::seedInBrain(1), test::growBrain()}) {
            if (!session->apply(edit) || !session->settle())
                qFatal("the ball did not grow");
        }
        grown = session->stateHash();
    }
    /// Between seeds and rim.
    [[nodiscard]] ShrinkAt at(int steps, double fromMiddleMm = 10.0) const
    {
        ShrinkAt shrink{.steps = steps};
        const std::vector<glm::dvec3> seeds = test::pointsInBrain();
        for (const double aside : {0.0, 1.0})
            shrink.pointsLps.push_back(seeds.front() + glm::dvec3(fromMiddleMm, aside, 0.0));
        return shrink;
    }
    [[nodiscard]] std::int64_t voxels() const
    {
        const std::vector<std::uint8_t> labels = *session->questions().labels(0);
        return std::count(labels.begin(), labels.end(), 1);
    }
    [[nodiscard]] std::size_t rows() const { return session->history().rows().size(); }
    [[nodiscard]] const HistoryRow& lastRow() const { return session->history().rows().back(); }
    void walk(Result<void> (EditSession::*step)())
    {
        if (!(session.get()->*step)() || !session->settle())
            qFatal("a step back or forth is refused");
    }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    std::unique_ptr<EditSession> session;
    QByteArray grown;
};

} // namespace

/// ShrinkAt with steps: held open, and whole.
class BackwardShrinkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void heldItIsOneRowThatReplaysTheSame_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::newRow("at once") << false;
        QTest::newRow("late") << true;
    }
    void heldItIsOneRowThatReplaysTheSame()
    {
        QFETCH(bool, delayed);
        Ball held(delayed);
        const std::int64_t before = held.voxels();
        const std::size_t rows = held.rows();
        EditSession& session = *held.session;
        QVERIFY(session.begin(held.at(1)));
        for (const int steps : {2, 3, 2, 4})
            session.extend(ToSteps{steps});
        session.end(Ending::Commit);
        QVERIFY(session.settle());
        QCOMPARE(held.rows(), rows + 1);
        QCOMPARE(held.lastRow().edit.get<ShrinkAt>().steps, std::optional<int>(4));
        QVERIFY(held.lastRow().name.startsWith(QStringLiteral("Shrink here 4 generations")));
        const std::int64_t after = held.voxels();
        QVERIFY(after < before && after > before / 8);
        const QByteArray shrunk = session.stateHash();

        Ball whole;
        QVERIFY(whole.session->apply(held.lastRow().edit) && whole.session->settle());
        QCOMPARE(whole.session->stateHash(), shrunk);
        QCOMPARE(whole.lastRow().name, held.lastRow().name);
        QCOMPARE(whole.lastRow().growthGeneration, held.lastRow().growthGeneration);

        held.walk(&EditSession::undo);
        QCOMPARE(session.stateHash(), held.grown);
        held.walk(&EditSession::redo);
        QCOMPARE(session.stateHash(), shrunk);
    }

    void moreStepsTakeMoreUntilTheyEnd()
    {
        std::int64_t before = 0;
        for (const int steps : {1, 2, 3, 4, 40}) {
            Ball ball;
            const std::int64_t had = ball.voxels();
            QVERIFY(ball.session->apply(ball.at(steps)) && ball.session->settle());
            const std::int64_t taken = had - ball.voxels();
            QVERIFY2(taken > before, qPrintable(QString::number(steps)));
            before = taken;
        }
        // Held, the row says how many there were.
        Ball held;
        QVERIFY(held.session->begin(held.at(1)));
        held.session->extend(ToSteps{40});
        held.session->end(Ending::Commit);
        QVERIFY(held.session->settle());
        const int done = held.lastRow().edit.get<ShrinkAt>().steps.value_or(0);
        QVERIFY(done > 4 && done < 40);
        QCOMPARE(held.lastRow().statistics.voxelsChanged, before);
    }

    void whatIsRolledBackOrRefusedIsNoRow()
    {
        Ball ball;
        const std::size_t rows = ball.rows();
        QVERIFY(ball.session->begin(ball.at(1)));
        ball.session->extend(ToSteps{3});
        ball.session->end(Ending::Rollback);
        QVERIFY(ball.session->settle());
        // Over a seed.
        QVERIFY(ball.session->begin(ball.at(1, 0.0)));
        ball.session->extend(ToSteps{3});
        ball.session->end(Ending::Commit);
        const auto over = ball.session->settle();
        QVERIFY(!over && over.error().code == ErrorCode::SeedsStay);
        QCOMPARE(ball.session->stateHash(), ball.grown);
        QCOMPARE(ball.rows(), rows);

        ShrinkAt both = ball.at(2);
        both.onlyHere = true;
        const auto refused = ball.session->apply(both);
        QVERIFY(!refused && refused.error().code == ErrorCode::InvalidField);
        QCOMPARE(refused.error().arguments.front(), QStringLiteral("shrinkAt.steps"));
        for (const int steps : {0, -1})
            QVERIFY(!ball.session->apply(ball.at(steps)));
        ShrinkAt whole = ball.at(1);
        whole.steps.reset();
        QVERIFY(!ball.session->begin(whole)); // there is nothing to hold
    }

    /// Whatever comes next ends it where it is.
    void anotherEditEndsIt()
    {
        Ball ball;
        const std::size_t rows = ball.rows();
        QVERIFY(ball.session->begin(ball.at(1)));
        ball.session->extend(ToSteps{2});
        QVERIFY(ball.session->apply(test::addSegment("Other")) && ball.session->settle());
        QCOMPARE(ball.rows(), rows + 2);
        QCOMPARE(
            ball.session->history().rows()[rows].edit.get<ShrinkAt>().steps, std::optional<int>(2));
    }

    /// A row without the field is the old whole removal, and its JSON says nothing of steps.
    void withoutStepsItIsWhatItWas()
    {
        Ball ball;
        ShrinkAt whole = ball.at(1);
        const QJsonObject with = editToJson(Edit(whole));
        QCOMPARE(with[QLatin1String("steps")].toInt(), 1);
        whole.steps.reset();
        QVERIFY(!editToJson(Edit(whole)).contains(QLatin1String("steps")));
        const auto read = editFromJson(with);
        QVERIFY(read && read->get<ShrinkAt>().steps == std::optional<int>(1));
        QVERIFY(ball.session->apply(whole) && ball.session->settle());
        QVERIFY(ball.lastRow().name.startsWith(QStringLiteral("Shrink here, ")));
    }

    void itIsThereAgainInAReopenedSession()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("held.burin"));
        QByteArray shrunk;
        {
            Ball ball(false, file);
            QVERIFY(ball.session->begin(ball.at(1)));
            ball.session->extend(ToSteps{3});
            ball.session->end(Ending::Commit);
            QVERIFY(ball.session->settle());
            shrunk = ball.session->stateHash();
        }
        reference::ReferenceEngine engine;
        auto again = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(again);
        QCOMPARE((*again)->stateHash(), shrunk);
        QCOMPARE(
            (*again)->history().rows().back().edit.get<ShrinkAt>().steps, std::optional<int>(3));
    }
};

BURIN_TEST(BackwardShrinkTest)

} // namespace backwardShrinkTest

#include "BackwardShrinkTest.moc"
