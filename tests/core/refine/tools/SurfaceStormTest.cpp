// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/fit/InitialFit.h"
#include "core/refine/fit/MeasuredFit.h"
#include "core/refine/mesh/InternalForces.h"
#include "core/refine/repair/FaceShape.h"
#include "core/refine/repair/MeshRestructuring.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/tools/MarkPaint.h"
#include "core/refine/tools/SurfaceStroke.h"
#include "core/refine/tools/TemplateShape.h"
#include "core/refine/voxels/GreyBox.h"
#include "core/study/StudyLoader.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace core;

namespace {

/// An organ of ct_totalseg_body_3mm with its surface and grey values.
struct OrganSurface {
    VolumeGeometry geometry;
    SimplexMesh mesh;
    std::unique_ptr<BoundaryForce> boundary;
    std::unique_ptr<GreyBox> grey;
    double areaMm2 = 0.0;
};

/// @param value of the organ among the labels. Null: no shared data.
std::unique_ptr<OrganSurface> organSurface(int value, int vertices)
{
    const test::SharedCase shared = test::sharedCase(QStringLiteral("ct_totalseg_body_3mm"));
    if (shared.source.isEmpty())
        return nullptr;
    const auto labels = loadVolume(shared.source + QStringLiteral("/ct_3mm_labels.nii.gz"), {});
    const auto image = loadVolume(shared.source + QStringLiteral("/ct_3mm.nii.gz"), {});
    if (!labels || !image)
        return nullptr;
    auto organ = std::make_unique<OrganSurface>();
    organ->geometry = labels->volume.geometry;
    std::vector<std::uint8_t> held(labels->codes.size(), 0);
    for (std::size_t i = 0; i < held.size(); ++i)
        held[i] = std::lround(labels->volume.encoding.value(labels->codes[i])) == value ? 1 : 0;
    const BoxMask mask = BoxMask::of(held, 1, organ->geometry.size);
    auto fit = initialFit(mask, organ->geometry, {.vertices = vertices, .keepsApart = true}, {});
    if (!fit)
        return nullptr;
    organ->mesh = *std::move(fit);
    organ->boundary = std::make_unique<BoundaryForce>(mask, organ->geometry, 4.0);
    organ->grey = std::make_unique<GreyBox>(
        organ->geometry, glm::ivec3(0), organ->geometry.size, image->codes);
    organ->areaMm2 = meanFaceAreaMm2(organ->mesh);
    return organ;
}

enum class Kind : std::uint8_t { Sphere, Scrape, Drag, Smooth, Attract, Template };
constexpr std::array<const char*, 6> kindNames{
    "sphere", "scraper", "drag", "smooth", "attract", "template"};

/// A stroke as a hand makes it, somewhere on the surface.
struct RandomStroke {
    Kind kind = Kind::Sphere;
    SurfaceTool tool;
    std::vector<SurfaceSample> samples;
    glm::dvec3 startLps{0.0};
    double radiusMm = 0.0;
};

class StrokeMaker {
public:
    StrokeMaker(test::Random& random, const OrganSurface& organ)
        : m_random(random)
        , m_organ(organ)
    {
    }

    RandomStroke make(Kind kind)
    {
        const SimplexMesh& mesh = m_organ.mesh;
        VertexId id = noId;
        while (id == noId || !mesh.hasVertex(id))
            id = VertexId(test::randomInt(m_random, 0, int(mesh.vertexSlots()) - 1));
        const glm::dvec3 place = mesh.position(id);
        glm::dvec3 normal = frameAt(mesh, id).normalLps;
        if (!(glm::length(normal) > 0.0))
            normal = {0, 0, 1};
        const glm::dvec3 aside =
            std::abs(normal.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 u = glm::normalize(glm::cross(normal, aside));
        const glm::dvec3 v = glm::cross(normal, u);
        const double radius = 4.0 + 12.0 * unit();
        RandomStroke stroke{
            .kind = kind, .tool = {}, .samples = {}, .startLps = place, .radiusMm = radius};
        const double turn = 6.283 * unit();
        const glm::dvec3 along = std::cos(turn) * u + std::sin(turn) * v;
        const double side = unit() < 0.5 ? 0.5 : -0.5;
        const double lengthMm = 5.0 + 25.0 * unit();
        glm::dvec3 offset(0.0);
        switch (kind) {
        case Kind::Sphere:
            stroke.tool = SphereTool{.radiusMm = radius};
            offset = side * radius * normal;
            break;
        case Kind::Scrape:
            stroke.tool = PlaneTool{.normalLps = normal,
                .radiusMm = radius,
                .heightMm = 2.0 * radius,
                .acrossLps = unit() < 0.5 ? glm::cross(normal, along) : glm::dvec3(0.0)};
            offset = -3.0 * unit() * normal;
            break;
        case Kind::Drag:
            stroke.tool = DragTool{.radiusMm = radius};
            stroke.samples = {{.placeLps = place},
                {.placeLps =
                        place + radius * (unit() - 0.3) * normal + 0.5 * radius * unit() * along}};
            return stroke;
        case Kind::Smooth:
            stroke.tool = SmoothTool{.radiusMm = radius};
            break;
        case Kind::Attract:
            stroke.tool = AttractTool{
                .radiusMm = radius, .reachMm = 0.5 * radius, .grey = m_organ.grey.get()};
            break;
        case Kind::Template:
            stroke.tool = TemplateTool{
                .contours = {arc(place, u, normal, radius), arc(place, v, normal, radius)}};
            stroke.samples = {{}};
            return stroke;
        }
        for (double mm = 0.0; mm <= lengthMm; mm += 3.0)
            stroke.samples.push_back(
                {.placeLps = place + offset + mm * along, .pressure = 0.7 + 0.3 * unit()});
        return stroke;
    }

private:
    double unit() { return test::randomUnit(m_random); }
    /// Bulges out or in, by up to a third of the radius.
    TemplateContour arc(
        const glm::dvec3& place, const glm::dvec3& along, const glm::dvec3& up, double radius)
    {
        const double heightMm = radius * (0.6 * unit() - 0.3);
        TemplateContour contour;
        for (int i = -4; i <= 4; ++i) {
            const double s = i / 4.0;
            contour.pointsLps.push_back(
                place + 0.8 * radius * s * along + heightMm * (1.0 - s * s) * up);
        }
        return contour;
    }

    test::Random& m_random;
    const OrganSurface& m_organ;
};

void markAll(SimplexMesh& mesh, SurfaceMark from, SurfaceMark to)
{
    SimplexMeshEdit edit(mesh);
    for (const VertexId id : mesh.vertexIds()) {
        if (mesh.mark(id) == from)
            edit.setMark(id, to);
    }
    edit.commit();
}

/// What a template is given before it.
void redden(SimplexMesh& mesh, const RandomStroke& stroke)
{
    SimplexMeshEdit edit(mesh);
    paintMarks(edit, stroke.startLps, 1.2 * stroke.radiusMm, SurfaceMark::Red);
    edit.commit();
}

SimplexMeshDelta carryOut(OrganSurface& organ, const RandomStroke& stroke, bool isGuarded)
{
    SurfaceStroke made(organ.mesh, organ.boundary.get(), stroke.tool,
        {.areaMm2 = organ.areaMm2,
            .reddens = true,
            .apartOn = isGuarded ? &organ.geometry : nullptr});
    for (const SurfaceSample& sample : stroke.samples)
        made.add(sample);
    return made.commit();
}

struct Extremes {
    double longestEdgeMm = 0.0;
    double largestMm2 = 0.0;
};

Extremes extremesOf(const SimplexMesh& mesh)
{
    Extremes found;
    for (const VertexId id : mesh.vertexIds()) {
        for (const VertexId near : mesh.neighbours(id))
            found.longestEdgeMm = std::max(
                found.longestEdgeMm, glm::distance(mesh.position(id), mesh.position(near)));
    }
    for (const FaceId face : mesh.faceIds())
        found.largestMm2 = std::max(found.largestMm2, areaOf(mesh, face));
    return found;
}

void organs()
{
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("vertices");
    QTest::newRow("liver") << 5 << 12'000;
    QTest::newRow("portal vein") << 64 << 5'000;
    QTest::newRow("hip bone") << 77 << 12'000;
}

} // namespace

/// Whatever is done to it, no surface passes through itself.
class SurfaceStormTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void noStrokeMakesItCross_data() { organs(); }
    void noStrokeMakesItCross();
    void freshSurfaces_data() { organs(); }
    void freshSurfaces();
    void aNoisySegmentIsNotShattered();
};

void SurfaceStormTest::noStrokeMakesItCross()
{
    QFETCH(int, value);
    QFETCH(int, vertices);
    const auto organ = organSurface(value, vertices);
    if (!organ)
        QSKIP("no shared test data");
    SimplexMesh& mesh = organ->mesh;
    QVERIFY(selfIntersections(mesh, organ->geometry).empty());
    const std::vector<int> whole = test::eulerCharacteristics(mesh);
    const std::size_t first = mesh.vertexCount();
    const double edgeMm = 0.62 * std::sqrt(organ->areaMm2);
    auto random = test::Random(std::uint64_t(value));
    StrokeMaker maker(random, *organ);
    int count = test::longRun() ? 3334 : 8;
    if (qEnvironmentVariableIsSet("BURIN_STORM"))
        count = qEnvironmentVariableIntValue("BURIN_STORM");
    std::size_t most = first;
    Extremes worst;
    qint64 slowestMs = 0;
    qint64 totalMs = 0;
    for (int i = 0; i < count; ++i) {
        const RandomStroke stroke = maker.make(Kind(test::randomInt(random, 0, 5)));
        if (stroke.kind == Kind::Template)
            redden(mesh, stroke);
        const SimplexMesh before = mesh;
        QElapsedTimer timer;
        timer.start();
        const SimplexMeshDelta delta = carryOut(*organ, stroke, true);
        const qint64 ms = timer.elapsed();
        totalMs += ms;
        slowestMs = std::max(slowestMs, ms);
        const std::size_t crossings = selfIntersections(mesh, organ->geometry).size();
        QVERIFY2(crossings == 0,
            qPrintable(QStringLiteral("stroke %1 (%2): %3 pairs")
                           .arg(i)
                           .arg(QLatin1String(kindNames[std::size_t(stroke.kind)]))
                           .arg(crossings)));
        QCOMPARE(test::eulerCharacteristics(mesh), whole);
        const Extremes now = extremesOf(mesh);
        worst.longestEdgeMm = std::max(worst.longestEdgeMm, now.longestEdgeMm);
        worst.largestMm2 = std::max(worst.largestMm2, now.largestMm2);
        most = std::max(most, mesh.vertexCount());
        SimplexMesh back = mesh;
        delta.undo(back);
        QVERIFY(identical(back, before));
        // What was dragged is free again, and what was moved may go back to the mask.
        if (i % 10 == 9)
            markAll(mesh, SurfaceMark::Green, SurfaceMark::Red);
        if (i % 40 == 39)
            markAll(mesh, SurfaceMark::Red, SurfaceMark::Yellow);
    }
    qInfo("%d strokes: %zu vertices at first, at most %zu; longest edge %.1f of %.1f mm, largest "
          "face %.1f of %.1f mm2; %.0f ms a stroke, at most %lld",
        count, first, most, worst.longestEdgeMm, edgeMm, worst.largestMm2, organ->areaMm2,
        double(totalMs) / count, static_cast<long long>(slowestMs));
}

/// How many strokes of each tool make a surface cross that was just laid, with and without.
void SurfaceStormTest::freshSurfaces()
{
    QFETCH(int, value);
    QFETCH(int, vertices);
    const int count = test::longRun() ? 100 : qEnvironmentVariableIntValue("BURIN_STORM_FRESH");
    if (count == 0)
        QSKIP("a measurement of long runs");
    const auto organ = organSurface(value, vertices);
    if (!organ)
        QSKIP("no shared test data");
    for (int kind = 0; kind < int(kindNames.size()); ++kind) {
        std::array<int, 2> crossing{};
        std::array<qint64, 2> ms{};
        auto random = test::Random(std::uint64_t(100 * value + kind));
        for (int i = 0; i < count; ++i) {
            const RandomStroke stroke = StrokeMaker(random, *organ).make(Kind(kind));
            for (const bool isGuarded : {false, true}) {
                const SimplexMesh before = organ->mesh;
                if (stroke.kind == Kind::Template)
                    redden(organ->mesh, stroke);
                QElapsedTimer timer;
                timer.start();
                carryOut(*organ, stroke, isGuarded);
                ms[std::size_t(isGuarded)] += timer.elapsed();
                const bool crosses = !selfIntersections(organ->mesh, organ->geometry).empty();
                crossing[std::size_t(isGuarded)] += crosses ? 1 : 0;
                organ->mesh = before;
            }
        }
        qInfo("%s: %d of %d strokes crossed, %d now; %.0f ms each, %.0f now",
            kindNames[std::size_t(kind)], crossing[0], count, crossing[1], double(ms[0]) / count,
            double(ms[1]) / count);
        QCOMPARE(crossing[1], 0);
    }
}

/// 10 mL with a boundary as ragged as noise: no stroke wakes all of it, nor makes it finer and
/// finer.
void SurfaceStormTest::aNoisySegmentIsNotShattered()
{
    if (!test::longRun() && !qEnvironmentVariableIsSet("BURIN_STORM"))
        QSKIP("for long runs");
    auto random = test::Random(10);
    test::ShapedMask noisy({40, 40, 40});
    noisy.fill([&random](const glm::dvec3& at) {
        return glm::distance(at, glm::dvec3(19.5)) < 13.4 + 3.0 * (test::randomUnit(random) - 0.5);
    });
    const BoundaryForce boundary(noisy.mask(), noisy.geometry, 4.0);
    for (const bool isGuarded : {false, true}) {
        QElapsedTimer timer;
        timer.start();
        auto fit = measuredFit(noisy.voxels(), noisy.geometry, {}, {}, isGuarded);
        QVERIFY(fit.has_value());
        const qint64 laidMs = timer.restart();
        SimplexMesh mesh = std::move(fit->mesh);
        const std::size_t first = mesh.vertexCount();
        const std::size_t laidCrossings = selfIntersections(mesh, noisy.geometry).size();
        const double areaMm2 = meanFaceAreaMm2(mesh);
        timer.restart();
        SurfaceStroke stroke(mesh, &boundary, SphereTool{.radiusMm = 6.0},
            {.areaMm2 = areaMm2,
                .reddens = true,
                .apartOn = isGuarded ? &noisy.geometry : nullptr});
        for (double mm = 0.0; mm < 15.0; mm += 3.0)
            stroke.add({.placeLps = noisy.lps({19.5 + mm - 7.5, 19.5, 35.0})});
        const qint64 movedMs = timer.elapsed();
        stroke.commit();
        const qint64 ms = timer.elapsed();
        const std::size_t crossings = selfIntersections(mesh, noisy.geometry).size();
        qInfo("%s: laid in %lld ms with %zu vertices, %llu of %llu voxels off, %zu pairs crossing; "
              "after a stroke of %lld ms (%lld with the pen down) %zu vertices, %zu pairs, largest "
              "face %.1f of %.2f mm2",
            isGuarded ? "now" : "before", static_cast<long long>(laidMs), first,
            static_cast<unsigned long long>(fit->voxelsOff),
            static_cast<unsigned long long>(fit->voxels), laidCrossings, static_cast<long long>(ms),
            static_cast<long long>(movedMs), mesh.vertexCount(), crossings,
            extremesOf(mesh).largestMm2, areaMm2);
        if (!isGuarded)
            continue;
        QCOMPARE(crossings, std::size_t(0));
        QVERIFY(double(mesh.vertexCount()) < 1.5 * double(first));
    }
}

BURIN_TEST(SurfaceStormTest)
#include "SurfaceStormTest.moc"
