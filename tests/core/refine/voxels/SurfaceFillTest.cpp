// SPDX-License-Identifier: Apache-2.0
#include "core/refine/voxels/SurfaceFill.h"
#include "core/masks/MaskOnVolume.h"
#include "core/surface/SegmentSurface.h"
#include "tests/support/program/TestProgram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <random>

namespace surfaceFillTest {

namespace {

using core::LatticeSurface;
using core::SurfaceKind;

constexpr int one = 1 << LatticeSurface::bits;
using Filled = std::vector<int>; ///< how often each voxel was filled

Filled filled(const LatticeSurface& surface, const glm::ivec3& size)
{
    Filled voxels(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0);
    const auto runs = core::fillSurface(surface, core::kindOf(surface), size, {});
    if (!runs)
        qFatal("not filled");
    for (const core::VoxelRun& run : runs->runs()) {
        for (std::uint64_t i = 0; i < run.count; ++i)
            ++voxels[std::size_t(run.first + i)];
    }
    return voxels;
}

/// The faces of a tetrahedron, outwards if @p corners are right-handed.
LatticeSurface tetrahedron(const std::array<glm::ivec3, 4>& corners)
{
    return {.vertices = {corners.begin(), corners.end()},
        .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

void append(LatticeSurface& surface, const LatticeSurface& more, bool inwards = false)
{
    const auto first = std::uint32_t(surface.vertices.size());
    surface.vertices.insert(surface.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (glm::uvec3 triangle : more.triangles) {
        if (inwards)
            std::swap(triangle.y, triangle.z);
        surface.triangles.push_back(triangle + first);
    }
}

LatticeSurface box(const glm::ivec3& low, const glm::ivec3& high)
{
    LatticeSurface surface;
    for (int i = 0; i < 8; ++i)
        surface.vertices.emplace_back(
            i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
        {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return surface;
}

int count(const Filled& voxels)
{
    return int(std::count(voxels.begin(), voxels.end(), 1));
}

} // namespace

class SurfaceFillTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Tetrahedra that tile a box, corners on and off centres: each centre is in exactly one.
    void neighboursShareNothingAndLeaveNothing()
    {
        std::mt19937 random(11);
        const glm::ivec3 size(9, 8, 7);
        // Around a corner in the middle, each half of each face of the box.
        const LatticeSurface outer = box(glm::ivec3(-one), size * one);
        for (int number = 0; number < 200; ++number) {
            glm::ivec3 middle;
            for (int axis = 0; axis < 3; ++axis) {
                const int place = int(random() % unsigned(size[axis] * one));
                middle[axis] = number % 2 ? place : place / one * one;
            }
            Filled sum(std::size_t(size.x * size.y * size.z), 0);
            for (const glm::uvec3& face : outer.triangles) {
                const LatticeSurface piece = tetrahedron({outer.vertices[face.x],
                    outer.vertices[face.y], outer.vertices[face.z], middle});
                const Filled voxels = filled(piece, size);
                for (std::size_t i = 0; i < sum.size(); ++i)
                    sum[i] += voxels[i];
            }
            QCOMPARE(sum, Filled(sum.size(), 1));
        }
    }

    /// Against the sides of its four planes, away from them.
    void tetrahedraByTheirPlanes()
    {
        std::mt19937 random(12);
        const glm::ivec3 size(12, 10, 11);
        int inside = 0;
        for (int number = 0; number < 300; ++number) {
            std::array<glm::ivec3, 4> corners;
            for (glm::ivec3& corner : corners) {
                for (int axis = 0; axis < 3; ++axis)
                    corner[axis] = int(random() % unsigned(16 * one)) - 3 * one;
            }
            const Filled voxels = filled(tetrahedron(corners), size);
            for (std::size_t i = 0; i < voxels.size(); ++i) {
                const glm::dvec3 at =
                    double(one) * glm::dvec3(double(i % 12), double(i / 12 % 10), double(i / 120));
                double least = 1e30;
                for (int face = 0; face < 4; ++face) {
                    const glm::dvec3 a(corners[std::size_t((face + 1) % 4)]);
                    const glm::dvec3 b(corners[std::size_t((face + 2) % 4)]);
                    const glm::dvec3 c(corners[std::size_t((face + 3) % 4)]);
                    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
                    const double own = glm::dot(normal, glm::dvec3(corners[std::size_t(face)]) - a);
                    least = std::min(least, glm::dot(normal, at - a) * (own < 0.0 ? -1.0 : 1.0));
                }
                if (std::abs(least) > 0.01)
                    QCOMPARE(voxels[i] == 1, least > 0.0);
                inside += voxels[i];
            }
        }
        QVERIFY(inside > 1000);
    }

    void bordersGoToTheGreaterSide()
    {
        const Filled voxels = filled(box(glm::ivec3(one), glm::ivec3(4 * one)), glm::ivec3(6));
        QCOMPARE(count(voxels), 27);
        QCOMPARE(voxels[std::size_t((1 * 6 + 1) * 6 + 1)], 1); // on the lower corner
        QCOMPARE(voxels[std::size_t((4 * 6 + 4) * 6 + 4)], 0); // on the upper one
    }

    void hollowsAndOverlaps()
    {
        const glm::ivec3 size(12);
        const int half = one / 2;
        LatticeSurface surface = box(glm::ivec3(half), glm::ivec3(10 * one + half));
        append(surface, box(glm::ivec3(3 * one + half), glm::ivec3(6 * one + half)), true);
        QCOMPARE(core::kindOf(surface), SurfaceKind::Closed);
        QCOMPARE(count(filled(surface, size)), 1000 - 27);
        // Two bodies that overlap are one.
        LatticeSurface both = box(glm::ivec3(half), glm::ivec3(4 * one + half));
        append(both, box(glm::ivec3(2 * one + half), glm::ivec3(6 * one + half)));
        QCOMPARE(count(filled(both, size)), 64 + 64 - 8);
        // Turned inside out it holds the same.
        LatticeSurface inwards;
        append(inwards, both, true);
        QCOMPARE(filled(inwards, size), filled(both, size));
    }

    void kinds()
    {
        LatticeSurface surface = box(glm::ivec3(-one / 2), glm::ivec3(3 * one + one / 2));
        QCOMPARE(core::kindOf(surface), SurfaceKind::Closed);
        std::swap(surface.triangles[4].y, surface.triangles[4].z);
        QCOMPARE(core::kindOf(surface), SurfaceKind::TwoFaced);
        QCOMPARE(count(filled(surface, glm::ivec3(5))), 64);
        surface.triangles.pop_back();
        QCOMPARE(core::kindOf(surface), SurfaceKind::Open);
        // Corners that stand there several times, as in STL files, are the same places.
        LatticeSurface soup;
        for (const glm::uvec3& triangle : box(glm::ivec3(0), glm::ivec3(one)).triangles) {
            const LatticeSurface whole = box(glm::ivec3(0), glm::ivec3(one));
            const auto first = std::uint32_t(soup.vertices.size());
            for (int i = 0; i < 3; ++i)
                soup.vertices.push_back(whole.vertices[triangle[i]]);
            soup.triangles.emplace_back(first, first + 1, first + 2);
        }
        QCOMPARE(core::kindOf(soup), SurfaceKind::Closed);
    }

    /// The surfaces that Burin makes of voxels give these voxels again.
    void segmentsComeBack()
    {
        std::mt19937 random(13);
        for (int number = 0; number < 30; ++number) {
            const glm::ivec3 size{
                2 + int(random() % 9), 2 + int(random() % 9), int(1 + random() % 9)};
            Filled labels(std::size_t(size.x * size.y * size.z));
            for (int& label : labels)
                label = random() % 3 == 0;
            const std::vector<std::uint8_t> bytes(labels.begin(), labels.end());
            const core::SegmentSurface made = core::segmentSurface(bytes, 1, size);
            LatticeSurface surface{.vertices = {}, .triangles = made.triangles};
            for (const glm::vec3& vertex : made.vertices)
                surface.vertices.push_back(core::latticePoint(glm::dvec3(vertex)));
            QCOMPARE(core::kindOf(surface), SurfaceKind::Closed);
            QCOMPARE(filled(surface, size), labels);
        }
    }

    void farAndHugeTriangles()
    {
        const LatticeSurface far =
            box(core::latticePoint(glm::dvec3(-1e9)), core::latticePoint(glm::dvec3(1e9)));
        QCOMPARE(count(filled(far, glm::ivec3(7, 5, 3))), 105);
        QCOMPARE(count(filled(box(glm::ivec3(8 * one), glm::ivec3(9 * one)), glm::ivec3(5))), 0);
    }

    void filesThatAreNoMasks_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("reason");
        const QByteArray open("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 2 3\nf 1 2 4\nf 2 3 4\n");
        QTest::newRow("open") << open << QStringLiteral("closed");
        QTest::newRow("far away")
            << QByteArray(open + "f 1 3 4\n").replace(" 0 0 4", " 0 0 0").replace("v ", "v 90")
            << QStringLiteral("no voxel");
        QTest::newRow("no face") << QByteArray("v 0 0 0\n") << QStringLiteral("no face");
        QTest::newRow("points missing")
            << QByteArray("v 0 0 0\nf 1 2 3\n") << QStringLiteral("not there");
    }

    void filesThatAreNoMasks()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, reason);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("shape.obj"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        core::Volume volume;
        volume.geometry.size = {8, 8, 8};
        const auto mask = core::readMask(path, volume, {});
        QVERIFY(!mask);
        QCOMPARE(mask.error().arguments.value(0), path);
        QVERIFY2(mask.error().arguments.value(1).contains(reason),
            qPrintable(mask.error().arguments.value(1)));
    }

    void axesOfTheFile()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("shape.obj"));
        const QByteArray body("v 1.5 1.5 1.5\nv 6.5 1.5 1.5\nv 1.5 6.5 1.5\nv 1.5 1.5 6.5\n"
                              "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
        core::Volume volume;
        volume.geometry.size = {8, 8, 8};
        const auto read = [&](const QByteArray& head) {
            QFile file(path);
            if (!file.open(QIODevice::WriteOnly) || file.write(head + body) < 0)
                qFatal("not written");
            file.close();
            return core::readMask(path, volume, {});
        };
        const auto lps = read("# SPACE=LPS\n");
        QVERIFY(lps);
        QCOMPARE(lps->segments.front().name, QStringLiteral("shape"));
        using Code = core::MaskNote::Code;
        QCOMPARE(lps->notes.size(), std::size_t(1));
        QVERIFY(lps->notes[0].code == Code::Enclosed);
        QCOMPARE(lps->notes[0].names, QStringList{QStringLiteral("shape")});
        const auto unnamed = read({});
        QVERIFY(unnamed);
        QCOMPARE(unnamed->notes.size(), std::size_t(2));
        QVERIFY(unnamed->notes[0].code == Code::UnnamedAxes);
        QVERIFY(unnamed->segments.front().voxels == lps->segments.front().voxels);
        QVERIFY(!read("# SPACE=RAS\n"));
        // Half a turn about the head's axis.
        volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, -1, 0, 0),
            glm::dvec4(0, 0, 1, 0), glm::dvec4(0, 0, 0, 1));
        const auto ras = read("# SPACE=RAS\n");
        QVERIFY(ras);
        QVERIFY(ras->segments.front().voxels == lps->segments.front().voxels);
    }
};

BURIN_TEST(SurfaceFillTest)

} // namespace surfaceFillTest

#include "SurfaceFillTest.moc"
