// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/PassingEngine.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace throwingSubmitTest {

using namespace core;

namespace {

/// The oracle, but one that throws once when it is asked for something, as where there is no memory
/// for the question, or once answers what was read with nothing, which throws where it is looked
/// at.
class ThrowingEngine final : public reference::PassingEngine {
public:
    /// @param place of what is asked from now on; 0 is the next
    void throwAt(int place) { m_left = place; }
    [[nodiscard]] bool hasThrown() const { return m_left < 0; }
    /// @param place of the bricks that are read from now on; 0 are the next
    void forgetAt(int place) { m_readsLeft = place; }
    [[nodiscard]] bool hasForgotten() const { return m_readsLeft < 0; }

    Ticket submit(EngineCommand command) override
    {
        if (m_left && (*m_left)-- == 0)
            throw std::bad_alloc();
        const auto* read = std::get_if<ReadBricks>(&command);
        const bool isForgotten =
            read && !read->keys.empty() && m_readsLeft && (*m_readsLeft)-- == 0;
        const Ticket ticket = PassingEngine::submit(std::move(command));
        if (isForgotten)
            m_forgotten = ticket;
        return ticket;
    }
    [[nodiscard]] std::vector<EngineResult> collect() override
    {
        std::vector<EngineResult> results = PassingEngine::collect();
        for (EngineResult& result : results) {
            if (m_forgotten && result.ticket == *m_forgotten)
                result.changes.clear();
        }
        return results;
    }

private:
    std::optional<int> m_left; ///< none: it never throws
    std::optional<int> m_readsLeft; ///< none: it forgets nothing
    std::optional<Ticket> m_forgotten;
};

/// Segment 1 on three slices with a speck, segment 2 beside it, and layer 1 carved.
struct Bench {
    explicit Bench(const std::vector<Edit>& first)
        : session(*EditSession::create(engine, test::smallStudy(), {}))
    {
        session->setErrorListener([this](const Error& error) { told.push_back(error.code); });
        const VolumeGeometry& geometry = test::smallGrid();
        const auto disc = [&](const glm::dvec3& index, double radius) {
            return test::paintDiscAt(1, geometry.toWorld(index), geometry.direction()[2], radius);
        };
        std::vector<Edit> all{test::addSegment("Organ"), test::addSegment("Other"),
            disc({20.0, 18.0, 8.0}, 6.0), disc({20.0, 18.0, 9.0}, 6.0),
            disc({18.0, 17.0, 14.0}, 4.0), disc({30.0, 12.0, 22.0}, 1.1),
            test::paintAt(2, {geometry.toWorld({28.0, 18.0, 9.0})}, 3.0), test::drillAt(0.0)};
        all.insert(all.end(), first.begin(), first.end());
        for (const Edit& edit : all)
            isReady = session->apply(edit) && session->settle() && isReady;
        isReady = told.empty() && isReady;
        before = session->stateHash();
        labels = *session->questions().labels(0);
        coverage = *session->questions().coverage(1);
        rows = session->history().rows().size();
    }
    /// @return whether it is done and left a row
    [[nodiscard]] bool carryOut(const Edit& edit) const
    {
        return session->apply(edit) && session->settle()
            && session->history().rows().size() == rows + 1;
    }
    [[nodiscard]] bool isAsBefore() const
    {
        return session->history().rows().size() == rows && session->stateHash() == before
            && session->questions().labels(0) == labels
            && session->questions().coverage(1) == coverage && !session->transactionOpen();
    }

    ThrowingEngine engine;
    std::unique_ptr<EditSession> session;
    std::vector<ErrorCode> told; ///< failures after the calls that caused them
    bool isReady = true;
    QByteArray before;
    std::vector<std::uint8_t> labels;
    std::vector<std::uint8_t> coverage; ///< of layer 1
    std::size_t rows = 0;
};

struct Case {
    const char* name = "";
    std::vector<Edit> first;
    Edit edit;
};

std::vector<Case> cases()
{
    const auto at = [](const glm::dvec3& index) { return test::smallGrid().toWorld(index); };
    const SplitPart part{.name = QStringLiteral("Part"), .rgb = 0x407080};
    const EditableRange low{.lower = 0.0, .upper = 500.0};
    const Edit lay = LaySurface{.segment = 2, .vertices = 300};
    const Edit push = SpherePush{
        .path = {.radiusMm = 3.0, .pointsLps = {at({31.5, 18.0, 9.0}), at({30.0, 18.0, 9.0})}}};
    const Edit divide = DivideSegment{.segment = 1, .marginMm = 6.0};
    return {
        {"paint", {}, test::paintAt(1, {at({14.0, 18.0, 9.0})})},
        {"grow", {test::seedInBrain(1)}, test::growBrain(2)},
        {"carve", {}, test::drillAt(6.0)},
        {"margin", {}, ReshapeSegment{.segment = 1, .operation = ShapeOperation::Grow, .mm = 2.0}},
        {"largest", {}, CleanSegment{.segment = 1, .rule = IslandRule::KeepLargest}},
        {"between slices", {}, FillBetweenSlices{.segment = 1}},
        {"mirror", {}, MirrorSegment{.segment = 1}},
        {"split", {}, SplitSegment{.segment = 1, .placeLps = at({20.0, 18.0, 8.0}), .into = part}},
        {"islands", {}, SplitIslands{.segment = 1}},
        {"islands within", {}, SplitIslands{.segment = 1, .editable = low}},
        {"copy", {}, CopySegment{.segment = 1, .name = QStringLiteral("Copy")}},
        {"flood", {},
            FloodFill{.segment = 1, .placeLps = at({20.0, 22.0, 16.0}), .tolerance = 20.0}},
        {"contour", {},
            EvolveContour{.segment = 1, .lower = 0.0, .upper = 300.0, .generations = 3}},
        {"divide", {}, divide},
        {"chunks", {divide},
            ChunkToggle{.segment = 1,
                .chunks = 8,
                .mode = ChunkToggle::Mode::Toggle,
                .pointsLps = {at({20.0, 18.0, 8.0})}}},
        {"lay", {}, lay},
        {"follow", {lay, test::paintAt(2, {at({30.0, 18.0, 9.0})}, 3.0)}, FollowMask{}},
        {"push", {lay}, push},
        {"write back", {lay, push}, WriteBack{}},
        {"revert", {}, test::revertRows({7})},
        {"revert before an import",
            {test::importOfBoxes({{{33, 33, 20}, {38, 36, 30}}}, test::smallGrid().size)},
            test::revertRows({7})},
        {"revise", {}, ReviseStroke{.row = 8, .radiusMm = 2.0}},
        {"revise among others", {test::drillAt(6.0), test::drillAt(3.0)},
            ReviseStroke{.row = 8, .radiusMm = 7.0}},
        {"remove", {test::drillAt(2.0)}, ReviseStroke{.row = 8, .removed = true}},
    };
}

} // namespace

/// Memory that is refused on the session's thread takes back what was begun, and nothing else: who
/// works goes on, without opening the session again.
class ThrowingSubmitTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Each thing that an edit asks of the engine fails once.
    void everyEditIsTakenBackAndDoneAgain_data()
    {
        QTest::addColumn<int>("place");
        const std::vector<Case> all = cases();
        for (std::size_t place = 0; place < all.size(); ++place)
            QTest::newRow(all[place].name) << int(place);
    }
    void everyEditIsTakenBackAndDoneAgain()
    {
        QFETCH(const int, place);
        const Case known = cases()[std::size_t(place)];
        QByteArray expected;
        {
            Bench bench(known.first);
            QVERIFY(bench.isReady && bench.carryOut(known.edit));
            expected = bench.session->stateHash();
        }
        int thrown = 0;
        for (;; ++thrown) {
            Bench bench(known.first);
            bench.engine.throwAt(thrown);
            const bool isDone = bench.carryOut(known.edit);
            if (!bench.engine.hasThrown())
                break;
            QVERIFY2(!isDone, qPrintable(QString::number(thrown)));
            QVERIFY(!bench.told.empty());
            QVERIFY(bench.told.front() == ErrorCode::OutOfMemory);
            QVERIFY2(bench.isAsBefore(), qPrintable(QString::number(thrown)));
            QVERIFY2(bench.carryOut(known.edit), qPrintable(QString::number(thrown)));
            QCOMPARE(bench.session->stateHash(), expected);
        }
        QVERIFY(thrown > 0 || known.edit.is<LaySurface>() || known.edit.is<SpherePush>());
    }

    /// Also where the side thread cannot go on, or this one in the midst of coverage of before.
    void aRevisionThatCannotGoOnIsTakenBack()
    {
        const ReviseStroke revision{.row = 8, .radiusMm = 7.0};
        int forgotten = 0;
        for (;; ++forgotten) {
            Bench bench({test::drillAt(6.0), test::drillAt(3.0)});
            bench.engine.forgetAt(forgotten);
            const bool isDone = bench.carryOut(revision);
            if (!bench.engine.hasForgotten())
                break;
            QVERIFY2(!isDone && !bench.told.empty(), qPrintable(QString::number(forgotten)));
            QVERIFY2(bench.isAsBefore(), qPrintable(QString::number(forgotten)));
            QVERIFY2(bench.carryOut(revision), qPrintable(QString::number(forgotten)));
        }
        QCOMPARE(forgotten, 2);
    }

    /// What is not asked is answered all the same: with the reason.
    void questionsAreAnswered()
    {
        Bench bench({});
        bench.engine.throwAt(0);
        const Result<std::vector<std::uint8_t>> labels = bench.session->questions().labels(0);
        QVERIFY(!labels && labels.error().code == ErrorCode::OutOfMemory);
        QVERIFY(bench.isAsBefore());
        QVERIFY(bench.carryOut(test::paintAt(1, {test::smallGrid().toWorld({14.0, 18.0, 9.0})})));
    }

    /// Rows without a second half, as a program leaves them that was killed, are carried out again
    /// when the session is opened. If one of them cannot be, nothing is written for those after it.
    void whatIsCarriedOutAgainBuildsOnWhatWas()
    {
        const QTemporaryDir folder;
        const QString killed = folder.filePath(QStringLiteral("killed.burin"));
        const QString file = folder.filePath(QStringLiteral("again.burin"));
        QByteArray expected;
        {
            ThrowingEngine engine;
            const auto session = *EditSession::create(engine, test::smallStudy(), {.file = killed});
            const glm::dvec3 place = test::smallGrid().toWorld({20.0, 18.0, 9.0});
            for (const Edit& edit : {test::addSegment("Organ"), test::paintAt(1, {place}, 4.0),
                     Edit(ReshapeSegment{
                         .segment = 1, .operation = ShapeOperation::Grow, .mm = 2.0}),
                     test::drillAt(0.0),
                     Edit(ReshapeSegment{
                         .segment = 1, .operation = ShapeOperation::Hollow, .mm = 1.6})})
                QVERIFY(session->apply(edit) && session->settle());
            expected = session->stateHash();
        }
        QVERIFY(test::runSql(killed,
            QStringLiteral("UPDATE row SET stateHash = NULL, deltaSha256 = NULL, seal = NULL "
                           "WHERE id > 2")));
        QVERIFY(test::runSql(killed, QStringLiteral("DELETE FROM delta WHERE row > 2")));
        int thrown = 0;
        for (bool isThrown = true; isThrown; thrown += isThrown ? 1 : 0) {
            QFile::remove(file);
            QVERIFY(QFile::copy(killed, file));
            ThrowingEngine engine;
            engine.throwAt(thrown);
            const bool isOpen = EditSession::open(engine, test::smallStudy(), file).has_value();
            isThrown = engine.hasThrown();
            QCOMPARE(isOpen, !isThrown);
            reference::ReferenceEngine sound;
            const auto opened = EditSession::open(sound, test::smallStudy(), file);
            QVERIFY2(opened, qPrintable(QString::number(thrown)));
            QCOMPARE((*opened)->stateHash(), expected);
            QCOMPARE((*opened)->history().rows().size(), std::size_t(5));
        }
        QVERIFY2(thrown > 5, qPrintable(QString::number(thrown)));
    }

    void stepsBackAreTakenAgain()
    {
        for (const bool isBack : {true, false}) {
            Bench bench({});
            if (!isBack)
                QVERIFY(bench.session->undo() && bench.session->settle());
            const QByteArray before = bench.session->stateHash();
            const auto step = [&] {
                const Result<void> taken = isBack ? bench.session->undo() : bench.session->redo();
                return taken && bench.session->settle();
            };
            bench.engine.throwAt(0);
            QVERIFY(!step() && bench.engine.hasThrown());
            QCOMPARE(bench.session->stateHash(), before);
            QVERIFY(step());
            QVERIFY(bench.session->stateHash() != before);
            QCOMPARE(bench.session->stateHash() == bench.before, !isBack);
        }
    }
};

BURIN_TEST(ThrowingSubmitTest)

} // namespace throwingSubmitTest

#include "ThrowingSubmitTest.moc"
