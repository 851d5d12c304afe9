// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/fit/InitialFit.h"
#include "core/refine/fit/MeasuredFit.h"
#include "core/refine/mesh/InternalForces.h"
#include "core/refine/mesh/SimplexOperations.h"
#include "core/refine/repair/FaceShape.h"
#include "core/refine/repair/MeshRestructuring.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/tools/MarkPaint.h"
#include "core/refine/tools/SurfaceStroke.h"
#include "core/refine/tools/TemplateShape.h"
#include "core/refine/voxels/GreyBox.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>

namespace surfaceStormTest {

using namespace core;

namespace {

/// Time of the processor, which others that use it do not lengthen.
class Stopwatch {
public:
    [[nodiscard]] qint64 elapsed() const
    {
        return qint64(1000.0 * double(std::clock() - m_start) / double(CLOCKS_PER_SEC));
    }
    qint64 restart()
    {
        const qint64 ms = elapsed();
        m_start = std::clock();
        return ms;
    }

private:
    std::clock_t m_start = std::clock();
};

/// An organ of ct_totalseg_body_3mm with its surface and grey values.
struct OrganSurface {
    VolumeGeometry geometry;
    BoxMask mask;
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
    organ->mask = BoxMask::of(held, 1, organ->geometry.size);
    auto fit =
        initialFit(organ->mask, organ->geometry, {.vertices = vertices, .keepsApart = true}, {});
    if (!fit)
        return nullptr;
    organ->mesh = *std::move(fit);
    organ->boundary = std::make_unique<BoundaryForce>(organ->mask, organ->geometry, 4.0);
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

/// What became of templates that are made by the newest rules.
struct Bodies {
    int made = 0;
    int refused = 0;
};

SimplexMeshDelta carryOut(
    OrganSurface& organ, const RandomStroke& stroke, bool isGuarded, Bodies* bodies = nullptr)
{
    SurfaceTool tool = stroke.tool;
    // What is kept apart is carried out by the newest rules.
    if (auto* shape = std::get_if<TemplateTool>(&tool); shape && isGuarded) {
        auto body =
            TemplateShape::make(organ.mesh, shape->contours, organ.areaMm2, TemplateForm::Body);
        if (bodies)
            ++(body ? bodies->made : bodies->refused);
        if (body)
            shape->shape = std::make_shared<const TemplateShape>(*std::move(body));
    }
    SurfaceStroke made(organ.mesh, organ.boundary.get(), tool,
        {.areaMm2 = organ.areaMm2,
            .reddens = true,
            .apartOn = isGuarded ? &organ.geometry : nullptr});
    for (const SurfaceSample& sample : stroke.samples)
        made.add(sample);
    return made.commit();
}

/// In edges and faces of the intended area: at the ends of what a drag has drawn out, or where no
/// split is possible.
constexpr double longestEdge = 12.0;
constexpr double largestFace = 12.0;

struct Extremes {
    double longestEdgeMm = 0.0;
    double largestMm2 = 0.0;
};

/// Of the faces that the stroke has moved and may split: those with a green vertex stay.
Extremes extremesOf(const SimplexMesh& mesh, const SimplexMeshDelta& stroke)
{
    Extremes found;
    for (const SimplexMeshDelta::VertexChange& change : stroke.vertices) {
        if (!mesh.hasVertex(change.id))
            continue;
        for (const FaceId face : mesh.facesAt(change.id)) {
            if (!isFree(mesh, face))
                continue;
            const FaceRing& ring = mesh.ring(face);
            for (std::size_t i = 0; i < ring.size(); ++i)
                found.longestEdgeMm = std::max(found.longestEdgeMm,
                    glm::distance(
                        mesh.position(ring[i]), mesh.position(ring[(i + 1) % ring.size()])));
            found.largestMm2 = std::max(found.largestMm2, areaOf(mesh, face));
        }
    }
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
    Bodies bodies;
    qint64 slowestMs = 0;
    qint64 totalMs = 0;
    std::array<qint64, kindNames.size()> counts{};
    std::array<qint64, kindNames.size()> msOf{};
    std::array<qint64, kindNames.size()> slowestOf{};
    for (int i = 0; i < count; ++i) {
        const RandomStroke stroke = maker.make(Kind(test::randomInt(random, 0, 5)));
        if (stroke.kind == Kind::Template)
            redden(mesh, stroke);
        const SimplexMesh before = mesh;
        Stopwatch timer;
        const SimplexMeshDelta delta = carryOut(*organ, stroke, true, &bodies);
        const qint64 ms = timer.elapsed();
        totalMs += ms;
        ++counts[std::size_t(stroke.kind)];
        msOf[std::size_t(stroke.kind)] += ms;
        slowestOf[std::size_t(stroke.kind)] = std::max(slowestOf[std::size_t(stroke.kind)], ms);
        slowestMs = std::max(slowestMs, ms);
        const std::size_t crossings = selfIntersections(mesh, organ->geometry).size();
        QVERIFY2(crossings == 0,
            qPrintable(QStringLiteral("stroke %1 (%2): %3 pairs")
                           .arg(i)
                           .arg(QLatin1String(kindNames[std::size_t(stroke.kind)]))
                           .arg(crossings)));
        // Closed, oriented, and of the same genus.
        const auto parts = checkSimplexMesh(mesh);
        QVERIFY2(parts, qPrintable(parts ? QString() : parts.error().arguments.join(u' ')));
        QCOMPARE(test::eulerCharacteristics(mesh), whole);
        const Extremes now = extremesOf(mesh, delta);
        worst.longestEdgeMm = std::max(worst.longestEdgeMm, now.longestEdgeMm);
        worst.largestMm2 = std::max(worst.largestMm2, now.largestMm2);
        QVERIFY2(now.longestEdgeMm < longestEdge * edgeMm
                && now.largestMm2 < largestFace * organ->areaMm2,
            qPrintable(QStringLiteral("stroke %1 (%2): an edge of %3 mm, a face of %4 mm2")
                           .arg(i)
                           .arg(QLatin1String(kindNames[std::size_t(stroke.kind)]))
                           .arg(now.longestEdgeMm)
                           .arg(now.largestMm2)));
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
    for (std::size_t kind = 0; kind < kindNames.size(); ++kind)
        qInfo("%s: %lld strokes of %.0f ms, at most %lld", kindNames[kind],
            static_cast<long long>(counts[kind]),
            double(msOf[kind]) / double(std::max<qint64>(counts[kind], 1)),
            static_cast<long long>(slowestOf[kind]));
    qInfo("%d bodies, %d refused", bodies.made, bodies.refused);
    QCOMPARE(qint64(bodies.made + bodies.refused), counts[std::size_t(Kind::Template)]);
    // Most: a contour may be drawn where nothing is red.
    QVERIFY(bodies.made > bodies.refused || count < 8);
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
    for (const bool isGuarded : {false, true}) {
        Stopwatch timer;
        const auto fit = initialFit(
            organ->mask, organ->geometry, {.vertices = vertices, .keepsApart = isGuarded}, {});
        QVERIFY(fit);
        const qint64 ms = timer.elapsed();
        const std::size_t crossings = selfIntersections(*fit, organ->geometry).size();
        qInfo("laid with %zu vertices in %lld ms, %zu pairs cross%s", fit->vertexCount(),
            static_cast<long long>(ms), crossings, isGuarded ? " now" : "");
        QVERIFY(!isGuarded || crossings == 0);
    }
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
                Stopwatch timer;
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
        Stopwatch timer;
        auto fit = measuredFit(noisy.voxels(), noisy.geometry, {}, {}, {.keepsApart = isGuarded});
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
        const SimplexMeshDelta delta = stroke.commit();
        const qint64 ms = timer.elapsed();
        const std::size_t crossings = selfIntersections(mesh, noisy.geometry).size();
        qInfo("%s: laid in %lld ms with %zu vertices, %llu of %llu voxels off, %zu pairs crossing; "
              "after a stroke of %lld ms (%lld with the pen down) %zu vertices, %zu pairs, largest "
              "face %.1f of %.2f mm2",
            isGuarded ? "now" : "before", static_cast<long long>(laidMs), first,
            static_cast<unsigned long long>(fit->voxelsOff),
            static_cast<unsigned long long>(fit->voxels), laidCrossings, static_cast<long long>(ms),
            static_cast<long long>(movedMs), mesh.vertexCount(), crossings,
            extremesOf(mesh, delta).largestMm2, areaMm2);
        if (!isGuarded)
            continue;
        QCOMPARE(crossings, std::size_t(0));
        QVERIFY(double(mesh.vertexCount()) < 1.5 * double(first));
    }
}

BURIN_TEST(SurfaceStormTest)

} // namespace surfaceStormTest

#include "SurfaceStormTest.moc"
