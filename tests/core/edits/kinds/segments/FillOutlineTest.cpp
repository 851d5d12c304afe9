// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/EditQuantise.h"
#include "core/session/EditSession.h"
#include "core/session/past/RowDependencies.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/cases/strokes/StrokeScene.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace fillOutlineTest {

using namespace core;

namespace {

/// A session with two segments, One and Two.
struct Bench : test::SessionBench {
    explicit Bench(const LoadedVolume& volume = test::smallStudy())
        : SessionBench(true, volume)
    {
        run(test::addSegment("One"));
        run(test::addSegment("Two"));
    }
};

/// Calls with the position of each voxel, x fastest.
template <class Visit> void forEachVoxel(const glm::ivec3& size, Visit visit)
{
    std::size_t place = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z), place++);
}

/// An outline in a slice along the grid whose corners are voxels of it, a and b counted along the
/// axes after the slice's own.
FillOutline inSlice(
    const VolumeGeometry& geometry, int axis, double slice, const std::vector<glm::dvec2>& corners)
{
    glm::dvec3 first(0.0);
    first[axis] = slice;
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    FillOutline edit{.segment = 1,
        .originLps = geometry.toWorld(first),
        .rightLps = geometry.direction()[a],
        .upLps = geometry.direction()[b]};
    for (const glm::dvec2& corner : corners)
        edit.polygonMm.push_back(
            corner * glm::dvec2(geometry.spacingMm()[a], geometry.spacingMm()[b]));
    return edit;
}

double distanceToEdge(const glm::dvec2& place, const glm::dvec2& from, const glm::dvec2& to)
{
    const glm::dvec2 along = to - from;
    const double squared = glm::dot(along, along);
    const double t =
        squared > 0.0 ? std::clamp(glm::dot(place - from, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(place, from + t * along);
}

/// What a place far enough from every edge is told by the angles under which it sees the edges;
/// none where it is too near to one.
std::optional<bool> windsAround(const std::vector<glm::dvec2>& polygon, const glm::dvec2& place)
{
    constexpr double nearMm = 2e-3;
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

/// A plane through the volume that leans to all of its axes.
void leanAtRandom(FillOutline& edit, const VolumeGeometry& geometry, test::Random& random)
{
    const glm::dmat3 axes = geometry.direction();
    glm::dvec3 normal(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double much = 0.3 + 0.7 * test::randomUnit(random);
        normal += axes[axis] * (random() % 2 ? much : -much);
    }
    normal = glm::normalize(normal);
    edit.rightLps = 3.0 * glm::cross(normal, axes[int(random() % 3)]);
    // What it has of the other direction must not matter.
    edit.upLps = glm::cross(normal, edit.rightLps) + 0.7 * edit.rightLps;
    edit.originLps =
        geometry.toWorld(glm::dvec3(geometry.size) * (0.3 + 0.4 * test::randomUnit(random)));
}

} // namespace

class FillOutlineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void fillsWhatTheOutlineWindsAround_data()
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 36; ++number)
            QTest::addRow("%d", number) << number;
    }
    /// Against double precision and angles, in grids of any spacing, some of them sheared, and
    /// planes of any direction; voxels on the very edge are held by the integer tests.
    void fillsWhatTheOutlineWindsAround()
    {
        QFETCH(const int, number);
        test::Random random(std::uint32_t(900 + number));
        const Document document = test::randomDocument({24, 22, 20}, random, number % 2 == 1);
        Bench bench(test::loaded(document, test::constantVolume({24, 22, 20}, 100)));
        const VolumeGeometry& geometry = bench.geometry();
        FillOutline edit;
        const bool alongGrid = number % 3 == 0;
        const int axis = number / 3 % 3;
        const int slice = 4 + number % 11;
        if (alongGrid) {
            const double beside = 0.8 * (test::randomUnit(random) - 0.5);
            edit = inSlice(geometry, axis, slice + beside, {});
            // Of a sheared grid the origin's corner may be far from the slice's middle.
            edit.originLps += geometry.toWorld({12.0, 11.0, 10.0})
                - geometry.toWorld(glm::dvec3(
                    axis == 0 ? 12.0 : 0.0, axis == 1 ? 11.0 : 0.0, axis == 2 ? 10.0 : 0.0));
        } else {
            leanAtRandom(edit, geometry, random);
        }
        edit.segment = 1;
        const double reachMm = number % 7 == 0 ? 90.0 : 3.0 + 15.0 * test::randomUnit(random);
        edit.polygonMm = test::randomOutline(reachMm, random);
        QVERIFY(edit.polygonMm.size() >= 3);
        bench.run(edit);

        edit = quantised(edit).get<FillOutline>();
        const glm::dvec3 right = glm::normalize(edit.rightLps);
        const glm::dvec3 up = glm::normalize(edit.upLps - glm::dot(edit.upLps, right) * right);
        const glm::dvec3 normal = glm::cross(right, up);
        double halfMm = 0.0;
        for (int each = 0; each < 3; ++each)
            halfMm = std::max(
                halfMm, std::abs(glm::dot(normal, glm::dvec3(geometry.indexToWorld[each]))) / 2.0);
        const std::vector<std::uint8_t> labels = bench.labels();
        int compared = 0;
        int left = 0;
        forEachVoxel(geometry.size, [&](const glm::ivec3& voxel, std::size_t place) {
            const glm::dvec3 from = geometry.toWorld(glm::dvec3(voxel)) - edit.originLps;
            const double across = std::abs(glm::dot(from, normal)) - halfMm;
            const bool inSlab = alongGrid ? voxel[axis] == slice : across < 0.0;
            const std::optional<bool> inside =
                windsAround(edit.polygonMm, {glm::dot(from, right), glm::dot(from, up)});
            if ((!alongGrid && std::abs(across) < 2e-3) || (inSlab && !inside)) {
                ++left;
                return;
            }
            QCOMPARE(int(labels[place]), inSlab && *inside ? 1 : 0);
            ++compared;
        });
        QVERIFY(compared > 10000 && left < 200);
    }

    void cornersOnVoxels_data()
    {
        QTest::addColumn<int>("axis");
        for (int axis = 0; axis < 3; ++axis)
            QTest::addRow("axis %d", axis) << axis;
    }
    /// What lies on the outline is inside, whichever way it is drawn and seen, in one slice.
    void cornersOnVoxels()
    {
        QFETCH(const int, axis);
        const std::vector<glm::dvec2> square{{5, 6}, {12, 6}, {12, 10}, {5, 10}};
        for (int form = 0; form < 8; ++form) {
            Bench bench;
            std::vector<glm::dvec2> corners = square;
            std::rotate(corners.begin(), corners.begin() + form % 4, corners.end());
            if (form % 2 == 1)
                std::reverse(corners.begin(), corners.end());
            FillOutline edit =
                inSlice(bench.geometry(), axis, 7.0 + (form % 3 - 1) * 0.49, corners);
            if (form >= 4) { // seen from behind
                edit.rightLps = -edit.rightLps;
                for (glm::dvec2& corner : edit.polygonMm)
                    corner.x = -corner.x;
            }
            bench.run(edit);
            const std::vector<std::uint8_t> labels = bench.labels();
            forEachVoxel(bench.geometry().size, [&](const glm::ivec3& voxel, std::size_t place) {
                const int a = voxel[(axis + 1) % 3];
                const int b = voxel[(axis + 2) % 3];
                const bool inside = voxel[axis] == 7 && a >= 5 && a <= 12 && b >= 6 && b <= 10;
                QCOMPARE(int(labels[place]), inside ? 1 : 0);
            });
        }
    }

    /// A slanting edge through voxels, a curve that goes around twice, and one that leaves a hole
    /// because it goes around that the other way.
    void edgesThroughVoxels()
    {
        const auto voxelsOf = [](const std::vector<glm::dvec2>& corners) {
            Bench bench;
            bench.run(inSlice(bench.geometry(), 2, 9.0, corners));
            return bench.voxels(1);
        };
        QCOMPARE(voxelsOf({{5, 6}, {15, 6}, {5, 16}}), std::int64_t(66));
        QCOMPARE(voxelsOf({{3, 3}, {13, 3}, {13, 13}, {3, 13}, {3, 3}, {13, 3}, {13, 13}, {3, 13}}),
            std::int64_t(121));
        QCOMPARE(voxelsOf({{3, 3}, {13, 3}, {13, 13}, {3, 13}, {3, 3}, {6, 6}, {6, 10}, {10, 10},
                     {10, 6}, {6, 6}}),
            std::int64_t(121 - 9));
        // Two triangles that meet in a voxel.
        QCOMPARE(voxelsOf({{4, 4}, {12, 12}, {12, 4}, {4, 12}}), std::int64_t(81 - 4 * 4 - 4 * 4));
        QCOMPARE(voxelsOf({{4, 4}, {9, 9}, {6, 6}}), std::int64_t(6)); // a line
        QCOMPARE(voxelsOf({{4.25, 4.25}, {4.75, 4.25}, {4.5, 4.75}}), std::int64_t(0));
    }

    void honoursWhatMayBeChanged()
    {
        Bench bench;
        const std::vector<glm::dvec2> square{{5, 6}, {12, 6}, {12, 10}, {5, 10}};
        FillOutline one = inSlice(bench.geometry(), 2, 17.0, square);
        bench.run(one);
        QCOMPARE(bench.voxels(1), std::int64_t(40));
        QCOMPARE(
            bench.rows().back().name, QStringLiteral("Fill an outline with 'One', +40 voxels"));
        FillOutline two = inSlice(bench.geometry(), 2, 17.0, {{9, 6}, {16, 6}, {16, 10}, {9, 10}});
        two.segment = 2;
        bench.run(two);
        QCOMPARE(bench.voxels(1), std::int64_t(40)); // others stay
        QCOMPARE(bench.voxels(2), std::int64_t(20));
        const std::size_t rows = bench.rows().size();
        bench.run(two); // nothing is left to do: no step
        QCOMPARE(bench.rows().size(), rows);
        two.overwriteUnlocked = true;
        bench.run(test::lockSegment(1));
        bench.run(two);
        QCOMPARE(bench.voxels(1), std::int64_t(40)); // it is locked
        QVERIFY(bench.session->undo() && bench.session->settle()); // the lock
        bench.run(two);
        QCOMPARE(bench.voxels(1), std::int64_t(20));
        QCOMPARE(bench.voxels(2), std::int64_t(40));
        two.erase = true;
        two.polygonMm =
            inSlice(bench.geometry(), 2, 17.0, {{0, 0}, {39, 0}, {39, 35}, {0, 35}}).polygonMm;
        bench.run(two); // of its own alone
        QCOMPARE(bench.voxels(1), std::int64_t(20));
        QCOMPARE(bench.voxels(2), std::int64_t(0));
        QCOMPARE(bench.rows().back().name, QStringLiteral("Erase 'Two' in an outline, −40 voxels"));
    }

    /// The middle slice shows bone around brain in air.
    void onlySomeValues()
    {
        Bench bench;
        FillOutline all = inSlice(bench.geometry(), 2, 17.0, {{0, 0}, {39, 0}, {39, 35}, {0, 35}});
        all.lower = 500.0;
        bench.run(all);
        const std::int64_t bone = bench.voxels(1);
        QVERIFY(bone > 100);
        const LoadedVolume study = test::smallStudy();
        const std::vector<std::uint8_t> labels = bench.labels();
        forEachVoxel(bench.geometry().size, [&](const glm::ivec3& voxel, std::size_t place) {
            const bool isBone = study.codes[place] == 1000 + 1024;
            QCOMPARE(labels[place] == 1, voxel.z == 17 && isBone);
        });
        all.segment = 2;
        all.upper = 40.0;
        QCOMPARE(bench.refusal(all), ErrorCode::InvalidField); // below the lower one
        all.lower = 40.0;
        bench.run(all);
        QVERIFY(bench.voxels(2) > 100);
        all.lower.reset();
        all.upper = -500.0;
        all.erase = true; // in the air alone, where it has none
        const std::size_t rows = bench.rows().size();
        bench.run(all);
        QCOMPARE(bench.rows().size(), rows);
    }

    void whatCannotBe()
    {
        Bench bench;
        const FillOutline sound = inSlice(bench.geometry(), 2, 9.0, {{5, 6}, {15, 6}, {5, 16}});
        const auto refused = [&](ErrorCode code, auto change) {
            FillOutline edit = sound;
            change(edit);
            QCOMPARE(bench.refusal(edit), code);
        };
        const ErrorCode field = ErrorCode::InvalidField;
        refused(ErrorCode::UnknownSegment, [](FillOutline& edit) { edit.segment = 9; });
        refused(field, [](FillOutline& edit) { edit.polygonMm.pop_back(); });
        refused(field, [](FillOutline& edit) { edit.polygonMm.clear(); });
        refused(field, [](FillOutline& edit) { edit.polygonMm.resize(10001, {1.0, 2.0}); });
        refused(field, [](FillOutline& edit) { edit.rightLps = glm::dvec3(0.0); });
        refused(field, [](FillOutline& edit) { edit.upLps = glm::dvec3(0.0); });
        refused(field, [](FillOutline& edit) { edit.upLps = -2.0 * edit.rightLps; });
        refused(field, [](FillOutline& edit) { edit.originLps.z -= 9.0 * 1.5 + 0.8; });
        refused(field, [](FillOutline& edit) { edit.originLps.z += 25.0 * 1.5; });
        refused(field, [](FillOutline& edit) { edit.originLps.x += 90000.0; });
        bench.run(test::lockSegment(1));
        refused(ErrorCode::SegmentLocked, [](FillOutline&) {});
        QCOMPARE(bench.voxels(1), std::int64_t(0));
        // Beside the volume, in a slice of it: nothing happens, and no step is made.
        FillOutline beside = inSlice(bench.geometry(), 2, 9.0, {{50, 6}, {60, 6}, {50, 16}});
        beside.segment = 2;
        const std::size_t rows = bench.rows().size();
        bench.run(beside);
        QCOMPARE(bench.rows().size(), rows);
    }

    void thereAndBackAndAnew()
    {
        test::Random random(77);
        Bench bench;
        std::vector<QByteArray> hashes{bench.session->stateHash()};
        for (int step = 0; step < 12; ++step) {
            FillOutline edit{.segment = 1 + int(random() % 2)};
            leanAtRandom(edit, bench.geometry(), random);
            edit.polygonMm = test::randomOutline(14.0, random);
            edit.erase = step > 3 && random() % 2 == 0;
            edit.overwriteUnlocked = random() % 2 == 0;
            const std::size_t rows = bench.rows().size();
            bench.run(edit);
            if (bench.rows().size() > rows)
                hashes.push_back(bench.session->stateHash());
        }
        QVERIFY(hashes.size() > 4); // the first ones paint
        for (std::size_t back = hashes.size() - 1; back > 0; --back) {
            QVERIFY(bench.session->undo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hashes[back - 1]);
        }
        for (std::size_t on = 1; on < hashes.size(); ++on) {
            QVERIFY(bench.session->redo() && bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hashes[on]);
        }
        reference::ReferenceEngine engine;
        const auto anew = *EditSession::create(engine, test::smallStudy(), {.file = {}});
        for (const HistoryRow& row : bench.rows())
            QVERIFY(anew->apply(row.edit) && anew->settle());
        QCOMPARE(anew->stateHash(), hashes.back());
    }

    /// It changes bricks in which the outline lies, and undoing something else alone asks only
    /// about these.
    void dependsOnItsBricksAlone()
    {
        Bench bench;
        const FillOutline edit = inSlice(bench.geometry(), 2, 17.0, {{1, 1}, {9, 1}, {9, 20}});
        const BrickGrid grid{bench.geometry().size};
        const auto needsItsBricks = [&] {
            // Nothing is told of what was written.
            const RowDependencies needs(edit, bench.session->document(), {});
            for (int brick = 0; brick < grid.brickCount(); ++brick) {
                const glm::ivec3 at = grid.brickPosition(brick);
                const bool near = at.z == 1 && at.x == 0 && at.y <= 1;
                for (const Field field : {Field::Labels, Field::SeedWords, Field::Overwritten})
                    QCOMPARE(needs.covers({field, 0, std::uint32_t(brick)}), near);
                QVERIFY(!needs.covers({Field::Coverage, 1, std::uint32_t(brick)}));
            }
        };
        needsItsBricks();
        bench.run(edit);
        QCOMPARE(bench.rows().back().statistics.bricks, 2);
        // They are the same when the segment must not be changed any more.
        bench.run(test::lockSegment(1));
        needsItsBricks();
    }
};

BURIN_TEST(FillOutlineTest)

} // namespace fillOutlineTest

#include "FillOutlineTest.moc"
