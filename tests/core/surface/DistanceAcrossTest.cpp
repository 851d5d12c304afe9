// SPDX-License-Identifier: Apache-2.0
#include "core/surface/DistanceAcross.h"
#include "core/surface/SegmentSurface.h"
#include "tests/support/program/TestProgram.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace distanceAcrossTest {

namespace {

struct Mesh {
    std::vector<glm::dvec3> places;
    std::vector<glm::uvec3> triangles;

    [[nodiscard]] core::LongestDistance longest() const { return core::longestDistance(places); }
    [[nodiscard]] core::LongestDistance across() const
    {
        const core::LongestDistance found = longest();
        return core::distanceAcross(places, triangles, found.to - found.from);
    }
};

/// Where a plane cuts the sides of the triangles, each by itself.
std::vector<glm::dvec3> cut(const Mesh& mesh, const glm::dvec3& along, double height)
{
    std::vector<glm::dvec3> points;
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int side = 0; side < 3; ++side) {
            const glm::dvec3 a = mesh.places[triangle[side]];
            const glm::dvec3 b = mesh.places[triangle[(side + 1) % 3]];
            const double rises = glm::dot(b - a, along);
            const double share = rises == 0.0 ? 0.0 : (height - glm::dot(a, along)) / rises;
            if (rises == 0.0 && glm::dot(a, along) != height)
                continue;
            if (share >= -1e-12 && share <= 1.0 + 1e-12)
                points.push_back(a + share * (b - a));
        }
    }
    return points;
}

double widest(const std::vector<glm::dvec3>& points)
{
    double widest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            widest = std::max(widest, glm::distance(points[i], points[k]));
    }
    return widest;
}

/// All points of the planes through all corners, and of @p more planes anywhere, each with each.
double byBruteForce(const Mesh& mesh, glm::dvec3 along, std::mt19937& random, int more)
{
    along = glm::normalize(along);
    double longest = 0.0;
    double lowest = 1e9;
    double highest = -1e9;
    for (const glm::dvec3& place : mesh.places) {
        const double height = glm::dot(place, along);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
        longest = std::max(longest, widest(cut(mesh, along, height)));
    }
    std::uniform_real_distribution<double> anywhere(lowest, highest);
    for (int i = 0; i < more; ++i)
        longest = std::max(longest, widest(cut(mesh, along, anywhere(random))));
    return longest;
}

using IsInside = std::function<bool(const glm::ivec3&)>;

/// The smoothed surface of voxels, on a grid with these axes in millimetres.
Mesh meshOf(const glm::ivec3& size, const IsInside& isInside, const glm::dmat3& axes)
{
    std::vector<std::uint8_t> labels;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                labels.push_back(isInside({x, y, z}) ? 1 : 0);
    const core::SegmentSurface surface = core::segmentSurface(labels, 1, size);
    Mesh mesh{.places = {}, .triangles = surface.triangles};
    for (const glm::vec3& vertex : surface.vertices)
        mesh.places.push_back(glm::dvec3(-250.0, 130.0, 1200.0) + axes * glm::dvec3(vertex));
    return mesh;
}

/// Turned about no axis of its own.
glm::dmat3 tilted(const glm::dvec3& spacing)
{
    const glm::dvec3 a = glm::normalize(glm::dvec3(0.8, 0.5, -0.33));
    const glm::dvec3 b = glm::normalize(glm::cross(a, glm::dvec3(0.2, -0.4, 0.89)));
    return {a * spacing.x, b * spacing.y, glm::cross(a, b) * spacing.z};
}

Mesh box(const glm::dvec3& size)
{
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.places.push_back(size * glm::dvec3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1));
    for (const glm::uvec4& face :
        {glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6), glm::uvec4(0, 1, 5, 4),
            glm::uvec4(2, 6, 7, 3), glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5)}) {
        mesh.triangles.emplace_back(face.x, face.y, face.z);
        mesh.triangles.emplace_back(face.x, face.z, face.w);
    }
    return mesh;
}

/// A step is a chord of a box if it is nowhere longer than its sides. So the longest one that is
/// perpendicular to a diagonal is as long as two of its sides, and the third follows.
double acrossOfBox(const glm::dvec3& size)
{
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double b = size[(axis + 1) % 3];
        const double c = size[(axis + 2) % 3];
        for (const double sign : {1.0, -1.0}) {
            const double third = -(b * b + sign * c * c) / size[axis];
            if (std::abs(third) <= size[axis])
                longest = std::max(longest, std::sqrt(b * b + c * c + third * third));
        }
    }
    return longest;
}

/// Of rings from pole to pole: places of a unit ball, moved to where they belong.
Mesh ringed(int rings, int round, const std::function<glm::dvec3(double, double)>& placeAt)
{
    Mesh mesh;
    const auto at = [&](int ring, int i) { return unsigned(1 + (ring - 1) * round + (i % round)); };
    mesh.places.push_back(placeAt(0.0, 0.0));
    for (int ring = 1; ring < rings; ++ring)
        for (int i = 0; i < round; ++i)
            mesh.places.push_back(
                placeAt(double(ring) / rings, 2.0 * std::numbers::pi * i / round));
    const auto last = unsigned(mesh.places.size());
    mesh.places.push_back(placeAt(1.0, 0.0));
    for (int i = 0; i < round; ++i) {
        mesh.triangles.emplace_back(0U, at(1, i), at(1, i + 1));
        mesh.triangles.emplace_back(last, at(rings - 1, i + 1), at(rings - 1, i));
        for (int ring = 1; ring + 1 < rings; ++ring) {
            mesh.triangles.emplace_back(at(ring, i), at(ring + 1, i), at(ring + 1, i + 1));
            mesh.triangles.emplace_back(at(ring, i), at(ring + 1, i + 1), at(ring, i + 1));
        }
    }
    return mesh;
}

} // namespace

/// The longest distance on a surface that is perpendicular to the longest of all.
class DistanceAcrossTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingToMeasure();
    void boxes();
    void ellipsoidsAndTubes();
    void randomMasksOnAnyGrid();
    void voxelsOfAnEllipsoid();
    void aBananaIsNoWiderThanItIs();
    void ofManyVoxels();
};

void DistanceAcrossTest::nothingToMeasure()
{
    QCOMPARE(core::distanceAcross({}, {}, {1.0, 0.0, 0.0}).length(), 0.0);
    const Mesh cube = box(glm::dvec3(1.0));
    QCOMPARE(core::distanceAcross(cube.places, cube.triangles, {}).length(), 0.0);
}

/// Their faces lie in planes of many equal heights, or in none.
void DistanceAcrossTest::boxes()
{
    for (const glm::dvec3& size :
        {glm::dvec3(1.0), glm::dvec3(8.0, 1.0, 1.0), glm::dvec3(30.0, 20.0, 10.0),
            glm::dvec3(0.7, 40.0, 39.0), glm::dvec3(3.0, 4.0, 12.0)}) {
        const Mesh mesh = box(size);
        const core::LongestDistance found = mesh.across();
        QVERIFY2(std::abs(found.length() - acrossOfBox(size)) < 1e-9,
            qPrintable(
                QStringLiteral("%1 instead of %2").arg(found.length()).arg(acrossOfBox(size))));
        const core::LongestDistance longest = mesh.longest();
        QVERIFY(std::abs(longest.length() - glm::length(size)) < 1e-12);
        QVERIFY(std::abs(glm::dot(longest.to - longest.from, found.to - found.from)) < 1e-9);
    }
    // Along an edge it is the diagonal of a face, whatever the length of the direction.
    const Mesh mesh = box({3.0, 4.0, 12.0});
    for (const double scale : {1e-3, 1.0, -1e5}) {
        const auto found = core::distanceAcross(mesh.places, mesh.triangles, {0.0, 0.0, scale});
        QVERIFY(std::abs(found.length() - 5.0) < 1e-12);
    }
}

void DistanceAcrossTest::ellipsoidsAndTubes()
{
    const glm::dmat3 turn = tilted(glm::dvec3(1.0));
    for (const glm::dvec3& half :
        {glm::dvec3(9.0, 12.0, 40.0), glm::dvec3(11.0, 29.0, 30.0), glm::dvec3(2.0, 2.5, 80.0)}) {
        const Mesh mesh = ringed(96, 128, [&](double share, double turned) {
            const double polar = std::numbers::pi * share;
            return turn
                * (half
                    * glm::dvec3(std::sin(polar) * std::cos(turned),
                        std::sin(polar) * std::sin(turned), std::cos(polar)));
        });
        const double found = mesh.across().length();
        QVERIFY2(std::abs(found - 2.0 * half.y) < 1e-3 * 2.0 * half.y,
            qPrintable(QStringLiteral("%1 of %2").arg(found).arg(2.0 * half.y)));
    }
    // A tube's longest diameter is tilted against it, and so is the one across: with the angle
    // between a rectangle's diagonal and its long side.
    for (const double length : {20.0, 60.0, 300.0}) {
        constexpr double radius = 6.0;
        const Mesh mesh = ringed(3, 256, [&](double share, double turned) {
            const double inside = share > 0.0 && share < 1.0 ? radius : 0.0;
            return turn
                * glm::dvec3(inside * std::cos(turned), inside * std::sin(turned),
                    share < 0.5 ? 0.0 : length);
        });
        const double right = 2.0 * radius * std::hypot(length, 2.0 * radius) / length;
        const double found = mesh.across().length();
        QVERIFY2(std::abs(found - right) < 1e-3 * right,
            qPrintable(QStringLiteral("%1 of %2").arg(found).arg(right)));
    }
}

/// Small ones, in one piece or several, held to all pairs of points of all planes.
void DistanceAcrossTest::randomMasksOnAnyGrid()
{
    std::mt19937 random(350);
    const std::array<glm::dmat3, 4> grids{glm::dmat3(1.0),
        glm::dmat3(glm::dvec3(0.5, 0, 0), glm::dvec3(0, 0.5, 0), glm::dvec3(0, 0, 4.0)),
        tilted({1.0, 1.0, 1.0}), tilted({0.6, 0.6, 4.8})};
    int measured = 0;
    for (int round = 0; round < 60; ++round) {
        const glm::ivec3 size(2 + int(random() % 4), 2 + int(random() % 4), 1 + int(random() % 4));
        const unsigned share = 1 + random() % 9; // of ten
        const Mesh mesh = meshOf(
            size, [&](const glm::ivec3&) { return random() % 10 < share; },
            grids[std::size_t(round) % grids.size()]);
        if (mesh.places.empty())
            continue;
        const core::LongestDistance longest = mesh.longest();
        const core::LongestDistance found = mesh.across();
        const glm::dvec3 along = longest.to - longest.from;
        const double right = byBruteForce(mesh, along, random, 40);
        QVERIFY2(std::abs(found.length() - right) <= 2e-9 * right,
            qPrintable(
                QStringLiteral("round %1: %2 of %3").arg(round).arg(found.length()).arg(right)));
        QVERIFY(std::abs(glm::dot(glm::normalize(along), found.to - found.from)) < 1e-9);
        QVERIFY(found.length() > 0.0 && found.length() <= longest.length());
        ++measured;
    }
    QVERIFY(measured > 50);
}

/// What voxels make of a shape: right to within one of them.
void DistanceAcrossTest::voxelsOfAnEllipsoid()
{
    for (const glm::dvec3& spacing : {glm::dvec3(1.0), glm::dvec3(0.5, 0.5, 2.0)}) {
        const glm::dvec3 half(10.0, 16.0, 30.0);
        const glm::ivec3 size(glm::ceil(2.0 * half / spacing) + 4.0);
        const glm::dvec3 middle = glm::dvec3(size) / 2.0 + glm::dvec3(0.1, -0.3, 0.2);
        const Mesh mesh = meshOf(
            size,
            [&](const glm::ivec3& voxel) {
                return glm::length((glm::dvec3(voxel) - middle) * spacing / half) <= 1.0;
            },
            tilted(spacing));
        const double found = mesh.across().length();
        qInfo("%.3f mm of 32, %.3f mm of 60", found, mesh.longest().length());
        QVERIFY(std::abs(found - 32.0) < spacing.y);
    }
}

/// A bent tube: its longest distance spans the bend, and none of the planes across it meets the
/// tube in more than its width or, near the ends, both arms.
void DistanceAcrossTest::aBananaIsNoWiderThanItIs()
{
    // A third of a ring with radius 30 and a tube of radius 4.
    const Mesh mesh = ringed(120, 64, [](double share, double turned) {
        const double bent = (share - 0.5) * 2.0 * std::numbers::pi / 3.0;
        const double inside = 4.0 * std::sqrt(1.0 - std::pow(2.0 * share - 1.0, 16.0));
        const double from = 30.0 + inside * std::cos(turned);
        return glm::dvec3(from * std::sin(bent), from * std::cos(bent), inside * std::sin(turned));
    });
    const double found = mesh.across().length();
    // Its shadow is from 30 cos 60° to 34: wider by far. Cut at 60° the tube is at most twice as
    // wide as straight across.
    QVERIFY2(found >= 8.0 && found < 12.0, qPrintable(QString::number(found)));
}

/// The time is that of the longest distance, or a few times as long where many planes are nearly as
/// wide as the widest: in a tube, or in dust.
void DistanceAcrossTest::ofManyVoxels()
{
    const bool isLong = qEnvironmentVariableIsSet("BURIN_LONG");
    const auto measure = [](const char* shape, const glm::ivec3& size, const IsInside& isInside) {
        const Mesh mesh = meshOf(size, isInside, tilted(glm::dvec3(1.0)));
        QElapsedTimer clock;
        clock.start();
        const core::LongestDistance longest = mesh.longest();
        const qint64 before = clock.restart();
        const double found =
            core::distanceAcross(mesh.places, mesh.triangles, longest.to - longest.from).length();
        qInfo("%s of %zu corners: %.3f mm in %lld ms, %.3f mm across in %lld ms", shape,
            mesh.places.size(), longest.length(), before, found, clock.elapsed());
        return found;
    };
    const glm::dvec3 half = isLong ? glm::dvec3(133.5) : glm::dvec3(30.0, 40.0, 60.0);
    const glm::ivec3 size(glm::ceil(2.0 * half) + 4.0);
    const glm::dvec3 middle = glm::dvec3(size) / 2.0 + glm::dvec3(0.1, -0.3, 0.2);
    const double ball = measure("ball", size, [&](const glm::ivec3& voxel) {
        return glm::length((glm::dvec3(voxel) - middle) / half) <= 1.0;
    });
    QVERIFY(std::abs(ball - 2.0 * half.y) < 1.0);
    const double scale = isLong ? 2.0 : 1.0;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, 2.0, 4.0));
    const double tube = measure("tube", glm::ivec3(100.0 * scale), [&](const glm::ivec3& voxel) {
        const glm::dvec3 from = glm::dvec3(voxel) - glm::dvec3(50.0 * scale);
        const double along = glm::dot(from, axis);
        return std::abs(along) < 45.0 * scale && glm::length(from - along * axis) < 15.0 * scale;
    });
    QVERIFY(std::abs(tube - 30.0 * scale * std::hypot(3.0, 1.0) / 3.0) < 1.5);
    std::mt19937 random(351);
    const double side = 50.0 * scale;
    const double dust =
        measure("dust", glm::ivec3(side), [&](const glm::ivec3&) { return random() % 2 == 0; });
    QVERIFY(std::abs(dust - side * std::sqrt(2.0)) < 3.0);
}

BURIN_TEST(DistanceAcrossTest)

} // namespace distanceAcrossTest

#include "DistanceAcrossTest.moc"
