// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SurfaceWriteBack.h"
#include "core/brick/LabelRuns.h"
#include "core/brick/VoxelRunSets.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/session/EditSession.h"
#include "core/session/SessionSurface.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>

namespace surfaceWriteBackTest {

using namespace core;

namespace {

using Mask = std::vector<std::uint8_t>; // 1: in it; x fastest

const VolumeGeometry geometry = test::smallStudy().volume.geometry;
const glm::ivec3 size = geometry.size;
const glm::dvec3 middle = (glm::dvec3(size) - 1.0) / 2.0;

glm::dvec3 at(const glm::dvec3& voxel)
{
    return geometry.toWorld(voxel);
}

glm::ivec3 voxelOf(std::size_t place, const glm::ivec3& extent)
{
    const int at = int(place);
    return {at % extent.x, at / extent.x % extent.y, at / extent.x / extent.y};
}

VoxelRuns runsOf(const Mask& mask)
{
    return labelRuns(mask, 1);
}

Mask maskOf(const VoxelRuns& runs, std::size_t voxels)
{
    Mask mask(voxels);
    for (const VoxelRun& run : runs.runs())
        std::fill_n(mask.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
    return mask;
}

SurfacePath ball(double radiusMm, std::initializer_list<glm::dvec3> offs)
{
    SurfacePath path{.radiusMm = radiusMm, .pointsLps = {}};
    for (const glm::dvec3& off : offs)
        path.pointsLps.push_back(at(middle + off));
    return path;
}

const LaySurface lay{.segment = 1, .vertices = 300};
const SpherePush push{.path = ball(4.0, {{7, 0, 0}, {9, 0, 0}, {11, 2, 0}})};
const SpherePush otherPush{.path = ball(4.0, {{-11, 0, 0}, {-9, 0, 1}})};

Edit imported(const Mask& mask)
{
    return test::maskImport(
        QStringLiteral("ball.nrrd"), size, {{QStringLiteral("Ball"), runsOf(mask), 0x4080C0}});
}

/// A session whose segment 1 is a mask that a surface of few vertices does not enclose exactly.
struct Bench {
    explicit Bench(const Edit& mask, const QString& file = {})
        : session(*EditSession::create(engine, test::smallStudy(), {.file = file}))
    {
        run(mask);
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        settle();
    }
    void runAll(const std::vector<Edit>& edits)
    {
        for (const Edit& edit : edits)
            run(edit);
    }
    void settle() const
    {
        const Result<void> done = session->settle();
        QVERIFY2(done, qPrintable(done ? QString() : done.error().arguments.join(u' ')));
    }
    [[nodiscard]] Mask held(std::uint8_t label = 1)
    {
        Mask mask = *session->questions().labels(0);
        for (std::uint8_t& voxel : mask)
            voxel = voxel == label ? 1 : 0;
        return mask;
    }
    [[nodiscard]] Mask inside() const
    {
        return maskOf(*voxelsOf(*session->surface().mesh(), geometry, {}),
            std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    }
    [[nodiscard]] QByteArray hash() const
    {
        settle();
        return session->stateHash();
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

std::int64_t differences(const Mask& one, const Mask& other)
{
    std::int64_t count = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        count += one[i] != other[i] ? 1 : 0;
    return count;
}

Mask shaped(const std::function<bool(const glm::ivec3&, test::Random&)>& inside)
{
    test::Random random(5);
    Mask mask(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = inside(voxelOf(i, size), random) ? 1 : 0;
    return mask;
}

/// What holds of every write-back: a voxel is as it was, or as the surface encloses it; changed is
/// none but where the surface moved, or in the rim of that.
void checkWritten(const Mask& before, const Mask& written, const Mask& laid, const Mask& now)
{
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (written[i] == before[i])
            continue;
        QCOMPARE(int(written[i]), int(now[i]));
        const glm::ivec3 voxel = voxelOf(i, size);
        const glm::ivec3 first = glm::max(voxel - writeBackRimVoxels, glm::ivec3(0));
        const glm::ivec3 end = glm::min(voxel + writeBackRimVoxels + 1, size);
        bool isNear = false;
        for (int z = first.z; z < end.z; ++z)
            for (int y = first.y; y < end.y; ++y)
                for (int x = first.x; x < end.x; ++x) {
                    const auto place = std::size_t((z * size.y + y) * size.x + x);
                    isNear = isNear || now[place] != laid[place];
                }
        QVERIFY(isNear);
    }
}

double fromMiddle(const glm::ivec3& voxel)
{
    return glm::distance(glm::dvec3(voxel), middle);
}

} // namespace

/// What writing a surface back changes, and what not.
class SurfaceWriteBackTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nobodyMovedIt_data();
    void nobodyMovedIt();
    void aPushIsWrittenWithinItsRim();
    void whatOthersWroteStays();
    void followingAgrees();
    void onlyWhatIsNewIsWritten();
    void othersAreAskedAgain();
    void whatLimitsKeptIsAskedAgain();
    void wherever();
    void tooFewVertices();
};

void SurfaceWriteBackTest::nobodyMovedIt_data()
{
    QTest::addColumn<Edit>("mask");
    QTest::newRow("a ball") << Edit(test::ballMask(size, 9.0));
    QTest::newRow("a rough ball") << Edit(imported(shaped([](const auto& voxel, auto& random) {
        return fromMiddle(voxel) < (test::randomInt(random, 0, 2) == 0 ? 11.0 : 9.0);
    })));
    QTest::newRow("rods, sheets and pits") << Edit(imported(shaped([](const auto& voxel, auto&) {
        return (fromMiddle(voxel) < 9.0 && (voxel.x + voxel.y) % 5 != 0)
            || (voxel.x == 4 && voxel.y % 6 == 1) || voxel.z == 3;
    })));
    QTest::newRow("to the edge of the volume")
        << Edit(imported(shaped([](const auto& voxel, auto&) {
               return voxel.x < 7 || voxel.y > size.y - 3 || (voxel.z < 5 && voxel.x > 30);
           })));
    QTest::newRow("specks") << Edit(imported(
        shaped([](const auto&, auto& random) { return test::randomInt(random, 0, 60) == 0; })));
}

void SurfaceWriteBackTest::nobodyMovedIt()
{
    QFETCH(Edit, mask);
    Bench bench(mask);
    const Mask before = bench.held();
    bench.run(lay);
    const QString name = bench.session->history().rows().back().name;
    const std::int64_t off = differences(before, bench.inside());
    qInfo("%s: %lld of %lld voxels", qPrintable(name), static_cast<long long>(off),
        static_cast<long long>(std::count(before.begin(), before.end(), 1)));
    QVERIFY(name.endsWith(QStringLiteral("% off")));
    QCOMPARE(name.endsWith(QStringLiteral(", 0 % off")), off == 0);
    bench.run(MarkSurface{.mark = SurfaceMark::Red, .path = ball(5.0, {{9, 0, 0}})});
    const std::size_t rows = bench.session->history().rows().size();
    const QByteArray hash = bench.hash();
    bench.run(WriteBack{});
    bench.run(WriteBack{.overwriteUnlocked = true});
    QVERIFY(bench.held() == before);
    QCOMPARE(bench.hash(), hash);
    QCOMPARE(bench.session->history().rows().size(), rows);
}

void SurfaceWriteBackTest::aPushIsWrittenWithinItsRim()
{
    const Edit rough = imported(shaped([](const auto& voxel, auto& random) {
        return fromMiddle(voxel) < (test::randomInt(random, 0, 2) == 0 ? 10.0 : 9.0);
    }));
    const Edit inTheCorner = imported(shaped([](const auto& voxel, auto& random) {
        return glm::length(glm::dvec3(voxel)) < (test::randomInt(random, 0, 2) == 0 ? 16.0 : 14.0);
    }));
    for (const auto& [mask, path, isInside] : {std::tuple(rough, push.path, true),
             std::tuple(rough, ball(5.0, {{13, 0, 0}, {10, 1, 0}, {8, 2, 0}}), false),
             std::tuple(inTheCorner, ball(7.0, {-9.0 - middle, -5.0 - middle, -middle}), false)}) {
        Bench bench(mask);
        const Mask before = bench.held();
        bench.run(lay);
        const Mask laid = bench.inside();
        bench.run(SpherePush{.path = path});
        const Mask now = bench.inside();
        bench.run(WriteBack{});
        const Mask written = bench.held();
        checkWritten(before, written, laid, now);
        QVERIFY(differences(before, laid) > 50); // else this tells nothing
        std::int64_t changed = 0;
        double farthestMm = 0.0;
        for (std::size_t i = 0; i < written.size(); ++i) {
            const glm::dvec3 place = at(glm::dvec3(voxelOf(i, size)));
            double offMm = 1e9;
            for (const glm::dvec3& point : path.pointsLps)
                offMm = std::min(offMm, glm::distance(place, point) - path.radiusMm);
            // Where the ball was the segment is as the surface: no bubble, no crumb.
            if (offMm < -1.0)
                QCOMPARE(int(written[i]), int(isInside));
            if (written[i] == before[i])
                continue;
            ++changed;
            farthestMm = std::max(farthestMm, offMm);
        }
        qInfo("%lld voxels changed, %lld moved over; %.2f mm around a ball of %.1f mm",
            static_cast<long long>(changed), static_cast<long long>(differences(now, laid)),
            farthestMm, path.radiusMm);
        QVERIFY(changed > 100);
        // An edge of this surface, and the rim.
        QVERIFY(farthestMm < 7.0);
        QVERIFY(!bench.session->document().surface->differs);
    }
}

void SurfaceWriteBackTest::whatOthersWroteStays()
{
    Bench bench(test::ballMask(size, 9.0));
    bench.runAll({lay, push});
    bench.runAll({test::paintAt(1, {at(middle + glm::dvec3(0, 12, 0))}, 3.0),
        test::eraseAt(1, {at(middle + glm::dvec3(-8, 0, 0))}, 3.0)});
    const Mask painted = bench.held();
    const Mask now = bench.inside();
    QVERIFY(bench.session->undo() && bench.session->undo() && bench.session->undo());
    bench.settle();
    const Mask laid = bench.inside();
    QVERIFY(bench.session->redo() && bench.session->redo() && bench.session->redo());
    bench.settle();
    QVERIFY(bench.held() == painted);
    bench.run(WriteBack{});
    const Mask written = bench.held();
    checkWritten(painted, written, laid, now);
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (voxelOf(i, size).x < 20)
            QCOMPARE(int(written[i]), int(painted[i]));
    }
    QVERIFY(differences(written, painted) > 100);
}

void SurfaceWriteBackTest::followingAgrees()
{
    const Edit paint = test::paintAt(1, {at(middle + glm::dvec3(0, 10, 0))});
    Bench untouched(test::ballMask(size, 9.0));
    untouched.runAll({lay, paint, FollowMask{}});
    const Mask painted = untouched.held();
    QVERIFY(differences(painted, untouched.inside()) > 0);
    untouched.run(WriteBack{});
    QVERIFY(untouched.held() == painted);

    // What was pushed before is still to be written, and nothing else.
    Bench pushed(test::ballMask(size, 9.0));
    pushed.runAll({lay, push});
    const Mask pushedTo = pushed.inside();
    pushed.runAll({paint, FollowMask{}, WriteBack{}});
    const Mask written = pushed.held();
    std::int64_t gained = 0;
    for (std::size_t i = 0; i < written.size(); ++i) {
        const glm::ivec3 voxel = voxelOf(i, size);
        if (voxel.y > 25) // beyond the push
            QCOMPARE(int(written[i]), int(painted[i]));
        gained += written[i] == 1 && painted[i] == 0 && pushedTo[i] == 1 ? 1 : 0;
    }
    QVERIFY(gained > 100);
}

void SurfaceWriteBackTest::onlyWhatIsNewIsWritten()
{
    Bench bench(test::ballMask(size, 9.0));
    bench.runAll({lay, push, WriteBack{}});
    // Somebody corrects what was written; a push elsewhere leaves it alone.
    const Edit correction = test::eraseAt(1, {at(middle + glm::dvec3(12, 1, 0))}, 2.0);
    bench.run(correction);
    const Mask corrected = bench.held();
    const Mask before = bench.inside();
    bench.run(otherPush);
    const Mask now = bench.inside();
    bench.run(WriteBack{});
    const Mask written = bench.held();
    checkWritten(corrected, written, before, now);
    for (std::size_t i = 0; i < corrected.size(); ++i) {
        if (voxelOf(i, size).x > 20)
            QCOMPARE(int(written[i]), int(corrected[i]));
    }
    QVERIFY(differences(written, corrected) > 50);
    // Undone, the first push is what was agreed on last again: redone, all is as it was.
    const QByteArray hash = bench.hash();
    for (int i = 0; i < 4; ++i)
        QVERIFY(bench.session->undo());
    bench.settle();
    bench.runAll({WriteBack{}, correction, otherPush, WriteBack{}});
    QCOMPARE(bench.hash(), hash);
}

void SurfaceWriteBackTest::othersAreAskedAgain()
{
    // Another segment stands where the surface is pushed to.
    Bench bench(test::ballMask(size, 9.0));
    bench.runAll({test::ballMask(size, 12.0), lay, push});
    const Mask other = bench.held(2);
    const Mask now = bench.inside();
    bench.run(WriteBack{});
    QVERIFY(bench.held(2) == other);
    const Mask beside = bench.held();
    bench.run(WriteBack{.overwriteUnlocked = true});
    const Mask over = bench.held();
    std::int64_t taken = 0;
    for (std::size_t i = 0; i < over.size(); ++i) {
        if (over[i] == beside[i])
            continue;
        QVERIFY(over[i] == 1 && other[i] == 1 && now[i] == 1);
        ++taken;
    }
    QVERIFY(taken > 50);
    bench.run(WriteBack{.overwriteUnlocked = true});
    QVERIFY(bench.held() == over);
}

/// What lies outside of the range stays; surface and segment are apart until it is written, too.
void SurfaceWriteBackTest::whatLimitsKeptIsAskedAgain()
{
    const double border = middle.x + 9.5;
    const EditableRange near{
        .box = GrowBox{at({0.0, 0.0, 0.0}), at({border, double(size.y), double(size.z)})}};
    Bench bench(test::ballMask(size, 9.0));
    bench.runAll({lay, push});
    const Mask before = bench.held();
    const QByteArray pushed = bench.hash();
    bench.run(WriteBack{});
    const Mask freely = bench.held();
    QVERIFY(bench.session->undo());
    QCOMPARE(bench.hash(), pushed);

    Mask meant = before;
    std::int64_t kept = 0;
    for (std::size_t i = 0; i < meant.size(); ++i) {
        if (voxelOf(i, size).x <= int(border))
            meant[i] = freely[i];
        else
            kept += freely[i] != before[i] ? 1 : 0;
    }
    QVERIFY(kept > 20 && meant != before);
    const std::size_t rows = bench.session->history().rows().size();
    bench.run(WriteBack{.editable = near});
    QVERIFY(bench.held() == meant);
    QVERIFY(bench.session->document().surface->isApart());
    QVERIFY(bench.session->history().rows().back().name.contains(QStringLiteral("within limits")));
    QCOMPARE(bench.session->history().rows().size(), rows + 1);
    // Once more there is nothing to write, and no row says so.
    bench.run(WriteBack{.editable = near});
    QCOMPARE(bench.session->history().rows().size(), rows + 1);
    const QByteArray limited = bench.hash();
    bench.run(WriteBack{.editable = EditableRange{}});
    QVERIFY(bench.held() == freely);
    QVERIFY(!bench.session->document().surface->isApart());
    const QByteArray whole = bench.hash();
    QVERIFY(bench.session->undo());
    QCOMPARE(bench.hash(), limited);
    QVERIFY(bench.session->document().surface->isApart());
    QVERIFY(bench.session->undo());
    QCOMPARE(bench.hash(), pushed);
    QVERIFY(bench.session->redo() && bench.session->redo());
    QCOMPARE(bench.hash(), whole);
    // From the rows alone.
    Bench again(test::ballMask(size, 9.0));
    const std::vector<HistoryRow>& all = bench.session->history().rows();
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (i == rows - 1)
            continue; // what was undone above
        const Result<Edit> told = editFromJson(editToJson(all[i].edit));
        QVERIFY(told);
        again.run(*told);
    }
    QCOMPARE(again.hash(), whole);
    const auto refusal = [&](const EditableRange& range) {
        const Result<void> applied = bench.session->apply(WriteBack{.editable = range});
        return applied ? ErrorCode::Internal : applied.error().code;
    };
    QCOMPARE(refusal({.inside = std::vector<int>{9}}), ErrorCode::UnknownSegment);
    QCOMPARE(refusal({.lower = 2.0, .upper = 1.0}), ErrorCode::InvalidField);
}

/// The session may be closed at any step: what was agreed on is read off its rows.
void SurfaceWriteBackTest::wherever()
{
    const Edit mask = test::ballMask(size, 9.0);
    const std::vector<Edit> edits{lay, push, WriteBack{}, otherPush,
        test::paintAt(1, {at(middle + glm::dvec3(0, 10, 0))}, 3.0), FollowMask{}, WriteBack{}};
    Bench whole(mask);
    std::vector<QByteArray> hashes;
    for (const Edit& edit : edits) {
        whole.run(edit);
        hashes.push_back(whole.hash());
    }
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("refined.burin"));
    {
        Bench begun(mask, file);
        begun.run(edits.front());
    }
    for (std::size_t i = 1; i < edits.size(); ++i) {
        reference::ReferenceEngine engine;
        auto session = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(session);
        QVERIFY((*session)->apply(edits[i]));
        QVERIFY((*session)->settle());
        QCOMPARE((*session)->stateHash(), hashes[i]);
    }
}

void SurfaceWriteBackTest::tooFewVertices()
{
    Bench bench(test::ballMask(size, 9.0));
    const Result<void> refused = bench.session->apply(LaySurface{.segment = 1, .vertices = 99});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::InvalidField);
    bench.run(LaySurface{.segment = 1}); // as many as it takes
    QVERIFY(bench.held() == bench.inside());
}

BURIN_TEST(SurfaceWriteBackTest)

} // namespace surfaceWriteBackTest

#include "SurfaceWriteBackTest.moc"
