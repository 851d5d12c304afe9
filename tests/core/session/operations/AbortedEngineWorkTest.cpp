// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <utility>
#include <vector>

namespace abortedEngineWorkTest {

using namespace core;

namespace {

/// A session on an oracle, with two segments that have voxels.
struct Bench {
    explicit Bench(EditEngine& engine, const QString& file = {})
        : session(*EditSession::create(engine, test::smallStudy(), {.file = file}))
    {
        session->setErrorListener([this](const Error& error) { told.push_back(error.code); });
        for (const Edit& edit : {test::addSegment("Organ"), test::addSegment("Other"),
                 test::paintAt(1, {test::pointsInBrain().back()}, 3.0),
                 test::paintAt(2, {test::pointsInBone().back()}, 2.0)})
            isReady = session->apply(edit).has_value() && isReady;
        isReady = session->settle().has_value() && isReady;
        before = session->stateHash();
        rows = session->history().rows().size();
    }
    [[nodiscard]] bool isAsBefore()
    {
        return session->settle() && session->idle() && session->stateHash() == before
            && session->history().rows().size() == rows;
    }
    /// Aborts what is carried out, and waits until nothing is left of it.
    [[nodiscard]] bool abort()
    {
        session->segmentWork().abort();
        return !session->segmentWork().percent() && !session->settle();
    }

    std::unique_ptr<EditSession> session;
    std::vector<ErrorCode> told; ///< failures after the calls that caused them
    bool isReady = true;
    QByteArray before;
    std::size_t rows = 0;
};

/// Edits with which an engine goes through the volume, by name.
const std::vector<std::pair<const char*, Edit>>& longEdits()
{
    static const std::vector<std::pair<const char*, Edit>> all{
        {"invert", InvertSegment{.segment = 1}},
        {"threshold", ThresholdSegment{.segment = 1, .lower = 0.0}},
        {"merge", CombineSegments{.segment = 1, .with = 2}}, {"seeds", GrowFromSeeds{}}};
    return all;
}

} // namespace

/// What the engine carries out is aborted, however far it is: these engines are done at once, so
/// that what they changed is taken back.
class AbortedEngineWorkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void leavesNothing_data()
    {
        QTest::addColumn<int>("place");
        for (std::size_t place = 0; place < longEdits().size(); ++place)
            QTest::newRow(longEdits()[place].first) << int(place);
    }
    void leavesNothing()
    {
        QFETCH(const int, place);
        const Edit& edit = longEdits()[std::size_t(place)].second;
        for (const bool isLate : {false, true}) {
            reference::ReferenceEngine inner;
            reference::DelayedEngine late(inner, 11);
            Bench bench(isLate ? static_cast<EditEngine&>(late) : inner);
            EditSession& session = *bench.session;
            QVERIFY(bench.isReady);
            QVERIFY(session.apply(edit));
            QVERIFY(session.segmentWork().percent() && !session.segmentWork().isPreview());
            QVERIFY(bench.abort());
            QCOMPARE(bench.told, std::vector<ErrorCode>{ErrorCode::Cancelled});
            QVERIFY(bench.isAsBefore());
            session.segmentWork().abort(); // of nothing
            // A preview is ended, not aborted; once it is taken it is work as any other.
            QVERIFY(session.begin(edit) && session.openIsPreview());
            // Of grown seeds the engine keeps something for the next preview.
            QCOMPARE(session.openIsReplaceable(), !edit.is<GrowFromSeeds>());
            QVERIFY(!session.segmentWork().percent());
            session.segmentWork().abort();
            QVERIFY(session.openEdit());
            session.end(Ending::Commit);
            QVERIFY(session.segmentWork().percent());
            QVERIFY(bench.abort());
            QVERIFY(bench.isAsBefore());
            // What waits behind it is carried out all the same, on what was there before.
            QVERIFY(session.apply(edit));
            QVERIFY(session.apply(test::renameSegment(2, QStringLiteral("Next"))));
            session.segmentWork().abort();
            QVERIFY(!session.settle());
            QCOMPARE(session.history().rows().size(), bench.rows + 1);
            QCOMPARE(session.document().segment(2)->name, QStringLiteral("Next"));
            QVERIFY(session.undo() && session.settle());
            QCOMPARE(session.stateHash(), bench.before);
            // Nothing is lost for the next one.
            QVERIFY(session.apply(edit) && session.settle());
            QVERIFY(session.stateHash() != bench.before);
            reference::ReferenceEngine other;
            Bench untouched(other);
            QVERIFY(untouched.session->apply(edit) && untouched.session->settle());
            QCOMPARE(session.stateHash(), untouched.session->stateHash());
            QCOMPARE(bench.told, std::vector<ErrorCode>(3, ErrorCode::Cancelled));
        }
    }

    /// What was asked for is done in a session that ends meanwhile.
    void isAwaitedAtTheEnd()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("session.burin"));
        reference::ReferenceEngine engine;
        Bench bench(engine, file);
        QVERIFY(bench.session->apply(InvertSegment{.segment = 1}));
        QVERIFY(bench.session->segmentWork().percent());
        bench.session.reset();
        const auto opened = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(opened);
        QCOMPARE((*opened)->history().rows().size(), bench.rows + 1);
        QVERIFY((*opened)->history().rows().back().edit.is<InvertSegment>());
    }
};

BURIN_TEST(AbortedEngineWorkTest)

} // namespace abortedEngineWorkTest

#include "AbortedEngineWorkTest.moc"
