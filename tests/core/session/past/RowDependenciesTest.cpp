// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/RowDependencies.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/engine/EngineCommands.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QTest>

#include <algorithm>

namespace rowDependenciesTest {

using namespace core;

namespace {

EngineResult resultOf(
    reference::ReferenceEngine& engine, const Edit& stroke, const Document& document)
{
    const DrillCut cut = test::drillCutOf(stroke, document);
    const Ticket ticket = submitWhole(engine, cut, {DrillPath{test::drillSamplesOf(stroke, cut)}});
    engine.finish();
    for (EngineResult& result : engine.collect()) {
        if (result.ticket == ticket)
            return std::move(result);
    }
    return {};
}

bool equal(const std::vector<BrickChange>& a, const std::vector<BrickChange>& b)
{
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const BrickChange& x, const BrickChange& y) {
            return x.key == y.key && x.before == y.before && x.after == y.after;
        });
}

} // namespace

class RowDependenciesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Whatever was cut outside a stroke's reach, the stroke comes out the same; so it may be taken
    /// away again.
    void aStrokeDoesNotSeeBeyondItsReach()
    {
        int bricksOutside = 0;
        int strokesThatCut = 0;
        int behind = 0;
        const int count = test::longRun() ? 300 : 16;
        // Few strokes have bricks behind what they cut; three of these do.
        const std::uint32_t first = test::longRun() ? 4000 : 4020;
        for (int number = 0; number < count; ++number) {
            test::Random random{first + std::uint32_t(number)};
            const int slices = test::randomInt(random, 20, 60);
            const int rows = test::randomInt(random, 20, 60);
            const glm::ivec3 size(test::randomInt(random, 90, 200), rows, slices);
            const Document document = test::randomDocument(size, random, number % 2 != 0);
            const std::vector<std::uint16_t> codes = test::balls(size, 9, random).values;
            const Edit stroke = test::drillWith({.layer = 1}, test::randomDrill(document, random));
            reference::ReferenceEngine engine;
            QVERIFY(engine.openVolume(size, codes));
            const EngineResult result = resultOf(engine, stroke, document);
            const std::vector<BrickChange>& alone = result.changes;
            const RowDependencies dependencies(
                stroke, document, {}, {.searchedTo = result.statistics.searchedTo});
            const RowDependencies whole(stroke, document, {});
            for (const BrickChange& change : alone)
                QVERIFY(dependencies.covers(change.key));
            strokesThatCut += alone.empty() ? 0 : 1;

            QVERIFY(engine.openVolume(size, codes));
            SwapBricks cuts;
            const BrickGrid grid{size};
            for (int brick = 0; brick < grid.brickCount(); ++brick) {
                // In whichever layer: a stroke sees all of them.
                const BrickKey key{
                    Field::Coverage, std::uint8_t(1 + brick % 2), std::uint32_t(brick)};
                QVERIFY(whole.covers(key) || !dependencies.covers(key));
                behind += whole.covers(key) && !dependencies.covers(key) ? 1 : 0;
                if (dependencies.covers(key))
                    continue;
                std::vector<std::uint8_t> bytes(BrickGrid::voxelsPerBrick, 0);
                const VoxelBox box = grid.boxOf(brick);
                for (int z = box.minimum.z; z < box.maximum.z; ++z)
                    for (int y = box.minimum.y; y < box.maximum.y; ++y)
                        for (int x = box.minimum.x; x < box.maximum.x; ++x)
                            bytes[std::size_t(BrickGrid::offsetInBrick({x, y, z}))] =
                                std::uint8_t(128 + random() % 128);
                cuts.bricks.push_back({key, std::move(bytes)});
                ++bricksOutside;
            }
            engine.submit(std::move(cuts));
            engine.finish();
            static_cast<void>(engine.collect());
            QVERIFY2(equal(resultOf(engine, stroke, document).changes, alone),
                qPrintable(QString::number(number)));
        }
        // Otherwise nothing was asked.
        QVERIFY2(bricksOutside > 5 * count, qPrintable(QString::number(bricksOutside)));
        QVERIFY(strokesThatCut > count / 3);
        QVERIFY2(behind > count / 2, qPrintable(QString::number(behind)));
        qInfo("%d bricks outside, %d of them behind the cut", bricksOutside, behind);
    }

    /// What is carved under the mask counts, in whichever layer.
    void aStrokeSeesAllLayers()
    {
        test::Random random{9};
        const Document document = test::randomDocument({64, 48, 48}, random, false);
        const Edit stroke = test::drillWith({.layer = 1}, test::randomDrill(document, random));
        const RowDependencies dependencies(stroke, document, {});
        const BrickGrid grid{document.volumes.front().geometry.size};
        int covered = 0;
        for (int brick = 0; brick < grid.brickCount(); ++brick) {
            const bool own = dependencies.covers({Field::Coverage, 1, std::uint32_t(brick)});
            QCOMPARE(dependencies.covers({Field::Coverage, 2, std::uint32_t(brick)}), own);
            QCOMPARE(dependencies.covers({Field::Coverage, 255, std::uint32_t(brick)}), own);
            covered += own ? 1 : 0;
        }
        QVERIFY(covered > 0);
    }

    /// Brushes write nothing beyond their reach, and do not care what stands there; nor do they
    /// reach far.
    void brushesReachTheirBricksOnly()
    {
        int wrote = 0;
        int bricksNotNeeded = 0;
        int bricksCovered = 0;
        for (int number = 0; number < (test::longRun() ? 300 : 30); ++number) {
            test::Random random{std::uint32_t(8000 + number)};
            const glm::ivec3 size(90, 40, 60);
            Document document = test::randomDocument(size, random, number % 2 != 0);
            document.segments.push_back({.label = 1});
            PaintStroke paint = test::randomPaint(document, random);
            paint.erase = false;
            paint.lower.reset();
            paint.upper.reset();
            // What a brush that follows edges leaves out where the pen is outside the volume counts
            // as unwritten below.
            if (number % 4 != 0) {
                paint.edgeTolerance.reset();
                paint.toleranceByPressure.reset();
            }
            BrushStroke brush = test::randomBrush(document, random);
            brush.restore = false;
            const std::vector<std::uint16_t> codes(std::size_t(size.x) * size.y * size.z, 7);
            reference::ReferenceEngine engine;
            QVERIFY(engine.openVolume(size, codes));
            const VolumeGeometry& geometry = document.volumes.front().geometry;
            submitWhole(engine, *paintLabel(paint, document), {paintPath(paint, geometry)});
            submitWhole(engine, *capsuleCut(brush, document),
                {CapsulePath{capsules(brush.path, geometry)}});
            const std::vector<EngineResult> results = engine.collect();
            for (std::size_t which = 0; which < 2; ++which) {
                const RowDependencies dependencies(
                    which == 0 ? Edit(paint) : Edit(brush), document, {});
                for (const BrickChange& change : results[which].changes)
                    QVERIFY(dependencies.covers(change.key));
                wrote += results[which].changes.empty() ? 0 : 1;
                const Field field = which == 0 ? Field::Labels : Field::Coverage;
                const auto plane = std::uint8_t(which == 0 ? 0 : brush.layer);
                for (int brick = 0; brick < BrickGrid{size}.brickCount(); ++brick) {
                    const BrickKey key{field, plane, std::uint32_t(brick)};
                    const bool needed =
                        std::any_of(results[which].changes.begin(), results[which].changes.end(),
                            [&key](const BrickChange& change) { return change.key == key; });
                    bricksCovered += dependencies.covers(key) ? 1 : 0;
                    bricksNotNeeded += dependencies.covers(key) && !needed ? 1 : 0;
                }
                QVERIFY(!dependencies.covers({field, std::uint8_t(plane + 1), 0}));
            }
        }
        QVERIFY(wrote > 30);
        QVERIFY2(
            bricksNotNeeded * 3 < bricksCovered * 2, qPrintable(QString::number(bricksNotNeeded)));
        qInfo("%d bricks in reach, %d of them unwritten", bricksCovered, bricksNotNeeded);
    }

    void seedsReachTheirBricksOnly()
    {
        test::Random random{7};
        const Document document = [&] {
            Document made = test::randomDocument({48, 32, 32}, random, false);
            made.segments.push_back({.label = 1, .name = {}, .rgb = 0, .code = {}});
            if (made.growths.empty())
                made.growths.push_back({.plane = 0, .generation = 0});
            return made;
        }();
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        const Edit seed = test::seedAt(1, {geometry.toWorld(glm::dvec3(20, 3, 17))});
        const RowDependencies dependencies(seed, document, {});
        const BrickGrid grid{geometry.size};
        for (int brick = 0; brick < grid.brickCount(); ++brick) {
            QCOMPARE(dependencies.covers({Field::SeedWords, 0, std::uint32_t(brick)}),
                brick == grid.brickOf({20, 3, 17}));
            QVERIFY(!dependencies.covers({Field::Coverage, 1, std::uint32_t(brick)}));
        }
        const RowDependencies growth(test::growBetween(0.0, 0.0), document, {});
        QVERIFY(growth.covers({Field::SeedWords, 0, 3}));
        QVERIFY(growth.covers({Field::Labels, 0, 3}));
        QVERIFY(!growth.covers({Field::Labels, 1, 3}));
        QVERIFY(!growth.covers({Field::Coverage, 0, 3}));
        const RowDependencies removal(RemoveSegment{.segment = 1}, document, {});
        QVERIFY(removal.covers({Field::SeedWords, 0, 3}));
        QVERIFY(removal.covers({Field::Labels, 0, 3}));
        QVERIFY(!removal.covers({Field::Coverage, 1, 3}));
        for (const Edit& wholePlane :
            std::vector<Edit>{InvertSegment{.segment = 1}, CombineSegments{.segment = 1, .with = 2},
                ReshapeSegment{.segment = 1, .mm = 1.0}, FillBetweenSlices{.segment = 1},
                MirrorSegment{.segment = 1}, EvolveContour{.segment = 1},
                ThresholdSegment{.segment = 1}, SplitIslands{.segment = 1},
                SplitSegment{.segment = 1}, SplitByCurve{.segment = 1}}) {
            const RowDependencies whole(wholePlane, document, {});
            QVERIFY(whole.covers({Field::SeedWords, 0, 3}));
            QVERIFY(whole.covers({Field::Labels, 0, 3}));
            QVERIFY(!whole.covers({Field::Labels, 1, 3}));
            QVERIFY(!whole.covers({Field::Coverage, 1, 3}));
        }
        // A merge of two label planes writes to both.
        Document further = document;
        further.segments.push_back({.label = 2, .plane = 1, .name = {}, .rgb = 0, .code = {}});
        const RowDependencies merged(CombineSegments{.segment = 1, .with = 2}, further, {});
        for (const std::uint8_t plane : {0, 1}) {
            QVERIFY(merged.covers({Field::SeedWords, plane, 3}));
            QVERIFY(merged.covers({Field::Labels, plane, 3}));
        }
        const RowDependencies copied(CopySegment{.segment = 1, .plane = 2}, document, {});
        QVERIFY(copied.covers({Field::Labels, 0, 3}) && copied.covers({Field::Labels, 2, 3}));
        QVERIFY(copied.covers({Field::SeedWords, 2, 3}) && !copied.covers({Field::Labels, 1, 3}));
        FloodFill flood{.segment = 1, .placeLps = geometry.toWorld(glm::dvec3(20, 3, 17))};
        const RowDependencies everywhere(flood, document, {});
        flood.within = SliceAxis::K;
        const RowDependencies inSlice(flood, document, {});
        for (int brick = 0; brick < grid.brickCount(); ++brick) {
            const BrickKey key{Field::Labels, 0, std::uint32_t(brick)};
            QVERIFY(everywhere.covers(key));
            QCOMPARE(inSlice.covers(key), grid.boxOf(brick).minimum.z == 16);
        }
        // Of an oblique one: where x + y / 2 is about what it is at the place.
        flood.within.reset();
        const glm::dmat3 gradients = glm::transpose(glm::dmat3(geometry.worldToIndex()));
        flood.normalLps = gradients[0] + 0.5 * gradients[1];
        const RowDependencies inOblique(flood, document, {});
        int beside = 0;
        for (int brick = 0; brick < grid.brickCount(); ++brick) {
            const VoxelBox box = grid.boxOf(brick);
            const double least = box.minimum.x + 0.5 * box.minimum.y - 21.5;
            const double greatest = box.maximum.x - 1 + 0.5 * (box.maximum.y - 1) - 21.5;
            const bool covers = inOblique.covers({Field::Labels, 0, std::uint32_t(brick)});
            QVERIFY(covers || least > 0.5 || greatest < -0.5);
            beside += covers ? 0 : 1;
        }
        QVERIFY(beside >= 4);
        const RowDependencies visible(
            ThresholdSegment{.segment = 1, .onlyVisible = true}, document, {});
        QVERIFY(visible.covers({Field::SeedWords, 0, 3}) && visible.covers({Field::Labels, 0, 3}));
        QVERIFY(visible.covers({Field::Coverage, 1, 3}) && !visible.covers({Field::Labels, 1, 3}));
        const BrickKey written{Field::Labels, 0, 2};
        const RowDependencies revert(test::revertRows({1}), document, {written});
        QVERIFY(revert.covers(written));
        QVERIFY(!revert.covers({Field::Labels, 0, 3}));
    }

    /// In all planes; anywhere, where nobody has looked where its voxels are.
    void importsReachTheirBricksOnly()
    {
        test::Random random{7};
        const Document document = test::randomDocument({48, 32, 32}, random, false);
        const Edit mask = ImportMask{.file = QStringLiteral("organs.seg.nrrd")};
        const BrickKey written{Field::Overwritten, 0, 2};
        const RowDependencies known(
            mask, document, {written}, {.importedTo = std::set<std::uint32_t>{3, 5}});
        const RowDependencies unknown(mask, document, {written});
        for (std::uint32_t brick = 0; brick < 12; ++brick) {
            for (const int plane : {0, 1, 3}) {
                for (const Field field : {Field::Labels, Field::SeedWords}) {
                    const BrickKey key{field, std::uint8_t(plane), brick};
                    QCOMPARE(known.covers(key), brick == 3 || brick == 5);
                    QVERIFY(unknown.covers(key));
                }
            }
            QVERIFY(!known.covers({Field::Coverage, 1, brick}));
            QVERIFY(!unknown.covers({Field::Coverage, 1, brick}));
        }
        QVERIFY(known.covers(written) && unknown.covers(written));
    }
};

BURIN_TEST(RowDependenciesTest)

} // namespace rowDependenciesTest

#include "RowDependenciesTest.moc"
