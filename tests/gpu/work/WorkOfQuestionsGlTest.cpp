// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourRule.h"
#include "core/contour/ContourWatch.h"
#include "core/edits/engine/PickRays.h"
#include "core/edits/kinds/filling/ContourTrial.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/outline/CheapestWays.h"
#include "core/outline/LevelContour.h"
#include "core/outline/SliceLattice.h"
#include "core/sculpt/labels/HeldVoxels.h"
#include "core/session/EditSession.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/MemoryLimit.h"
#include "tests/support/fixtures/WorkTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace workOfQuestionsGlTest {

using namespace core;
using test::CountedSession;
using Ball = test::GradedBall;

namespace {

constexpr int organ = 1;
constexpr std::size_t probedAtOnce = 1 << 16; ///< as in ui/tools/outline/ReadSlice.cpp

const Volume& volumeOf(EditSession& session)
{
    return session.document().volumes.front();
}

/// Rays of the front view, in a square around a place of its plane.
PickQuestion questionAround(EditSession& session, const glm::dvec2& middleMm)
{
    std::vector<glm::dvec2> planeMm;
    for (int y = -4; y <= 4; ++y) {
        for (int x = -4; x <= 4; ++x)
            planeMm.push_back(middleMm + 0.5 * glm::dvec2(x, y));
    }
    const Volume& volume = volumeOf(session);
    return {.rays = pickRays(Ball::front(), planeMm, volume.geometry).rays,
        .thresholdCode = volume.encoding.lowestCodeAtLeast(Ball::threshold)};
}

/// What a level trace and a livewire work out of a slice.
void outline(const SlicePixels& pixels, const glm::ivec2& middle)
{
    if (levelContour(pixels, middle + glm::ivec2(10, 0)).corners.size() < 8)
        qWarning("a level trace has found nothing");
    const auto costs = std::make_shared<const SideCosts>(
        sideCosts(pixels, int(Ball::threshold), int(Ball::valueAt(0.0))));
    if (CheapestWays(costs, middle).wayTo(middle + 8).size() < 2)
        qWarning("a livewire has found no way");
}

/// A slice through the middle.
/// @param down its second axis
SliceLattice latticeOf(const VolumeGeometry& geometry, const glm::dvec3& down)
{
    return sliceLattice(geometry, Ball::middle, {1.0, 0.0, 0.0}, down);
}

constexpr glm::dvec3 straight(0.0, 1.0, 0.0);
constexpr glm::dvec3 aslant(0.0, 0.8, 0.6);

/// How many pixels an oblique slice of a volume with this side has.
std::int64_t obliquePixels(int side)
{
    VolumeGeometry geometry;
    geometry.size = glm::ivec3(side);
    const glm::ivec2 size = latticeOf(geometry, aslant).size;
    return std::int64_t(size.x) * size.y;
}

/// Asks for the voxels of an oblique slice, in portions one after another.
struct ObliqueReading {
    std::vector<glm::ivec3> voxels{};
    std::vector<std::uint16_t> codes{};
    bool isDone = false;

    void readOn(EditSession& session)
    {
        const std::size_t first = codes.size();
        isDone = first == voxels.size();
        if (isDone)
            return;
        const auto from = voxels.begin() + std::ptrdiff_t(first);
        const auto count = std::ptrdiff_t(std::min(probedAtOnce, voxels.size() - first));
        session.questions().probe(
            {from, from + count}, [this, &session](const Result<std::vector<ProbedVoxel>>& probes) {
                if (!probes || probes->empty()) {
                    qWarning("an oblique slice cannot be read");
                    isDone = true;
                    return;
                }
                for (const ProbedVoxel& probe : *probes)
                    codes.push_back(std::uint16_t(probe.code));
                readOn(session);
            });
    }
};

/// What a contour reads before it evolves (ui/tools/contour/ContourRun.cpp).
struct ContourReading {
    EvolveContour edit{
        .segment = organ, .lower = Ball::valueAt(14.0), .smoothness = 30, .generations = 6};
    std::shared_ptr<LabelReader> reader;
    std::optional<ContourGround> ground{};
    bool isDone = false;

    void fail()
    {
        qWarning("a contour cannot be read");
        isDone = true;
    }
    void readOn(EditSession& session)
    {
        const auto taken = [this, &session](
                               const Result<void>& portion) { portion ? readOn(session) : fail(); };
        if (!session.questions().readOn(reader, taken))
            findGround(session);
    }
    void findGround(EditSession& session)
    {
        const std::vector<std::uint8_t> labels = reader->takeLabels();
        const std::vector<LabelPlane> planes{{.plane = 0, .labels = labels}};
        Result<ContourGround> found = trialGround(edit, session.document(), planes);
        if (!found || found->box.empty())
            return fail();
        ground = *std::move(found);
        session.questions().codes(
            ground->box, [this](const Result<std::vector<std::uint16_t>>& codes) {
                if (!codes)
                    return fail();
                ground->codes = *codes;
                isDone = true;
            });
    }
};

} // namespace

/// What is asked of a volume while the hand aims and draws, and what is worked out of it, counted
/// as by WorkOfStepsGlTest: what a pen meets in 3D, the slice that an outline follows, and the
/// contour that evolves before anybody accepts it.
class WorkOfQuestionsGlTest : public test::WorkTest {
    Q_OBJECT

public:
    WorkOfQuestionsGlTest()
        : WorkTest(QStringLiteral("questions"))
    {
    }

private:
    void prepare(CountedSession& counts) override;
    void takeSteps(CountedSession& counts, int round) override;
    [[nodiscard]] test::MoreWork allowed(const QByteArray& step) const override;
    static void pick(CountedSession& counts);
    static void sketch(CountedSession& counts, double aside);
    static void readSlices(CountedSession& counts);
    static void watchContour(CountedSession& counts);
};

void WorkOfQuestionsGlTest::prepare(CountedSession& counts)
{
    counts.prepare(test::newSegment(QStringLiteral("Organ")));
    counts.prepare(test::paintAt(organ, {Ball::middle}, 8.0));
}

void WorkOfQuestionsGlTest::pick(CountedSession& counts)
{
    EditSession& session = counts.session();
    for (const SeenBy seenBy : {SeenBy::Surface, SeenBy::Segment}) {
        PickQuestion question = questionAround(session, {3.0, 2.0});
        question.seenBy = seenBy;
        question.segments.set(organ);
        std::vector<std::optional<glm::ivec3>> met;
        bool isDone = false;
        const char* name = seenBy == SeenBy::Surface ? "pick" : "pick of a segment";
        counts.work(
            name,
            [&] {
                session.questions().pick(question, [&](const auto& picks) {
                    met = picks.value_or(met);
                    isDone = true;
                });
            },
            [&] { return isDone; });
        if (met.size() != question.rays.size() || !met.front())
            qWarning("%s has met nothing", name);
    }
}

/// Seeds where the pen meets the surface.
void WorkOfQuestionsGlTest::sketch(CountedSession& counts, double aside)
{
    EditSession& session = counts.session();
    counts.step("sketch in 3D", [&session, aside] {
        session.questions().pick(questionAround(session, {aside, -10.0}),
            [&session](const Result<std::vector<std::optional<glm::ivec3>>>& picks) {
                if (!picks)
                    return qWarning("nothing can be picked");
                std::vector<glm::dvec3> places;
                for (const std::optional<glm::ivec3>& voxel : *picks) {
                    if (voxel)
                        places.push_back(volumeOf(session).geometry.toWorld(glm::dvec3(*voxel)));
                }
                if (places.empty() || !session.apply(test::seedAt(organ, places)))
                    qWarning("a sketch was refused");
            });
        return true;
    });
}

void WorkOfQuestionsGlTest::readSlices(CountedSession& counts)
{
    EditSession& session = counts.session();
    const VolumeGeometry& geometry = volumeOf(session).geometry;
    const SliceLattice slice = latticeOf(geometry, straight);
    const SliceLattice oblique = latticeOf(geometry, aslant);
    if (!slice.box || oblique.box)
        return qWarning("slices lie elsewhere");
    SlicePixels pixels{.size = slice.size};
    bool isDone = false;
    counts.work(
        "slice for an outline",
        [&] {
            session.questions().codes(*slice.box, [&](Result<std::vector<std::uint16_t>> codes) {
                if (codes)
                    pixels.codes = *std::move(codes);
                isDone = true;
            });
        },
        [&] { return isDone; });
    if (pixels.codes.empty())
        return qWarning("a slice cannot be read");
    counts.work(
        "outline in a slice", [&] { outline(pixels, *slice.pixelAt(Ball::middle)); },
        [] { return true; });
    ObliqueReading reading;
    counts.work(
        "oblique slice for an outline",
        [&] {
            reading.voxels = nearestVoxels(oblique, geometry);
            reading.readOn(session);
        },
        [&] { return reading.isDone; });
    if (std::int64_t(reading.codes.size()) != obliquePixels(geometry.size.x))
        qWarning("an oblique slice was read in part");
}

void WorkOfQuestionsGlTest::watchContour(CountedSession& counts)
{
    EditSession& session = counts.session();
    ContourReading reading{
        .reader = std::make_shared<LabelReader>(volumeOf(session).geometry.size, 0)};
    counts.work(
        "reading for a contour", [&] { reading.readOn(session); }, [&] { return reading.isDone; });
    const Result<ContourRule> rule = contourRule(reading.edit, session.document());
    if (!reading.ground || !rule)
        return qWarning("there is no contour");
    int generations = 0;
    const ContourReports reports{
        .begun = [&](const auto& track, const auto&) { generations = track->known(); },
        .further = [&](const auto& more) { generations += int(more.size()); }};
    counts.work(
        "contour that is watched",
        [&] {
            static_cast<void>(core::watchContour(*rule, *reading.ground,
                {.generations = reading.edit.generations, .silent = 1, .bytes = allowedBytes()},
                Progress(), reports));
        },
        [] { return true; });
    if (generations != reading.edit.generations)
        qWarning("the contour has ended early");
}

void WorkOfQuestionsGlTest::takeSteps(CountedSession& counts, int round)
{
    pick(counts);
    readSlices(counts);
    watchContour(counts);
    sketch(counts, 6.0 - 12.0 * round);
}

test::MoreWork WorkOfQuestionsGlTest::allowed(const QByteArray& step) const
{
    constexpr int codeBytes = sizeof(std::uint16_t);
    // Of each pixel: brightness, costs of two sides, the cost of the way there, whether it lies
    // within the contour, and once that it has to be looked at, in a list that grows.
    constexpr int outlineBytes = 64;
    // Of each voxel that is asked for: where it lies, and what is there.
    constexpr int probeBytes = 16;
    constexpr int probeMemoryBytes = 384;
    constexpr int voxelsOfGroup = 64;
    // Of each brick that is asked for, once more: a question keeps what it asks.
    constexpr int askedBytes = 32;
    const std::int64_t few = obliquePixels(test::smallWorkSide);
    const std::int64_t many = obliquePixels(test::largeWorkSide);
    if (step == "slice for an outline")
        return test::MoreWork{.bytesDown = codeBytes * morePixels(),
            // It arrives by way of copies.
            .bytesAllocated = 3 * codeBytes * morePixels()};
    if (step == "outline in a slice")
        return test::MoreWork{.bytesAllocated = outlineBytes * morePixels()};
    if (step == "oblique slice for an outline") {
        const int portions = int(many / std::int64_t(probedAtOnce)) + 1;
        // What is there may be a seed, and seeds have a table of pages.
        return test::MoreWork{.tables = true,
            .dispatches = portions,
            .groups = (many - few) / voxelsOfGroup + portions,
            .bytesUp = probeBytes * (many - few),
            .bytesDown = probeBytes * (many - few),
            .bytesWithin = 2 * probeBytes * (many - few),
            .bytesAllocated = probeMemoryBytes * many};
    }
    if (step == "reading for a contour") {
        test::MoreWork more = onAll(2); // the segment lies in two portions
        more.bytesAllocated += askedBytes * bricksOf(test::largeWorkSide);
        return more;
    }
    return test::MoreWork{.tables = step == "sketch in 3D" || step == "back through the history"};
}

BURIN_TEST(WorkOfQuestionsGlTest)

} // namespace workOfQuestionsGlTest

#include "WorkOfQuestionsGlTest.moc"
