// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/SeedStrokes.h"

#include "core/edits/EditJson.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/recipe/RecipeElsewhere.h"
#include "core/session/EditSession.h"
#include "core/sessionfile/HistoryListing.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/growth/LeakPhantoms.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QTemporaryDir>
#include <QTest>

namespace seedStrokesTest {

using namespace core;

namespace {

constexpr glm::ivec3 size{60, 8, 8};

/// A bar of three tissues along x: 300, 450 and 600, each ± 10.
LoadedVolume threeTissues()
{
    test::Random random(3);
    test::LeakPhantom phantom;
    phantom.codes = test::noiseVolume(size, 20, random);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                phantom.codes.at({x, y, z}) =
                    std::uint16_t(phantom.codes.at({x, y, z}) + 290 + 150 * (x / 20));
    return test::loadedVolume(phantom);
}

/// Places along the bar.
SeedStroke seeds(const std::vector<int>& places, int segment = 1)
{
    SeedStroke stroke{segment, {}};
    for (const int x : places)
        stroke.pointsLps.push_back(threeTissues().volume.geometry.toWorld({x, 4, 4}));
    return stroke;
}

Edit grow(std::optional<bool> perStroke, std::optional<double> sigmas = 2.0)
{
    return test::growBy({.lower = 0.0, .upper = 2000.0, .sigmas = sigmas, .perStroke = perStroke});
}

/// A session with segments 1 and 2.
class Bench {
public:
    enum class Begin { Segments, Bare };
    explicit Bench(Begin begin = Begin::Segments, const QString& file = {})
    {
        session = *EditSession::create(m_engine, threeTissues(), {.file = file});
        if (begin == Begin::Bare)
            return;
        run(test::addSegment("A"));
        run(test::addSegment("B"));
    }
    Bench& run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        if (!applied)
            qFatal("%s", qPrintable(applied.error().arguments.join(u' ')));
        if (!session->settle())
            qFatal("it does not settle");
        return *this;
    }
    void walk(const Result<void>& walked)
    {
        QVERIFY(walked);
        QVERIFY(session->settle());
    }
    /// Of a tissue, 0 … 2; 1280 are all.
    [[nodiscard]] int grown(int tissue) const
    {
        reference::DenseFields fields = m_engine.fields();
        int count = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 20 * tissue; x < 20 * tissue + 20; ++x)
                    count += fields.labels(0).at({x, y, z}) != 0 ? 1 : 0;
        return count;
    }
    [[nodiscard]] QByteArray hash() const { return session->stateHash(); }
    [[nodiscard]] RowId row() const { return session->history().position(); }
    [[nodiscard]] std::vector<SeedGroup> strokes() const
    {
        return seedStrokes(session->history(), session->document(), 0);
    }

private:
    reference::ReferenceEngine m_engine; ///< outlives the session

public:
    std::unique_ptr<EditSession> session;
};

} // namespace

/// A growth by strokes finds its strokes in the history: the same wherever it is carried out.
class SeedStrokesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void eachStrokeLetsItsOwnTissueIn()
    {
        Bench together;
        together.run(seeds({10})).run(seeds({50})).run(grow(std::nullopt));
        QCOMPARE(together.grown(1), 1280);
        Bench apart;
        apart.run(seeds({10})).run(seeds({50})).run(grow(true));
        QCOMPARE(apart.grown(0), 1280);
        QCOMPARE(apart.grown(1), 0);
        QCOMPARE(apart.grown(2), 1280);
        // One stroke in two tissues is one.
        Bench one;
        one.run(seeds({10, 50})).run(grow(true));
        QCOMPARE(one.grown(1), 1280);
    }

    /// What is not asked for is not written, and sessions of before stay as they are.
    void whatIsAbsentStaysAbsent()
    {
        Bench old;
        old.run(seeds({10})).run(seeds({50})).run(grow(std::nullopt));
        const QJsonObject json = editToJson(old.session->history().row(old.row()).edit);
        QVERIFY(!json.contains(QStringLiteral("perStroke")));
        Bench told;
        told.run(seeds({10})).run(seeds({50})).run(grow(false));
        QCOMPARE(told.hash(), old.hash());
        // Without sigmas it says nothing.
        Bench whole;
        whole.run(seeds({10})).run(seeds({50})).run(grow(true, std::nullopt));
        QCOMPARE(whole.grown(1), 1280);
    }

    void onlyStrokesThatStandCount()
    {
        // The third stroke holds both seeds: by itself it would let everything in.
        Bench never;
        never.run(seeds({10})).run(seeds({50}));
        Bench reverted;
        reverted.run(seeds({10})).run(seeds({50})).run(seeds({10, 50, 30}));
        QCOMPARE(reverted.strokes().size(), std::size_t(3));
        Bench undone;
        undone.run(seeds({10})).run(seeds({50})).run(seeds({10, 50, 30}));

        never.run(grow(true));
        QCOMPARE(never.grown(1), 0);
        reverted.run(test::revertRows({reverted.row()}));
        QCOMPARE(reverted.strokes().size(), std::size_t(2));
        reverted.run(grow(true));
        QCOMPARE(reverted.hash(), never.hash());
        undone.walk(undone.session->undo());
        QCOMPARE(undone.strokes().size(), std::size_t(2));
        undone.run(grow(true));
        QCOMPARE(undone.hash(), never.hash());
    }

    /// What a growth has read cannot be taken back from under it.
    void aStrokeThatWasReadIsEntangled()
    {
        Bench bench;
        bench.run(seeds({10})).run(seeds({50}));
        const RowId stroke = bench.row();
        bench.run(grow(true));
        const QByteArray hash = bench.hash();
        Result<void> result = bench.session->apply(test::revertRows({stroke}));
        if (result)
            result = bench.session->settle();
        QVERIFY(!result && result.error().code == ErrorCode::StepsEntangled);
        QCOMPARE(bench.hash(), hash);
    }

    void strokesOfOthersAndThoseThatAreGoneAreNone()
    {
        Bench bench;
        bench.run(seeds({10})).run(seeds({50}, 2)).run(seeds({52}, 2));
        SeedStroke moved = seeds({12});
        moved.takenLps = seeds({10}).pointsLps;
        bench.run(moved);
        SeedStroke taken = seeds({});
        taken.takenLps = seeds({12}).pointsLps;
        bench.run(taken);
        QCOMPARE(bench.strokes().size(), std::size_t(4)); // the last one names no place
        bench.run(RemoveSegment{.segment = 2});
        const std::vector<SeedGroup> strokes = bench.strokes();
        QCOMPARE(strokes.size(), std::size_t(2));
        QVERIFY(strokes[0].label == 1 && strokes[0].voxels.front().x == 10);
        QVERIFY(strokes[1].label == 1 && strokes[1].voxels.front().x == 12);
    }

    /// Steps that follow the growth go by strokes as well, and by new ones.
    void laterStepsGoByStrokesToo()
    {
        Bench bench;
        bench.run(seeds({10})).run(grow(true));
        QCOMPARE(bench.grown(0), 1280);
        QCOMPARE(bench.grown(1), 0);
        bench.run(seeds({50})).run(ResumeGrowth{});
        QCOMPARE(bench.grown(1), 0);
        QCOMPARE(bench.grown(2), 1280);
        ChangeInterval narrower;
        narrower.criteria.upper = 500.0;
        bench.run(narrower);
        const Edit& row = bench.session->history().row(bench.row()).edit;
        QCOMPARE(row.get<ChangeInterval>().criteria.perStroke, std::optional(true));
        QVERIFY(row.get<ChangeInterval>().fromSeeds.value_or(false));
        QCOMPARE(bench.grown(0), 1280);
        QCOMPARE(bench.grown(2), 0);
    }

    /// Under a slider a growth begins anew by the same strokes.
    void aSliderGoesByStrokesToo()
    {
        Bench dragged;
        dragged.run(seeds({10})).run(seeds({50})).run(grow(true));
        ChangeInterval change;
        change.criteria.upper = 1000.0;
        QVERIFY(dragged.session->begin(change));
        dragged.session->extend(ToInterval{.lower = 0.0, .upper = 500.0});
        dragged.session->extend(ToInterval{.lower = 0.0, .upper = 1000.0});
        dragged.session->extend(GrowAdvance{});
        dragged.session->end(Ending::Commit);
        QVERIFY(dragged.session->settle());
        QCOMPARE(dragged.grown(1), 0);
        QCOMPARE(dragged.grown(2), 1280);
        Bench whole;
        whole.run(seeds({10})).run(seeds({50})).run(grow(true)).run(change);
        QCOMPARE(whole.hash(), dragged.hash());
    }

    /// Rows that are carried out again when a session opens meet the strokes that stood before
    /// them, not those of where the session stands.
    void rowsWithoutTheirSecondHalfFindTheirStrokes()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("s.burin"));
        QByteArray hash;
        std::vector<QByteArray> hashes;
        {
            Bench bench(Bench::Begin::Segments, path);
            bench.run(seeds({10})).run(seeds({50})).run(grow(true)); // row 5
            bench.run(seeds({31})).run(seeds({10, 50, 32})).run(grow(true, 2.5));
            QVERIFY(bench.session->undo());
            QVERIFY(bench.session->settle());
            hash = bench.hash();
            for (const HistoryRow& row : bench.session->history().rows())
                hashes.push_back(row.stateHash);
        }
        QVERIFY(test::runSql(path,
            QStringLiteral(
                "UPDATE row SET stateHash=NULL, deltaSha256=NULL, seal=NULL WHERE id>=5")));
        test::runSql(path, QStringLiteral("DELETE FROM delta WHERE row>=5"));
        reference::ReferenceEngine engine;
        auto opened = EditSession::open(engine, threeTissues(), path);
        QVERIFY2(opened, qPrintable(opened ? QString() : opened.error().arguments.join(u' ')));
        QVERIFY((*opened)->settle());
        QCOMPARE((*opened)->stateHash(), hash);
        for (std::size_t i = 0; i < hashes.size(); ++i)
            QCOMPARE((*opened)->history().rows()[i].stateHash, hashes[i]);
    }

    /// As a recipe, rows have other numbers.
    void aRecipeFindsTheSameStrokes()
    {
        Bench bench;
        bench.run(seeds({12}));
        bench.walk(bench.session->undo());
        bench.run(seeds({10})).run(seeds({50})).run(seeds({10, 50, 30}));
        bench.run(test::revertRows({bench.row()})).run(grow(true));
        QCOMPARE(bench.grown(1), 0);
        Bench again(Bench::Begin::Bare);
        std::map<RowId, RowId> numbers;
        const History& history = bench.session->history();
        for (const RowId id : history.pathTo(history.position())) {
            again.run(renumbered(history.row(id).edit, numbers));
            numbers.emplace(id, RowId(numbers.size()) + 1);
        }
        QCOMPARE(again.hash(), bench.hash());
    }

    /// On another study, where strokes are left out of a recipe, a growth goes by those made there.
    void elsewhereTheStrokesMadeThereCount()
    {
        RecipeElsewhere recipe({.path = QStringLiteral("r.json"),
            .study = {},
            .steps = {seeds({10, 50, 30}), grow(true)},
            .entries = {},
            .withoutSurface = {},
            .exports = {}});
        Bench elsewhere;
        elsewhere.run(seeds({10})).run(seeds({50}));
        QVERIFY(!recipe.here(0, elsewhere.session->document()));
        const auto growth = recipe.here(1, elsewhere.session->document());
        QVERIFY(growth);
        elsewhere.run(*growth);
        QCOMPARE(elsewhere.grown(1), 0);
        QCOMPARE(elsewhere.grown(2), 1280);
    }
};

BURIN_TEST(SeedStrokesTest)

} // namespace seedStrokesTest

#include "SeedStrokesTest.moc"
