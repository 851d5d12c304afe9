// SPDX-License-Identifier: Apache-2.0
#include "core/surface/SegmentSurface.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <cmath>
#include <map>
#include <numeric>

namespace segmentSurfaceTest {

namespace {

struct Labels {
    glm::ivec3 size{0};
    std::vector<std::uint8_t> voxels;

    explicit Labels(const glm::ivec3& of)
        : size(of)
        , voxels(std::size_t(of.x) * std::size_t(of.y) * std::size_t(of.z), 0)
    {
    }
    [[nodiscard]] std::uint8_t& at(int x, int y, int z)
    {
        return voxels[std::size_t((z * size.y + y) * size.x + x)];
    }
    template <typename Inside> void fill(const Inside& inside)
    {
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x)
                    at(x, y, z) = inside(glm::dvec3(x, y, z)) ? 1 : 0;
            }
        }
    }
    [[nodiscard]] core::SegmentSurface surface() const
    {
        return core::segmentSurface(voxels, 1, size);
    }
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// How often triangles run along each edge, by direction.
std::map<Edge, int> edgesOf(const core::SegmentSurface& surface)
{
    std::map<Edge, int> edges;
    for (const glm::uvec3& triangle : surface.triangles) {
        for (int i = 0; i < 3; ++i)
            ++edges[{triangle[i], triangle[(i + 1) % 3]}];
    }
    return edges;
}

/// V − E + F; 2 for each closed part without a handle.
int eulerNumber(const core::SegmentSurface& surface)
{
    return int(surface.vertices.size()) - int(edgesOf(surface).size() / 2)
        + int(surface.triangles.size());
}

double volumeOf(const core::SegmentSurface& surface)
{
    double volume = 0.0;
    for (const glm::uvec3& triangle : surface.triangles) {
        const glm::dvec3 a(surface.vertices[triangle.x]);
        const glm::dvec3 b(surface.vertices[triangle.y]);
        const glm::dvec3 c(surface.vertices[triangle.z]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

/// How often the surface winds around a point: solid angles (van Oosterom and Strackee 1983).
double windingAround(const core::SegmentSurface& surface, const glm::dvec3& point)
{
    double angle = 0.0;
    for (const glm::uvec3& triangle : surface.triangles) {
        const glm::dvec3 a = glm::dvec3(surface.vertices[triangle.x]) - point;
        const glm::dvec3 b = glm::dvec3(surface.vertices[triangle.y]) - point;
        const glm::dvec3 c = glm::dvec3(surface.vertices[triangle.z]) - point;
        const double la = glm::length(a);
        const double lb = glm::length(b);
        const double lc = glm::length(c);
        angle += 2.0
            * std::atan2(glm::dot(a, glm::cross(b, c)),
                la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return angle / (4.0 * M_PI);
}

void verifyClosed(const core::SegmentSurface& surface)
{
    const auto edges = edgesOf(surface);
    for (const auto& [edge, count] : edges) {
        QCOMPARE(count, 1);
        const auto back = edges.find({edge.second, edge.first});
        QVERIFY(back != edges.end());
        QVERIFY(edge.first != edge.second);
    }
    std::vector<bool> used(surface.vertices.size(), false);
    for (const glm::uvec3& triangle : surface.triangles)
        used[triangle.x] = used[triangle.y] = used[triangle.z] = true;
    QVERIFY(std::find(used.begin(), used.end(), false) == used.end());
}

} // namespace

/// Closed surfaces around voxels.
class SegmentSurfaceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shapes_data();
    void shapes();
    void everyCornerOfEightVoxelsIsClosed();
    void theVeryVoxelsOfNoise_data();
    void theVeryVoxelsOfNoise();
    void aBallIsSmooth();
    void bordersAreThoseOfVoxels();
    void nothing();
};

void SegmentSurfaceTest::shapes_data()
{
    QTest::addColumn<QString>("shape");
    QTest::addColumn<int>("euler");
    QTest::newRow("one voxel") << QStringLiteral("voxel") << 2;
    QTest::newRow("a ball") << QStringLiteral("ball") << 2;
    QTest::newRow("a ring") << QStringLiteral("ring") << 0;
    QTest::newRow("a hollow ball") << QStringLiteral("hollow") << 4;
    QTest::newRow("the whole grid") << QStringLiteral("all") << 2;
    QTest::newRow("two that touch at an edge") << QStringLiteral("edge") << 4;
    QTest::newRow("two that touch at a corner") << QStringLiteral("corner") << 4;
    // Around an edge where it meets itself.
    QTest::newRow("a bent bar whose ends touch at an edge") << QStringLiteral("bent") << 2;
}

void SegmentSurfaceTest::shapes()
{
    QFETCH(QString, shape);
    QFETCH(int, euler);
    Labels labels({15, 14, 13});
    const glm::dvec3 middle(7, 6.5, 6);
    const auto radius = [&](const glm::dvec3& at) { return glm::distance(at, middle); };
    if (shape == QLatin1String("ball"))
        labels.fill([&](const glm::dvec3& at) { return radius(at) < 5.0; });
    else if (shape == QLatin1String("hollow"))
        labels.fill([&](const glm::dvec3& at) { return radius(at) < 6.0 && radius(at) > 3.0; });
    else if (shape == QLatin1String("ring"))
        labels.fill([&](const glm::dvec3& at) {
            const double ring = glm::length(glm::dvec2(at) - glm::dvec2(middle)) - 4.5;
            return std::hypot(ring, at.z - middle.z) < 1.9;
        });
    else if (shape == QLatin1String("all"))
        labels.fill([](const glm::dvec3&) { return true; });
    else
        labels.at(5, 5, 5) = 1;
    if (shape == QLatin1String("edge"))
        labels.at(6, 6, 5) = 1;
    if (shape == QLatin1String("corner"))
        labels.at(6, 6, 6) = 1;
    if (shape == QLatin1String("bent")) {
        for (const glm::ivec3& voxel :
            {glm::ivec3(6, 6, 5), glm::ivec3(5, 5, 6), glm::ivec3(6, 6, 6), glm::ivec3(5, 6, 6)})
            labels.at(voxel.x, voxel.y, voxel.z) = 1;
    }
    const auto surface = labels.surface();
    verifyClosed(surface);
    QCOMPARE(eulerNumber(surface), euler);
    const int voxels = int(std::count(labels.voxels.begin(), labels.voxels.end(), 1));
    const double volume = volumeOf(surface);
    QVERIFY2(volume > 0.0 && volume < 1.1 * voxels, qPrintable(QString::number(volume)));
    if (voxels > 100)
        QVERIFY2(std::abs(volume / voxels - 1.0) < 0.05, qPrintable(QString::number(volume)));
}

void SegmentSurfaceTest::everyCornerOfEightVoxelsIsClosed()
{
    for (int configuration = 1; configuration < 256; ++configuration) {
        // Also twice along an axis, so that edges between two such corners occur.
        for (int axis = -1; axis < 3; ++axis) {
            Labels labels({5, 5, 5});
            for (int voxel = 0; voxel < 8; ++voxel) {
                if (((configuration >> voxel) & 1) == 0)
                    continue;
                glm::ivec3 at(1 + (voxel & 1), 1 + ((voxel >> 1) & 1), 1 + ((voxel >> 2) & 1));
                labels.at(at.x, at.y, at.z) = 1;
                if (axis >= 0) {
                    at[axis] = at[axis] == 1 ? 3 : 2;
                    labels.at(at.x, at.y, at.z) = 1;
                }
            }
            verifyClosed(labels.surface());
            QVERIFY(eulerNumber(labels.surface()) % 2 == 0);
        }
    }
}

void SegmentSurfaceTest::theVeryVoxelsOfNoise_data()
{
    QTest::addColumn<int>("share");
    for (const int share : {3, 20, 50, 80, 97})
        QTest::addRow("%d %% of the voxels", share) << share;
}

/// The centre of each voxel is inside or outside as the voxel is.
void SegmentSurfaceTest::theVeryVoxelsOfNoise()
{
    QFETCH(int, share);
    auto random = test::Random(unsigned(share));
    for (int trial = 0; trial < (test::longRun() ? 100 : 4); ++trial) {
        Labels labels({test::randomInt(random, 1, 8), test::randomInt(random, 1, 7),
            test::randomInt(random, 1, 6)});
        for (auto& label : labels.voxels)
            label = test::randomInt(random, 0, 99) < share ? 1 : 2;
        const auto surface = labels.surface();
        verifyClosed(surface);
        for (int z = 0; z < labels.size.z; ++z) {
            for (int y = 0; y < labels.size.y; ++y) {
                for (int x = 0; x < labels.size.x; ++x) {
                    const double winding = windingAround(surface, {x, y, z});
                    const double expected = labels.at(x, y, z) == 1 ? 1.0 : 0.0;
                    QVERIFY2(
                        std::abs(winding - expected) < 1e-6, qPrintable(QString::number(winding)));
                }
            }
        }
    }
}

/// The steps of the voxels are all but gone: normals turn with the ball.
void SegmentSurfaceTest::aBallIsSmooth()
{
    Labels labels({41, 41, 41});
    labels.fill([](const glm::dvec3& at) { return glm::distance(at, glm::dvec3(20)) < 17.0; });
    const auto surface = labels.surface();
    double farthest = 0.0;
    double turned = 0.0;
    double area = 0.0;
    for (const glm::vec3& vertex : surface.vertices)
        farthest =
            std::max(farthest, std::abs(double(glm::distance(vertex, glm::vec3(20.0F))) - 17.0));
    for (const glm::uvec3& triangle : surface.triangles) {
        const glm::dvec3 a(surface.vertices[triangle.x]);
        const glm::dvec3 b(surface.vertices[triangle.y]);
        const glm::dvec3 c(surface.vertices[triangle.z]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double size = glm::length(normal);
        if (size <= 0.0)
            continue;
        const double cosine =
            glm::dot(normal / size, glm::normalize((a + b + c) / 3.0 - glm::dvec3(20)));
        turned += size * std::acos(std::clamp(cosine, -1.0, 1.0));
        area += size;
    }
    const double degrees = glm::degrees(turned / area);
    qInfo("mean angle between surface and ball: %.1f degrees, at most %.2f voxels off", degrees,
        farthest);
    // That of the voxels' own faces is about 33 degrees.
    QVERIFY(degrees < 12.0);
    QVERIFY(farthest < 1.0);
}

void SegmentSurfaceTest::bordersAreThoseOfVoxels()
{
    auto random = test::Random(2);
    for (int trial = 0; trial < 20; ++trial) {
        Labels labels({test::randomInt(random, 1, 7), test::randomInt(random, 1, 6),
            test::randomInt(random, 1, 5)});
        int voxels = 0;
        for (auto& label : labels.voxels) {
            label = test::randomInt(random, 0, 9) < trial % 10 ? 1 : 0;
            voxels += label;
        }
        const core::SegmentSurface borders = core::segmentBorders(labels.voxels, 1, labels.size);
        verifyClosed(borders);
        QCOMPARE(eulerNumber(borders), eulerNumber(labels.surface()));
        QVERIFY(std::abs(volumeOf(borders) - double(voxels)) < 1e-6);
        for (const glm::vec3& vertex : borders.vertices)
            QVERIFY(glm::floor(2.0F * vertex) == 2.0F * vertex);
        // Squares are cut from their lowest corner to their highest.
        for (const glm::uvec3& triangle : borders.triangles) {
            for (int i = 0; i < 3; ++i) {
                const glm::vec3 way =
                    borders.vertices[triangle[(i + 1) % 3]] - borders.vertices[triangle[i]];
                const float sum = std::abs(way.x + way.y + way.z);
                const float wholes = std::abs(way.x) + std::abs(way.y) + std::abs(way.z);
                if (glm::dot(way, way) == 2.0F)
                    QCOMPARE(sum, wholes);
            }
        }
    }
}

void SegmentSurfaceTest::nothing()
{
    const Labels labels({3, 3, 3});
    const auto surface = labels.surface();
    QVERIFY(surface.vertices.empty() && surface.triangles.empty());
}

BURIN_TEST(SegmentSurfaceTest)

} // namespace segmentSurfaceTest

#include "SegmentSurfaceTest.moc"
