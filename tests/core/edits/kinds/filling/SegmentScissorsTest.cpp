// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/engine/CutFrames.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/session/EditSession.h"
#include "core/session/past/RowDependencies.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/cases/strokes/StrokeScene.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace segmentScissorsTest {

using namespace core;

namespace {

constexpr int side = 24; // voxels of 1 mm

/// A session with the segments One, Two and Three; voxels of 1 mm, or those of a document.
struct Bench : test::SessionBench {
    explicit Bench(const Document& scene = plainScene())
        : SessionBench(true,
            test::loaded(scene, test::constantVolume(scene.volumes.front().geometry.size, 100)))
    {
        for (const char* name : {"One", "Two", "Three"})
            run(test::segmentNamed(name));
    }
    [[nodiscard]] static Document plainScene()
    {
        Document scene;
        scene.volumes.emplace_back();
        scene.volumes.front().geometry.size = glm::ivec3(side);
        return scene;
    }
};

template <class Visit> void forEachVoxel(const glm::ivec3& size, Visit visit)
{
    std::size_t place = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z), place++);
}

/// Looks along k, x to the right and y downwards, at the middle of the first slice; a rectangle
/// around the voxels from one to another, both included.
SegmentScissors alongSlices(int segment, const glm::ivec2& from, const glm::ivec2& to)
{
    SegmentScissors edit{.segment = segment};
    edit.view.targetLps = {side / 2.0, side / 2.0, 0.0};
    edit.view.eyeLps = edit.view.targetLps - glm::dvec3(0.0, 0.0, 100.0);
    edit.view.up = {0.0, -1.0, 0.0};
    const double left = from.x - 0.5 - side / 2.0;
    const double right = to.x + 0.5 - side / 2.0;
    const double top = side / 2.0 - (from.y - 0.5);
    const double bottom = side / 2.0 - (to.y + 0.5);
    edit.polygonMm = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
    return edit;
}

/// All voxels of a slice.
FillOutline sheet(int segment, int slice)
{
    return {.segment = segment,
        .originLps = {0.0, 0.0, double(slice)},
        .polygonMm = {{-1.0, -1.0}, {side, -1.0}, {side, side}, {-1.0, side}}};
}

double distanceToEdge(const glm::dvec2& place, const glm::dvec2& from, const glm::dvec2& to)
{
    const glm::dvec2 along = to - from;
    const double squared = glm::dot(along, along);
    const double t =
        squared > 0.0 ? std::clamp(glm::dot(place - from, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(place, from + t * along);
}

/// By the angles under which a place sees the edges; none where it is too near to one.
std::optional<bool> windsAround(
    const std::vector<glm::dvec2>& polygon, const glm::dvec2& place, double nearMm)
{
    double turned = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 from = polygon[i] - place;
        const glm::dvec2 to = polygon[(i + 1) % polygon.size()] - place;
        if (distanceToEdge(glm::dvec2(0.0), from, to) < nearMm)
            return std::nullopt;
        turned += std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
    }
    return std::lround(turned / (2.0 * std::numbers::pi)) != 0;
}

Document randomScene(int number, test::Random& random)
{
    return test::randomDocument({24, 22, 20}, random, number % 2 == 1);
}

} // namespace

class SegmentScissorsTest : public QObject {
    Q_OBJECT

    static void numbers(int count)
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < count; ++number)
            QTest::addRow("%d", number) << number;
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void reachesWhereTheScissorsCarve_data() { numbers(16); }
    /// What lies under a curve is the same for the scissors that carve; and what does not lie there
    /// is all the rest that is not hidden.
    void reachesWhereTheScissorsCarve()
    {
        QFETCH(const int, number);
        test::Random random(std::uint32_t(5100 + number));
        const Document scene = randomScene(number, random);
        ScissorsCut carve = test::randomScissors(scene, random);
        carve.layer = 1;
        carve.restore = false;
        carve.firstLayerOnly = false;
        carve.depthMm.reset();
        Bench bench(scene);
        bench.run(carve);
        SegmentScissors fill{.segment = 2, .view = carve.view, .polygonMm = carve.polygonMm};
        fill.hidden = carve.hidden;
        bench.run(fill);
        const std::vector<std::uint8_t> filled = bench.labels();
        bench.run(LayerToSegment{
            .layer = 1, .target = {.segment = 1, .name = {}}, .overwriteUnlocked = true});
        const std::vector<std::uint8_t> carved = bench.labels();
        for (std::size_t place = 0; place < carved.size(); ++place)
            QCOMPARE(carved[place] == 1, filled[place] == 2);
        fill.segment = 3;
        fill.outside = true;
        bench.run(fill);
        if (!fill.hidden) {
            const std::vector<std::uint8_t> all = bench.labels();
            for (std::size_t place = 0; place < carved.size(); ++place)
                QCOMPARE(int(all[place]), filled[place] == 2 ? 1 : 3);
        }
    }

    void fillsWhatTheCurveWindsAround_data() { numbers(24); }
    /// Against double precision and angles, in grids of any spacing, some of them sheared, from any
    /// side. Where an element of the view's plane is half covered nobody minds.
    void fillsWhatTheCurveWindsAround()
    {
        QFETCH(const int, number);
        test::Random random(std::uint32_t(5300 + number));
        const Document scene = randomScene(number, random);
        Bench bench(scene);
        const VolumeGeometry& geometry = bench.geometry();
        const ScissorsCut from = test::randomScissors(scene, random);
        SegmentScissors edit{.segment = 1, .view = from.view};
        edit.view.targetLps = geometry.toWorld(glm::dvec3(geometry.size) / 2.0);
        edit.view.eyeLps = edit.view.targetLps - (from.view.targetLps - from.view.eyeLps);
        edit.polygonMm = test::randomOutline(8.0 + 8.0 * test::randomUnit(random), random);
        bench.run(edit);
        edit = quantised(edit).get<SegmentScissors>();
        const glm::dvec3 forward = glm::normalize(edit.view.targetLps - edit.view.eyeLps);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, edit.view.up));
        const glm::dvec3 up = glm::cross(right, forward);
        const double nearMm = 2.5 * elementPitch(geometry, 60.0) / 65536.0;
        const std::vector<std::uint8_t> labels = bench.labels();
        int compared = 0;
        forEachVoxel(geometry.size, [&](const glm::ivec3& voxel, std::size_t place) {
            const glm::dvec3 away = geometry.toWorld(glm::dvec3(voxel)) - edit.view.targetLps;
            const std::optional<bool> winds =
                windsAround(edit.polygonMm, {glm::dot(away, right), glm::dot(away, up)}, nearMm);
            if (!winds)
                return;
            QCOMPARE(int(labels[place]), *winds ? 1 : 0);
            ++compared;
            ++(*winds ? m_inside : m_outside);
        });
        QVERIFY2(compared > 1000, qPrintable(QString::number(compared)));
        if (++m_outlines == 24)
            QVERIFY(m_inside > 2000 && m_outside > 2000);
    }

    /// Voxels of whole millimetres under a rectangle between them.
    void exactlyTheVoxelsUnderARectangle()
    {
        Bench bench;
        bench.run(alongSlices(1, {3, 5}, {10, 8}));
        const std::vector<std::uint8_t> labels = bench.labels();
        forEachVoxel(bench.geometry().size, [&](const glm::ivec3& voxel, std::size_t place) {
            const bool under = voxel.x >= 3 && voxel.x <= 10 && voxel.y >= 5 && voxel.y <= 8;
            QCOMPARE(int(labels[place]), under ? 1 : 0);
        });
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Scissors fill 'One' inside, +%1 voxels").arg(8 * 4 * side));
        SegmentScissors keep = alongSlices(1, {5, 5}, {6, 8});
        keep.erase = true;
        keep.outside = true;
        bench.run(keep);
        QCOMPARE(bench.voxels(1), std::int64_t(2 * 4 * side));
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Scissors erase 'One' outside, −%1 voxels").arg(6 * 4 * side));
    }

    /// A depth is counted from the first voxel of the segments that are erased, on each line of
    /// sight, so that one sheet goes after the other.
    void erasesWhatIsSeen()
    {
        Bench bench;
        for (const int slice : {4, 12, 19})
            bench.run(sheet(slice == 12 ? 2 : 1, slice));
        SegmentScissors edit = alongSlices(1, {2, 2}, {9, 6});
        edit.erase = true;
        edit.depthMm = 3.0;
        const std::int64_t all = side * side;
        constexpr std::int64_t under = 8 * 5;
        bench.run(edit);
        QCOMPARE(bench.voxels(1), 2 * all - under);
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Scissors erase 'One' inside, 3.0 mm deep, −40 voxels"));
        bench.run(edit); // through Two, which is not meant, to the next sheet of One
        QCOMPARE(bench.voxels(1), 2 * (all - under));
        QCOMPARE(bench.voxels(2), all);
        const std::size_t rows = bench.rows().size();
        bench.run(edit); // nothing is left
        QCOMPARE(bench.rows().size(), rows);
        // Of both segments what is seen first is Two where One is gone, and One beside that.
        SegmentScissors both = alongSlices(1, {0, 2}, {9, 6});
        both.erase = true;
        both.depthMm = 3.0;
        both.others = std::vector<int>{2};
        bench.run(both);
        QCOMPARE(bench.voxels(1), 2 * (all - under) - 2 * 5);
        QCOMPARE(bench.voxels(2), all - under);
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Scissors erase 2 segments inside, 3.0 mm deep, −50 voxels"));
        // From behind the sheet at 19 is the first.
        both.view.eyeLps.z = 200.0;
        both.view.up = {0.0, 1.0, 0.0};
        for (glm::dvec2& point : both.polygonMm)
            point.y = -point.y;
        both.others.reset();
        both.polygonMm = {{-3.0, -3.0}, {3.0, -3.0}, {3.0, 3.0}, {-3.0, 3.0}};
        const std::vector<std::uint8_t> before = bench.labels();
        bench.run(both);
        const std::vector<std::uint8_t> after = bench.labels();
        int gone = 0;
        forEachVoxel(bench.geometry().size, [&](const glm::ivec3& voxel, std::size_t place) {
            if (before[place] == after[place])
                return;
            QCOMPARE(voxel.z, 19);
            ++gone;
        });
        QVERIFY(gone > 20);
    }

    /// A depth reaches through so many millimetres, and filling counts it from the first value that
    /// may be filled; what is hidden neither is filled nor counts.
    void fillsToADepth()
    {
        Bench bench;
        SegmentScissors edit = alongSlices(1, {2, 2}, {9, 6});
        edit.depthMm = 5.2;
        bench.run(edit); // from the border of the volume, half a voxel in front of the first centre
        const auto depthOf = [&](int label) {
            const std::vector<std::uint8_t> labels = bench.labels();
            int last = -1;
            forEachVoxel(bench.geometry().size, [&](const glm::ivec3& voxel, std::size_t place) {
                if (labels[place] == label)
                    last = std::max(last, voxel.z);
            });
            return last;
        };
        QVERIFY(depthOf(1) == 4 || depthOf(1) == 5);
        QCOMPARE(bench.voxels(1), std::int64_t(8 * 5 * (depthOf(1) + 1)));
        edit.segment = 2;
        edit.hidden = std::vector<ClipHalfSpace>{test::beyond({0.0, 0.0, 9.5}, {0.0, 0.0, -1.0})};
        bench.run(edit); // what lies before 9.5 is hidden
        QCOMPARE(bench.voxels(1), std::int64_t(8 * 5 * (depthOf(1) + 1)));
        QVERIFY(depthOf(2) == 14 || depthOf(2) == 15);
        QCOMPARE(bench.voxels(2), std::int64_t(8 * 5 * (depthOf(2) - 9)));
        edit.lower = 101.0; // no voxel has that
        edit.segment = 3;
        const std::size_t rows = bench.rows().size();
        bench.run(edit);
        QCOMPARE(bench.rows().size(), rows);
    }

    void honoursWhatMayBeChanged()
    {
        Bench bench;
        bench.run(sheet(1, 4));
        SegmentScissors two = alongSlices(2, {0, 0}, {3, 3});
        bench.run(two);
        QCOMPARE(bench.voxels(1), std::int64_t(side * side)); // others stay
        QCOMPARE(bench.voxels(2), std::int64_t(16 * (side - 1)));
        bench.run(test::lockSegment(1));
        two.overwriteUnlocked = true;
        const std::size_t rows = bench.rows().size();
        bench.run(two); // it is locked
        QCOMPARE(bench.rows().size(), rows);
        SegmentScissors both = alongSlices(2, {0, 0}, {3, 3});
        both.erase = true;
        both.others = std::vector<int>{1};
        QCOMPARE(bench.refusal(both), ErrorCode::SegmentLocked);
        bench.run(test::lockSegment(1, false));
        bench.run(two);
        QCOMPARE(bench.voxels(1), std::int64_t(side * side - 16));
        QCOMPARE(bench.voxels(2), std::int64_t(16 * side));
        bench.run(both);
        QCOMPARE(bench.voxels(2), std::int64_t(0));
        QCOMPARE(bench.voxels(1), std::int64_t(side * side - 16));
        both.others.reset();
        both.segment = 1;
        both.upper = 99.0; // there is no such value
        const std::size_t then = bench.rows().size();
        bench.run(both);
        QCOMPARE(bench.rows().size(), then);
    }

    void whatCannotBe()
    {
        Bench bench;
        const SegmentScissors sound = alongSlices(1, {2, 2}, {9, 6});
        const auto refused = [&](ErrorCode code, auto change) {
            SegmentScissors edit = sound;
            change(edit);
            QCOMPARE(bench.refusal(edit), code);
        };
        using Edited = SegmentScissors;
        const ErrorCode field = ErrorCode::InvalidField;
        refused(ErrorCode::UnknownSegment, [](Edited& edit) { edit.segment = 9; });
        refused(ErrorCode::UnknownSegment, [](Edited& edit) {
            edit.erase = true;
            edit.others = std::vector<int>{9};
        });
        refused(field, [](Edited& edit) { edit.others = std::vector<int>{2}; });
        refused(field, [](Edited& edit) {
            edit.erase = true;
            edit.others = std::vector<int>{1};
        });
        refused(field, [](Edited& edit) {
            edit.outside = true;
            edit.depthMm = 3.0;
        });
        refused(field, [](Edited& edit) {
            edit.lower = 5.0;
            edit.upper = 4.0;
        });
        refused(field, [](Edited& edit) { edit.polygonMm.clear(); });
        refused(field, [](Edited& edit) { edit.polygonMm = {{0.0, 0.0}, {0.1, 0.0}, {0.0, 0.1}}; });
        refused(field, [](Edited& edit) { edit.view.eyeLps = edit.view.targetLps; });
        refused(field, [](Edited& edit) { edit.view.up = {0.0, 0.0, 5.0}; });
        bench.run(test::lockSegment(1));
        refused(ErrorCode::SegmentLocked, [](Edited&) {});
        // Beside the volume nothing happens, and no step is made.
        SegmentScissors beside = alongSlices(2, {60, 60}, {70, 70});
        const std::size_t rows = bench.rows().size();
        bench.run(beside);
        QCOMPARE(bench.rows().size(), rows);
    }

    void thereAndBackAndAnew()
    {
        test::Random random(79);
        const Document scene = randomScene(1, random);
        Bench bench(scene);
        std::vector<QByteArray> hashes{bench.session->stateHash()};
        for (int step = 0; step < 20; ++step) {
            SegmentScissors edit = test::randomSegmentScissors(bench.session->document(), random);
            if (step < 4) { // the first ones fill
                edit.erase = false;
                edit.others.reset();
                edit.lower.reset();
                edit.upper.reset();
            }
            const std::size_t rows = bench.rows().size();
            bench.run(edit);
            if (bench.rows().size() > rows)
                hashes.push_back(bench.session->stateHash());
        }
        QVERIFY(hashes.size() > 4);
        for (std::size_t back = hashes.size() - 1; back > 0; --back) {
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hashes[back - 1]);
        }
        for (std::size_t on = 1; on < hashes.size(); ++on) {
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hashes[on]);
        }
        reference::ReferenceEngine engine;
        const auto anew = *EditSession::create(engine,
            test::loaded(scene, test::constantVolume(scene.volumes.front().geometry.size, 100)),
            {.file = {}});
        for (const HistoryRow& row : bench.rows())
            QVERIFY(anew->apply(row.edit) && anew->settle());
        QCOMPARE(anew->stateHash(), hashes.back());
    }

    /// Undoing something else alone asks only about the bricks under the curve; of what lies beside
    /// it, about all.
    void dependsOnItsBricksAlone()
    {
        Bench bench;
        SegmentScissors edit = alongSlices(1, {2, 2}, {9, 6});
        const BrickGrid grid{bench.geometry().size};
        const auto needs = [&](auto isNeeded) {
            const RowDependencies needed(edit, bench.session->document(), {});
            for (int brick = 0; brick < grid.brickCount(); ++brick) {
                for (const Field field : {Field::Labels, Field::SeedWords})
                    QCOMPARE(needed.covers({field, 0, std::uint32_t(brick)}),
                        isNeeded(grid.brickPosition(brick)));
                QVERIFY(!needed.covers({Field::Coverage, 1, std::uint32_t(brick)}));
            }
        };
        const auto column = [](const glm::ivec3& at) { return at.x == 0 && at.y == 0; };
        needs(column);
        bench.run(edit);
        QCOMPARE(bench.rows().back().statistics.bricks, 2);
        bench.run(test::lockSegment(1));
        needs(column);
        edit.depthMm = 2.0;
        needs(column);
        edit.depthMm.reset();
        edit.outside = true;
        needs([](const glm::ivec3&) { return true; });
    }

private:
    // Of fillsWhatTheCurveWindsAround(), in all of its rows.
    int m_outlines = 0;
    int m_inside = 0;
    int m_outside = 0;
};

BURIN_TEST(SegmentScissorsTest)

} // namespace segmentScissorsTest

#include "SegmentScissorsTest.moc"
