// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QJsonObject>
#include <QTest>

#include <algorithm>

namespace growthRangeTest {

using namespace core;

namespace {

constexpr int first = 1;
constexpr int second = 2;
constexpr int growing = 3;

/// Two balls of other segments that touch in the brain, and a seed of a third segment in one of
/// them.
struct Bench : test::SessionBench {
    Bench()
        : SessionBench(false, test::smallStudy(), {})
    {
        for (const char* name : {"First", "Second", "Growing"})
            run(test::addSegment(name));
        run(test::paintAt(first, {at({17.0, 18.0, 17.0})}, 5.0));
        run(test::paintAt(second, {at({26.0, 18.0, 17.0})}, 4.0));
        before = labels();
        run(test::seedAt(growing, {at(glm::dvec3(seed))}));
    }
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& index) const { return geometry().toWorld(index); }
    /// What an edit makes of the labels; then it is taken back, if it is a row.
    [[nodiscard]] std::vector<std::uint8_t> labelsAfter(const Edit& edit) const
    {
        const RowId position = session->history().position();
        run(edit);
        std::vector<std::uint8_t> found = labels();
        if (session->history().position() != position)
            undo();
        return found;
    }
    void undo() const
    {
        QVERIFY(session->undo());
        QVERIFY(session->settle());
    }
    [[nodiscard]] std::vector<EditableRange> ranges() const
    {
        const GrowBox box{at({12.0, 10.0, 12.0}), at({24.0, 30.0, 20.0})};
        return {{}, {.upper = 39.0}, {.lower = 40.0}, {.box = box}, {.inside = std::vector{first}},
            {.inside = std::vector{first, second}}, {.inside = std::vector{second}},
            {.inside = std::vector<int>()}, {.outside = std::vector{second}},
            {.outside = std::vector{first}}, {.outside = std::vector{growing}},
            {.upper = 2000.0,
                .box = box,
                .inside = std::vector{first, second},
                .outside = std::vector{second}}};
    }

    const glm::ivec3 seed{17, 18, 17};
    std::vector<std::uint8_t> before;
};

GrowCriteria criteriaWith(const EditableRange& range, double upper)
{
    return {.lower = -200.0, .upper = upper, .overwriteUnlocked = true, .editable = range};
}

bool lists(const std::optional<std::vector<int>>& segments, int label)
{
    return segments && std::find(segments->begin(), segments->end(), label) != segments->end();
}

/// The rule as a user would say it. @param label what was there before growth came
bool mayChange(const EditableRange& range, double value, const glm::ivec3& voxel,
    const VolumeGeometry& geometry, int label)
{
    if (value < range.lower.value_or(value) || value > range.upper.value_or(value))
        return false;
    if (range.box) {
        const glm::ivec3 a(glm::round(geometry.toIndex(range.box->fromLps)));
        const glm::ivec3 b(glm::round(geometry.toIndex(range.box->toLps)));
        if (glm::any(glm::lessThan(voxel, glm::min(a, b)))
            || glm::any(glm::greaterThan(voxel, glm::max(a, b))))
            return false;
    }
    return (!range.inside || lists(range.inside, label)) && !lists(range.outside, label);
}

template <class Visit> void forEachIn(const glm::ivec3& size, const Visit& visit)
{
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
}

/// The voxels that share a face with one.
template <class Visit>
void forEachBeside(const glm::ivec3& voxel, const glm::ivec3& size, const Visit& visit)
{
    for (int axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
            glm::ivec3 next = voxel;
            next[axis] += step;
            if (next[axis] >= 0 && next[axis] < size[axis])
                visit(next);
        }
    }
}

/// What a growth makes of the labels: all that the range and the interval leave and that hangs
/// together with the seed, found by a plain flood.
std::vector<std::uint8_t> flooded(const Bench& bench, const GrowCriteria& criteria)
{
    static const LoadedVolume study = test::smallStudy();
    const VolumeGeometry& geometry = study.volume.geometry;
    std::vector<std::uint8_t> labels = bench.before;
    const auto open = [&](const glm::ivec3& voxel) {
        const std::size_t at = test::smallIndexOf(voxel);
        const double value = study.codes[at] - 1024.0;
        return labels[at] != growing && value >= criteria.lower && value <= criteria.upper
            && mayChange(*criteria.editable, value, voxel, geometry, bench.before[at]);
    };
    std::vector<glm::ivec3> front;
    const auto take = [&](const glm::ivec3& voxel) {
        labels[test::smallIndexOf(voxel)] = growing;
        front.push_back(voxel);
    };
    if (open(bench.seed))
        take(bench.seed);
    while (!front.empty()) {
        const glm::ivec3 voxel = front.back();
        front.pop_back();
        forEachBeside(voxel, geometry.size, [&](const glm::ivec3& next) {
            if (open(next))
                take(next);
        });
    }
    return labels;
}

} // namespace

/// A growth within the editable range (EditableRange).
class GrowthRangeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void itGrowsThereAlone()
    {
        const Bench bench;
        int grown = 0;
        int kept = 0;
        for (const EditableRange& range : bench.ranges()) {
            const GrowCriteria criteria = criteriaWith(range, 2000.0);
            const std::vector<std::uint8_t> found = bench.labelsAfter(test::growBy(criteria));
            QVERIFY(found == flooded(bench, criteria));
            ++(found == bench.before ? kept : grown);
            QVERIFY(bench.labels() == bench.before);
        }
        QVERIFY(grown >= 6 && kept >= 3);
    }

    /// Another interval and another range at once: voxels that are no longer among them leave, and
    /// get back what they were.
    void itWithdrawsFromWhatIsOutside()
    {
        const Bench bench;
        for (const EditableRange& from : bench.ranges()) {
            const RowId position = bench.session->history().position();
            bench.run(test::growBy(criteriaWith(from, 2000.0)));
            for (const EditableRange& to : bench.ranges()) {
                const GrowCriteria criteria = criteriaWith(to, 500.0);
                const ChangeInterval change{.criteria = criteria, .asBefore = false};
                QVERIFY(bench.labelsAfter(change) == flooded(bench, criteria));
            }
            QVERIFY(bench.labels() == flooded(bench, criteriaWith(from, 2000.0)));
            if (bench.session->history().position() != position)
                bench.undo();
        }
    }

    /// A box of growth and one of editing: growth stays in both.
    void boxesNarrowEachOther()
    {
        const Bench bench;
        const GrowBox left{bench.at({8.0, 10.0, 10.0}), bench.at({20.0, 26.0, 24.0})};
        const GrowBox right{bench.at({15.0, 12.0, 12.0}), bench.at({30.0, 30.0, 22.0})};
        GrowCriteria both = criteriaWith({.box = right}, 2000.0);
        both.box = left;
        const GrowBox common{bench.at({15.0, 12.0, 12.0}), bench.at({20.0, 26.0, 22.0})};
        QVERIFY(bench.labelsAfter(test::growBy(both))
            == flooded(bench, criteriaWith({.box = common}, 2000.0)));
        both.box = GrowBox{bench.at({2.0, 2.0, 2.0}), bench.at({8.0, 8.0, 8.0})};
        QVERIFY(bench.labelsAfter(test::growBy(both)) == bench.before); // they do not meet
    }

    /// Which of two segments wins a voxel is another test's matter; here which voxels are won.
    void sharingOutStaysThere()
    {
        const Bench bench;
        bench.run(test::paintAt(growing, {bench.at({20.0, 24.0, 17.0})}, 4.0));
        const std::vector<std::uint8_t> before = bench.labels();
        const LoadedVolume study = test::smallStudy();
        const VolumeGeometry& geometry = bench.geometry();
        GrowFromSeeds edit{.segments = std::vector{first, second},
            .box = GrowBox{bench.at({0.0, 0.0, 0.0}), bench.at(glm::dvec3(geometry.size - 1))},
            .overwriteUnlocked = true};
        int won = 0;
        for (const EditableRange& range : bench.ranges()) {
            edit.editable = range;
            const std::vector<std::uint8_t> found = bench.labelsAfter(edit);
            std::vector<char> reached(before.size(), 0);
            std::vector<glm::ivec3> front;
            const auto take = [&](const glm::ivec3& voxel) {
                reached[test::smallIndexOf(voxel)] = 1;
                front.push_back(voxel);
            };
            forEachIn(geometry.size, [&](const glm::ivec3& voxel) {
                const int label = before[test::smallIndexOf(voxel)];
                if (label == first || label == second)
                    take(voxel);
            });
            while (!front.empty()) {
                const glm::ivec3 voxel = front.back();
                front.pop_back();
                forEachBeside(voxel, geometry.size, [&](const glm::ivec3& next) {
                    const std::size_t at = test::smallIndexOf(next);
                    if (!reached[at]
                        && mayChange(range, study.codes[at] - 1024.0, next, geometry, before[at]))
                        take(next);
                });
            }
            for (std::size_t at = 0; at < before.size(); ++at) {
                const bool isWon = found[at] == first || found[at] == second;
                QCOMPARE(isWon, reached[at] != 0);
                if (!isWon)
                    QCOMPARE(found[at], before[at]);
                won += isWon && found[at] != before[at] ? 1 : 0;
            }
        }
        QVERIFY(won > 1000);
        // A range around all of it takes nothing away, and gives nothing either.
        edit.box.reset();
        edit.editable.reset();
        const std::vector<std::uint8_t> freely = bench.labelsAfter(edit);
        edit.editable.emplace().box =
            GrowBox{bench.at({0.0, 0.0, 0.0}), bench.at(glm::dvec3(geometry.size - 1))};
        QVERIFY(bench.labelsAfter(edit) == freely && freely != before);
    }

    void itIsPartOfTheRecipeAndOfWhatGoesOn()
    {
        const Bench bench;
        const EditableRange range{.inside = std::vector{first}};
        Edit grow = test::growBy(criteriaWith(range, 2000.0), 1);
        QVERIFY(editableRangeOf(grow));
        const Result<Edit> read = editFromJson(editToJson(grow));
        QVERIFY(read && editToJson(*read) == editToJson(grow));
        QVERIFY(!editToJson(test::growBrain()).contains(QStringLiteral("editable")));

        bench.run(grow);
        QVERIFY(bench.session->history().rows().back().name.contains(QStringLiteral("within")));
        bench.run(ResumeGrowth{});
        QVERIFY(bench.labels() == flooded(bench, criteriaWith(range, 2000.0)));

        // Inside a segment that is gone nothing lies; growth goes on all the same.
        bench.run(RemoveSegment{.segment = first});
        const std::vector<std::uint8_t> left = bench.labels();
        const Result<void> resumed = bench.session->apply(ResumeGrowth{});
        QVERIFY2(resumed, qPrintable(resumed ? QString() : resumed.error().arguments.join(u' ')));
        QVERIFY(bench.session->settle());
        QVERIFY(bench.labels() == left);
    }

    void segmentsOfOtherPlanesAreRefusedByName()
    {
        const Bench bench;
        ImportMask mask =
            test::importOfBoxes({{glm::ivec3(10), glm::ivec3(14)}}, bench.geometry().size);
        mask.planes = std::vector<int>{1};
        bench.run(mask);
        const Segment& other = bench.session->document().segments.back();
        const auto refused = bench.session->apply(
            test::growBy(criteriaWith({.inside = std::vector<int>{other.label}}, 2000.0)));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::InvalidField);
        QVERIFY(refused.error().arguments.join(u' ').contains(other.name));
        QVERIFY(!bench.session->apply(
            test::growBy(criteriaWith({.outside = std::vector<int>{77}}, 2000.0))));
    }
};

BURIN_TEST(GrowthRangeTest)

} // namespace growthRangeTest

#include "GrowthRangeTest.moc"
