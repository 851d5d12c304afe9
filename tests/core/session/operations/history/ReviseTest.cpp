// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickGrid.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/engine/EngineCommands.h"
#include "core/history/StandingStrokes.h"
#include "core/session/EditSession.h"
#include "core/session/StepFindings.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

#include <map>
#include <random>

namespace reviseTest {

using namespace core;

namespace {

using Coverage = std::map<std::pair<int, std::uint32_t>, std::vector<std::uint8_t>>;

constexpr int layers = 2;

/// All coverage that an engine holds in some layers, by layer and brick; empty bricks are left out.
Coverage coverageOf(
    EditEngine& engine, const glm::ivec3& size, int firstLayer = 1, int lastLayer = layers)
{
    ReadBricks read;
    const int bricks = BrickGrid{size}.brickCount();
    for (int layer = firstLayer; layer <= lastLayer; ++layer) {
        for (int brick = 0; brick < bricks; ++brick)
            read.keys.push_back({Field::Coverage, std::uint8_t(layer), std::uint32_t(brick)});
    }
    const Ticket ticket = engine.submit(std::move(read));
    engine.finish();
    Coverage coverage;
    for (const EngineResult& result : engine.collect()) {
        for (const BrickChange& change : result.changes) {
            if (result.ticket == ticket && !change.after.empty())
                coverage[{change.key.plane, change.key.brick}] = change.after.read();
        }
    }
    return coverage;
}

struct Bench {
    explicit Bench(const std::vector<Edit>& edits = {})
    {
        session = *EditSession::create(engine, test::smallStudy(), {});
        for (const Edit& edit : edits)
            run(edit);
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        const Result<void> settled = session->settle();
        QVERIFY2(settled, qPrintable(settled ? QString() : settled.error().arguments.join(u' ')));
    }
    [[nodiscard]] Result<void> attempt(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        return applied ? session->settle() : applied;
    }
    [[nodiscard]] QString refusal(const Edit& edit)
    {
        const QByteArray before = session->stateHash();
        const std::size_t rows = session->history().rows().size();
        const Result<void> result = attempt(edit);
        if (result || session->stateHash() != before || session->history().rows().size() != rows)
            return QStringLiteral("was not refused");
        return result.error().arguments.join(u' ');
    }
    [[nodiscard]] Coverage coverage()
    {
        return coverageOf(engine, test::smallStudy().volume.geometry.size);
    }
    [[nodiscard]] const HistoryRow& lastRow() const { return session->history().rows().back(); }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

/// The oracle, but one that refuses one of the commands to come, as an engine without memory does.
class RefusingOnce final : public EditEngine {
public:
    /// @param after how many commands; the end of an edit is none
    void refuse(int after) { m_left = after + 1; }
    void relent() { m_left = 0; }
    [[nodiscard]] bool hasRefused() const { return m_left == 0; }

    Result<void> openVolume(const glm::ivec3& size, std::span<const std::uint16_t> codes) override
    {
        return m_inner.openVolume(size, codes);
    }
    Ticket submit(EngineCommand command) override
    {
        // What is asked instead is refused, too, and takes its place among the tickets.
        if (m_left > 0 && !std::holds_alternative<EndEdit>(command) && --m_left == 0)
            return m_inner.submit(ReadSeedWords{.voxels = {glm::ivec3(-1)}});
        return m_inner.submit(std::move(command));
    }
    [[nodiscard]] std::vector<EngineResult> collect() override { return m_inner.collect(); }
    void finish() override { m_inner.finish(); }
    void setWakeUp(std::function<void()> wakeUp) override { m_inner.setWakeUp(std::move(wakeUp)); }
    [[nodiscard]] GrowthProgress growthProgress() const override
    {
        return m_inner.growthProgress();
    }

private:
    reference::ReferenceEngine m_inner;
    int m_left = 0; ///< commands until one is refused, and that one; 0: none is
};

QByteArray hashOf(const std::vector<Edit>& edits)
{
    return Bench(edits).session->stateHash();
}

DrillStroke drill(double xMm, double radiusMm = 5.0, double depthMm = 5.0, int layer = 1)
{
    DrillStroke stroke = test::drillAt(xMm).get<DrillStroke>();
    stroke.mask.radiusMm = radiusMm;
    stroke.depthMm = depthMm;
    stroke.layer = layer;
    return stroke;
}

/// What strokes cut, worked out without the session: each alone on an engine of its own, on the
/// coverage as it was when the stroke was drawn.
class Truth {
public:
    void draw(RowId row, const DrillStroke& stroke, const Coverage& before)
    {
        m_strokes[row] = {before, stroke, true};
    }
    void setStanding(RowId row, bool stands) { m_strokes.at(row).stands = stands; }
    void setStroke(RowId row, const DrillStroke& stroke) { m_strokes.at(row).stroke = stroke; }

    [[nodiscard]] Coverage coverage() const
    {
        Coverage sum;
        for (const auto& [row, drawn] : m_strokes) {
            if (!drawn.stands)
                continue;
            for (const auto& [brick, bytes] : cut(drawn)) {
                std::vector<std::uint8_t>& held = sum[{drawn.stroke.layer, brick}];
                held.resize(bytes.size(), 0);
                for (std::size_t i = 0; i < bytes.size(); ++i)
                    held[i] = std::max(held[i], bytes[i]);
            }
        }
        return sum;
    }

private:
    struct Drawn {
        Coverage before;
        DrillStroke stroke;
        bool stands = true;
    };
    [[nodiscard]] static std::map<std::uint32_t, std::vector<std::uint8_t>> cut(const Drawn& drawn)
    {
        const LoadedVolume study = test::smallStudy();
        reference::ReferenceEngine engine;
        static_cast<void>(engine.openVolume(study.volume.geometry.size, study.codes));
        SwapBricks past;
        for (const auto& [key, bytes] : drawn.before)
            past.bricks.push_back({{Field::Coverage, std::uint8_t(key.first), key.second}, bytes});
        engine.submit(std::move(past));
        Document document;
        document.volumes.push_back(study.volume);
        DrillCut alone = *drillCut(drawn.stroke, document);
        alone.layer = 9;
        const Ticket ticket =
            submitWhole(engine, alone, {DrillPath{drillPath(drawn.stroke, alone)}});
        engine.finish();
        std::map<std::uint32_t, std::vector<std::uint8_t>> bricks;
        for (const EngineResult& result : engine.collect()) {
            for (const BrickChange& change : result.changes) {
                if (result.ticket == ticket)
                    bricks[change.key.brick] = change.after.read();
            }
        }
        return bricks;
    }

    std::map<RowId, Drawn> m_strokes;
};

} // namespace

} // namespace reviseTest

Q_DECLARE_METATYPE(core::Edit)
Q_DECLARE_METATYPE(core::ReviseStroke)

namespace reviseTest {

class ReviseTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void oneStrokeIsAsIfDrawnThatWay()
    {
        Bench bench({test::addSegment("Brain"), drill(0), test::seedInBrain(1)});
        bench.run(ReviseStroke{.row = 2, .radiusMm = 3.0});
        QCOMPARE(bench.session->stateHash(),
            hashOf({test::addSegment("Brain"), drill(0, 3.0), test::seedInBrain(1)}));
        QVERIFY2(bench.lastRow().name.contains(QStringLiteral("': radius 5.0 → 3.0 mm, ")),
            qPrintable(bench.lastRow().name));
        QCOMPARE(bench.lastRow().parent, RowId(3));
        bench.run(ReviseStroke{.row = 2, .depthMm = 9.0});
        QCOMPARE(bench.session->stateHash(),
            hashOf({test::addSegment("Brain"), drill(0, 5.0, 9.0), test::seedInBrain(1)}));
        bench.run(ReviseStroke{.row = 2, .throughGaps = true});
        DrillStroke through = drill(0);
        through.throughGaps = true;
        QCOMPARE(bench.session->stateHash(),
            hashOf({test::addSegment("Brain"), through, test::seedInBrain(1)}));
        bench.run(ReviseStroke{.row = 2, .removed = true});
        QCOMPARE(
            bench.session->stateHash(), hashOf({test::addSegment("Brain"), test::seedInBrain(1)}));
        QVERIFY2(bench.lastRow().name.startsWith(QStringLiteral("Remove 'Drill ")),
            qPrintable(bench.lastRow().name));
        bench.run(ReviseStroke{.row = 2});
        QCOMPARE(bench.session->stateHash(),
            hashOf({test::addSegment("Brain"), drill(0), test::seedInBrain(1)}));
        const std::size_t rows = bench.session->history().rows().size();
        bench.run(ReviseStroke{.row = 2}); // as it is: nothing to do, no row
        QCOMPARE(bench.session->history().rows().size(), rows);
    }

    /// Every kind of cut is what it would be, had it been drawn that way.
    void everyCutCanBeRevised_data()
    {
        QTest::addColumn<Edit>("drawn");
        QTest::addColumn<Edit>("otherwise");
        QTest::addColumn<ReviseStroke>("revise");
        QTest::addColumn<QString>("says");
        DrillStroke soft = drill(0);
        soft.mask.softnessMm = 3.0;
        QTest::newRow("soft edge")
            << Edit(drill(0)) << Edit(soft) << ReviseStroke{.row = 2, .softnessMm = 3.0}
            << QStringLiteral("soft edge 0.0 → 3.0 mm, ");
        const glm::dvec3 middle = test::frontView().targetLps;
        BrushStroke brush;
        brush.path.radiusMm = 4.0;
        brush.path.pointsLps = {middle, middle + glm::dvec3(9.0, 3.0, -2.0)};
        BrushStroke wide = brush;
        wide.path.radiusMm = 6.5;
        QTest::newRow("brush") << Edit(brush) << Edit(wide)
                               << ReviseStroke{.row = 2, .radiusMm = 6.5}
                               << QStringLiteral("radius 4.0 → 6.5 mm, ");
        const OrthographicView view = test::frontView();
        const std::vector<glm::dvec2> outline{{-9.0, -8.0}, {9.0, -7.0}, {1.0, 10.0}};
        const double threshold = test::drillAt(0).get<DrillStroke>().surfaceThreshold;
        const Edit peel = test::peelWith({.view = view, .surfaceThreshold = threshold}, outline);
        const Edit thick =
            test::peelWith({.view = view, .depthMm = 7.0, .surfaceThreshold = threshold}, outline);
        QTest::newRow("peel") << peel << thick << ReviseStroke{.row = 2, .depthMm = 7.0}
                              << QStringLiteral("depth 4.0 → 7.0 mm, ");
        ScissorsCut scissors;
        scissors.view = view;
        scissors.polygonMm = outline;
        scissors.surfaceThreshold = threshold;
        scissors.depthMm = 3.0;
        ScissorsCut deep = scissors;
        deep.depthMm = 12.0;
        QTest::newRow("scissors") << Edit(scissors) << Edit(deep)
                                  << ReviseStroke{.row = 2, .depthMm = 12.0}
                                  << QStringLiteral("depth 3.0 → 12.0 mm, ");
    }
    void everyCutCanBeRevised()
    {
        QFETCH(Edit, drawn);
        QFETCH(Edit, otherwise);
        QFETCH(ReviseStroke, revise);
        QFETCH(QString, says);
        // One on each side of it, which it shares bricks with; the later one keeps its place.
        const AddLayer layer{QStringLiteral("Second")};
        const DrillStroke apart = drill(-6, 3.0, 4.0);
        Bench bench({layer, drawn, apart});
        const QByteArray before = bench.session->stateHash();
        bench.run(revise);
        QVERIFY2(bench.lastRow().name.contains(says), qPrintable(bench.lastRow().name));
        Coverage expected = Bench({layer, otherwise}).coverage();
        DrillStroke aside = apart;
        aside.layer = 2;
        for (const auto& [key, bytes] : Bench({layer, drawn, aside}).coverage()) {
            if (key.first != 2)
                continue;
            std::vector<std::uint8_t>& held = expected[{1, key.second}];
            held.resize(bytes.size(), 0);
            for (std::size_t i = 0; i < bytes.size(); ++i)
                held[i] = std::max(held[i], bytes[i]);
        }
        QVERIFY(bench.coverage() == expected);
        bench.run(ReviseStroke{.row = 2, .removed = true});
        bench.run(ReviseStroke{.row = 2});
        QCOMPARE(bench.session->stateHash(), before);
    }

    void whatACutHasNotIsRefused()
    {
        BrushStroke brush;
        brush.path.pointsLps = {test::frontView().targetLps};
        DrillStroke square = drill(0);
        square.mask.kind = ToolMask::Kind::Square;
        const Edit peel =
            test::peelWith({.view = square.view, .surfaceThreshold = square.surfaceThreshold},
                {{-9.0, -8.0}, {9.0, -7.0}, {1.0, 10.0}});
        ScissorsCut through;
        through.view = square.view;
        through.polygonMm = {{-19.0, -18.0}, {19.0, -17.0}, {1.0, 20.0}};
        through.surfaceThreshold = square.surfaceThreshold;
        Bench bench({square, brush, peel, through});
        QVERIFY(bench.refusal(ReviseStroke{.row = 1, .radiusMm = 3.0})
                    .contains(QStringLiteral("reviseStroke.radiusMm the cut of row 1 has none")));
        QVERIFY(bench.refusal(ReviseStroke{.row = 2, .depthMm = 3.0})
                    .contains(QStringLiteral("depthMm")));
        QVERIFY(bench.refusal(ReviseStroke{.row = 2, .throughGaps = true})
                    .contains(QStringLiteral("throughGaps")));
        QVERIFY(bench.refusal(ReviseStroke{.row = 3, .softnessMm = 3.0})
                    .contains(QStringLiteral("softnessMm")));
        QVERIFY(bench.refusal(ReviseStroke{.row = 3, .depthMm = 61.0})
                    .contains(QStringLiteral("depthMm")));
        QVERIFY(bench.refusal(ReviseStroke{.row = 4, .depthMm = 3.0})
                    .contains(QStringLiteral("depthMm")));
    }

    void laterStrokesKeepTheirPlace()
    {
        const DrillStroke first = drill(0, 6.0, 4.0);
        const DrillStroke second = drill(2, 4.0, 4.0);
        Bench bench({first, second});
        bench.run(ReviseStroke{.row = 1, .removed = true});
        // The second one alone, but on the floor of the first: as it is in a layer of its own.
        Bench apart({AddLayer{QStringLiteral("Apart")}, first, drill(2, 4.0, 4.0, 2)});
        Coverage expected;
        for (const auto& [key, bytes] : apart.coverage()) {
            if (key.first == 2)
                expected[{1, key.second}] = bytes;
        }
        QVERIFY(!expected.empty());
        QVERIFY(bench.coverage() == expected);
        QVERIFY(bench.coverage() != Bench({second}).coverage());
        QCOMPARE(bench.session->findings().strokesOnRevisedSurface(), std::vector<RowId>{2});

        // One that starts elsewhere has nothing to do with it.
        Bench clear({drill(-9, 3.0), drill(9, 3.0)});
        clear.run(ReviseStroke{.row = 1, .removed = true});
        QVERIFY(clear.session->findings().strokesOnRevisedSurface().empty());
        QVERIFY(clear.coverage() == Bench({drill(9, 3.0)}).coverage());
    }

    /// A stroke keeps the surface it met, with the layers muted as they were then.
    void layersAreMutedAsTheyWere()
    {
        const AddLayer layer{QStringLiteral("Second")};
        const ChangeLayer mute{.layer = 1, .muted = true};
        const ChangeLayer unmute{.layer = 1, .muted = false};
        const DrillStroke deep = drill(0, 6.0, 6.0);
        Bench bench({layer, deep, mute, drill(1, 4.0, 3.0, 2), unmute});
        bench.run(ReviseStroke{.row = 4, .radiusMm = 5.0});
        QVERIFY(bench.coverage() == Bench({layer, deep, mute, drill(1, 5.0, 3.0, 2)}).coverage());
        QVERIFY(bench.coverage() != Bench({layer, deep, drill(1, 5.0, 3.0, 2)}).coverage());
        // And are again as they are.
        const DrillStroke next = drill(-1, 3.0, 3.0, 2);
        Bench plain({layer, deep, mute, drill(1, 5.0, 3.0, 2), unmute, next});
        bench.run(next);
        QVERIFY(bench.coverage() == plain.coverage());
        // To another layer, with what it cut.
        bench.run(ReviseStroke{.row = 2, .layer = 2});
        for (const auto& [key, bytes] : bench.coverage())
            QCOMPARE(key.first, 2);
        QVERIFY(bench.refusal(ReviseStroke{.row = 2, .layer = 3})
                    .contains(QStringLiteral("no sculpt layer 3")));
    }

    void isOneStepOfUndo()
    {
        Bench bench({drill(0), drill(3), drill(-2, 7.0, 3.0)});
        const QByteArray before = bench.session->stateHash();
        bench.run(ReviseStroke{.row = 2, .radiusMm = 8.0});
        const QByteArray after = bench.session->stateHash();
        QVERIFY(before != after);
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(), before);
        QVERIFY(bench.session->redo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(), after);
    }

    void refusals()
    {
        Bench bench({test::addSegment("Brain"), drill(0), drill(3)});
        QVERIFY(bench.refusal(ReviseStroke{.row = 1}).contains(QStringLiteral("is no cut")));
        QVERIFY(bench.refusal(ReviseStroke{.row = 9}).contains(QStringLiteral("row 9 is not")));
        QVERIFY(bench.refusal(ReviseStroke{.row = 0}).contains(QStringLiteral("row")));
        QVERIFY(bench.refusal(ReviseStroke{.row = 2, .radiusMm = -1.0})
                    .contains(QStringLiteral("radiusMm")));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QVERIFY(bench.refusal(ReviseStroke{.row = 3}).contains(QStringLiteral("row 3 is not")));
        bench.run(RevertRows{{2}});
        QVERIFY(bench.refusal(ReviseStroke{.row = 2}).contains(QStringLiteral("taken back")));
    }

    /// A revision folds in what lay hidden: what counts there cannot be taken back by bricks alone.
    void undoOnlySeesWhatARevisionBroughtToLight()
    {
        // The second stroke lies wholly within the first, so its own row changed little or nothing
        // there; without the first it shows.
        Bench bench({drill(0, 8.0, 9.0), drill(0, 3.0, 1.0)});
        Bench deep({drill(0, 3.0, 4.0), drill(0, 8.0, 12.0)});
        deep.run(ReviseStroke{.row = 2, .removed = true});
        QVERIFY(deep.refusal(RevertRows{{1}}).contains(QStringLiteral("wrote or read")));
        QCOMPARE(deep.session->stateHash(), hashOf({drill(0, 3.0, 4.0)}));
        bench.run(ReviseStroke{.row = 1, .removed = true});
        QVERIFY(bench.refusal(RevertRows{{2}}).contains(QStringLiteral("wrote or read")));
        bench.run(RevertRows{{3}}); // the revision itself can go
        QCOMPARE(bench.session->stateHash(), hashOf({drill(0, 8.0, 9.0), drill(0, 3.0, 1.0)}));
    }

    /// Found by RandomHistoryTest: the revision came back, though its stroke went.
    void aRevisionDoesNotComeBackWithoutItsStroke()
    {
        Bench bench({drill(0), ReviseStroke{.row = 1, .radiusMm = 3.0}, RevertRows{{2}}});
        QVERIFY(bench.refusal(RevertRows{{1, 3}}).contains(QStringLiteral("wrote or read")));
        bench.run(RevertRows{{1}});
        QVERIFY(bench.coverage().empty());
    }

    void survivesTheFile()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("s.burin"));
        reference::ReferenceEngine engine;
        QByteArray hash;
        {
            auto session = *EditSession::create(engine, test::smallStudy(), {.file = file});
            for (const Edit& edit : std::initializer_list<Edit>{
                     drill(0), drill(3), ReviseStroke{.row = 1, .radiusMm = 2.5}})
                QVERIFY(session->apply(edit));
            QVERIFY(session->settle());
            hash = session->stateHash();
        }
        auto session = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(session);
        QCOMPARE((*session)->stateHash(), hash);
        const auto& edit = (*session)->history().row(3).edit.get<ReviseStroke>();
        QCOMPARE(edit.row, std::int64_t(1));
        QCOMPARE(edit.radiusMm.value_or(0.0), 2.5);
        QVERIFY(!edit.depthMm && !edit.removed);
    }

    /// Who closes a session waits for what is worked out beside it.
    void isWholeWhenTheSessionIsClosedMeanwhile()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("s.burin"));
        const ReviseStroke narrower{.row = 1, .radiusMm = 2.5};
        reference::ReferenceEngine engine;
        {
            auto session = *EditSession::create(engine, test::smallStudy(), {.file = file});
            QVERIFY(session->apply(drill(0)));
            QVERIFY(session->apply(drill(3)));
            QVERIFY(session->settle());
            QVERIFY(session->apply(narrower));
        }
        auto session = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(session);
        QCOMPARE((*session)->history().position(), RowId(3));
        QCOMPARE((*session)->stateHash(), hashOf({drill(0), drill(3), narrower}));
    }

    /// Whatever is refused on the way: either nothing has changed, or all is as it should be.
    void aRefusalOnTheWayChangesNothing()
    {
        const Edit first = drill(0, 6.0, 4.0);
        const Edit second = drill(2, 4.0, 4.0);
        const ReviseStroke deeper{.row = 1, .depthMm = 7.0};
        constexpr int scratch = 255; // where strokes of the past are tried
        const glm::ivec3 size = test::smallStudy().volume.geometry.size;
        Bench bench({first, second});
        const QByteArray before = bench.session->stateHash();
        const Coverage heldBefore = bench.coverage();
        bench.run(deeper);
        const QByteArray after = bench.session->stateHash();
        const Coverage heldAfter = bench.coverage();
        QVERIFY(heldAfter != heldBefore);

        RefusingOnce engine;
        const auto session = *EditSession::create(engine, test::smallStudy(), {});
        const auto attempt = [&session](const Edit& edit) {
            const Result<void> applied = session->apply(edit);
            return applied ? session->settle() : applied;
        };
        QVERIFY(attempt(first));
        QVERIFY(attempt(second));
        int refused = 0;
        bool isThrough = false;
        for (int command = 0; !isThrough; ++command) {
            const std::size_t rows = session->history().rows().size();
            engine.refuse(command);
            const bool isDone = bool(attempt(deeper));
            isThrough = !engine.hasRefused();
            engine.relent();
            QVERIFY(isDone || !isThrough);
            refused += isDone ? 0 : 1;
            QCOMPARE(session->history().rows().size(), isDone ? rows + 1 : rows);
            QVERIFY(session->stateHash() == (isDone ? after : before));
            QVERIFY(coverageOf(engine, size) == (isDone ? heldAfter : heldBefore));
            QVERIFY(coverageOf(engine, size, scratch, scratch).empty());
            if (isDone) {
                QVERIFY(session->undo());
                QVERIFY(session->settle());
            }
        }
        QVERIFY(refused > 10);
    }

    /// Random strokes, revisions, removals, "undo only" and undo, against cuts worked out one by
    /// one.
    void anySequenceEqualsTheFoldOfItsCuts()
    {
        const int sequences = qEnvironmentVariableIsSet("BURIN_LONG") ? 60 : 6;
        int revisions = 0;
        for (int sequence = 0; sequence < sequences; ++sequence) {
            std::mt19937 random(std::uint32_t(900 + sequence));
            const auto between = [&random](int low, int high) {
                return low + int(random() % std::uint32_t(high - low + 1));
            };
            Bench bench({AddLayer{QStringLiteral("Second")}});
            std::map<RowId, Truth> truths; // by row
            truths.emplace(1, Truth());
            for (int step = 0; step < 14; ++step) {
                const RowId position = bench.session->history().position();
                Truth truth = truths.at(position);
                const Coverage before = bench.coverage();
                const std::vector<StandingStroke> standing =
                    standingStrokes(bench.session->history(), position);
                Edit edit = drill(between(-8, 8), between(2, 8), between(1, 9), between(1, layers));
                if (!standing.empty() && between(0, 9) < 6) {
                    const StandingStroke& any =
                        standing[std::size_t(between(0, int(standing.size()) - 1))];
                    ReviseStroke revise{.row = any.row};
                    if (between(0, 2) == 0)
                        revise.removed = true;
                    else if (between(0, 1) == 0)
                        revise.radiusMm = between(2, 8);
                    else
                        revise.depthMm = between(1, 9);
                    if (between(0, 4) == 0)
                        revise.layer = between(1, layers);
                    edit = revise;
                    if (between(0, 5) == 0)
                        edit = RevertRows{{any.row}};
                }
                const bool applied = bool(bench.attempt(edit));
                const RowId now = bench.session->history().position();
                if (applied && now != position) {
                    if (const auto* stroke = edit.as<DrillStroke>())
                        truth.draw(now, quantised(*stroke).get<DrillStroke>(), before);
                    if (const auto* revert = edit.as<RevertRows>())
                        truth.setStanding(revert->rows.front(), false);
                    if (const auto* revise = edit.as<ReviseStroke>()) {
                        const Edit& drawn = bench.session->history().row(revise->row).edit;
                        truth.setStroke(
                            revise->row, revised(*sculptEdit(drawn), *revise)->get<DrillStroke>());
                        truth.setStanding(revise->row, !revise->removed);
                        ++revisions;
                    }
                }
                // A row that changed nothing has none, but what it says must be true then as well.
                truths[now] = truth;
                QVERIFY2(bench.coverage() == truths.at(now).coverage(),
                    qPrintable(QStringLiteral("sequence %1, step %2: %3")
                                   .arg(sequence)
                                   .arg(step)
                                   .arg(applied ? bench.lastRow().name : QString())));
                if (now != 1 && between(0, 6) == 0) {
                    QVERIFY(bench.session->undo());
                    QVERIFY(bench.session->settle());
                }
            }
        }
        QVERIFY(revisions > 2 * sequences);
    }
};

BURIN_TEST(ReviseTest)

} // namespace reviseTest

#include "ReviseTest.moc"
