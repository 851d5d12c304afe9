// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/itk/RefineBenchmark.h"

#include "core/chunks/ChunkMap.h"
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/deform/Deformation.h"
#include "core/refine/fit/InitialFit.h"
#include "core/refine/mesh/SurfaceUpdate.h"
#include "core/refine/tools/SurfaceStroke.h"
#include "gpu/gl/context/EglContext.h"
#include "gpu/render/parts/SurfaceBuffers.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/RowTimes.h"
#include "tests/peers/ItkSimplexDeformation.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

using namespace core;

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int rounds = 5;
constexpr int iterations = 40;
constexpr double farthestMm = 0.5; ///< from the body's boundary, in the mean
constexpr double reachVoxels = 6.0;

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double milliseconds(const std::function<void()>& work)
{
    const Clock::time_point start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A ring in voxels of 1 mm around the middle of its volume, and where its boundary is.
struct Ring {
    static constexpr double radius = 36.0;
    static constexpr double thickness = 15.0;
    static constexpr glm::dvec3 middle{56.0, 56.0, 24.0};

    test::ShapedMask made{{113, 113, 49}};
    std::vector<glm::vec3> gradients; ///< to the boundary

    Ring()
    {
        made.geometry.indexToWorld[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
        made.fill([](const glm::dvec3& at) { return offMm(at) < 0.0; });
        const glm::ivec3 size = made.geometry.size;
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 at(x, y, z);
                    glm::dvec3 rise(0.0);
                    for (int axis = 0; axis < 3; ++axis) {
                        glm::dvec3 step(0.0);
                        step[axis] = 0.5;
                        rise[axis] = offMm(at + step) - offMm(at - step);
                    }
                    gradients.emplace_back(-offMm(at) * rise);
                }
            }
        }
    }
    [[nodiscard]] static double offMm(const glm::dvec3& place)
    {
        const glm::dvec3 from = place - middle;
        const double around = std::sqrt(from.x * from.x + from.y * from.y) - radius;
        return std::sqrt(around * around + from.z * from.z) - thickness;
    }
    /// A surface within it that has 2 · around · across vertices.
    [[nodiscard]] static test::TriangleSurface start(int around, int across)
    {
        return test::moved(test::torus(radius, thickness - 3.0, around, across), middle);
    }
};

double meanOffMm(std::span<const glm::dvec3> places)
{
    double sum = 0.0;
    for (const glm::dvec3& place : places)
        sum += std::abs(Ring::offMm(place));
    return sum / double(places.size());
}

/// From the same surface as many steps of both, all vertices active, without changes of structure.
QString measureSteps(PeerReport& report, const Ring& ring, const char* id, int around, int across)
{
    const test::TriangleSurface start = Ring::start(around, across);
    const SimplexMesh begun = test::simplexMesh(start);
    const BoundaryForce boundary(ring.made.mask(), ring.made.geometry, reachVoxels);
    const std::array<const ExternalForce*, 1> forces{&boundary};
    std::vector<double> ours;
    std::vector<double> theirs;
    for (int round = 0; round < rounds; ++round) {
        SimplexMesh mesh = begun;
        SimplexMeshEdit edit(mesh);
        // None comes to rest, as none of ITK's does.
        Deformation deformation({.negligibleMm = 0.0});
        deformation.activateAll(mesh);
        ours.push_back(milliseconds([&] {
            for (int i = 0; i < iterations; ++i)
                deformation.step(edit, forces);
        }) / iterations);
        RowTimes::ended(id, iterations * ours.back());
        RowTimes::moves(id, 84.0 * iterations * double(mesh.vertexCount()),
            "in each of 40 steps, each vertex' place, the one before and its neighbours' names "
            "read, its place written");
        if (deformation.active().size() != mesh.vertexCount())
            return QStringLiteral("%1: vertices came to rest").arg(QLatin1String(id));
        edit.commit();
        const peer::ItkDeformed itk = peer::itkDeformed(start.points, start.triangles,
            ring.made.geometry.size, ring.gradients, {.iterations = iterations});
        theirs.push_back(itk.milliseconds / iterations);
        const double ourOff = meanOffMm(mesh.positions());
        const double theirOff = meanOffMm(itk.positions);
        if (round == 0)
            std::fprintf(stderr, "%s: %zu and %zu vertices, %.3f and %.3f mm off after %d steps\n",
                id, mesh.vertexCount(), itk.positions.size(), ourOff, theirOff, iterations);
        if (itk.positions.size() != mesh.vertexCount() || ourOff > farthestMm
            || theirOff > farthestMm)
            return QStringLiteral("%1: %2 and %3 mm off the boundary")
                .arg(QLatin1String(id))
                .arg(ourOff)
                .arg(theirOff);
    }
    report.add({id, "Ms", median(ours), "ITK DeformableSimplexMesh3D", median(theirs)});
    return {};
}

QString measureFit(PeerReport& report, const Ring& ring, const char* id, int vertices)
{
    std::vector<double> times;
    for (int round = 0; round < 3; ++round) {
        std::size_t made = 0;
        times.push_back(milliseconds([&] {
            const auto mesh =
                initialFit(ring.made.mask(), ring.made.geometry, {.vertices = vertices}, {});
            made = mesh ? mesh->vertexCount() : 0;
        }));
        if (double(made) < 0.7 * vertices || double(made) > 1.4 * vertices)
            return QStringLiteral("%1: %2 vertices").arg(QLatin1String(id)).arg(made);
    }
    report.add({id, "Ms", median(times)});
    return {};
}

/// Two balls in noise, one of them owned, in a cube of voxels.
struct Balls {
    explicit Balls(int side)
        : size(side)
    {
        test::Random random(5);
        const double scale = side / 80.0;
        for (int z = 0; z < side; ++z) {
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const glm::dvec3 at = glm::dvec3(x, y, z) / scale;
                    const bool one = glm::distance(at, glm::dvec3(30, 38, 40)) < 22.0;
                    const bool other = glm::distance(at, glm::dvec3(60, 42, 40)) < 14.0;
                    codes.push_back(std::uint16_t(
                        1000 + (one || other ? 200 : 0) + test::randomInt(random, -60, 60)));
                    owners.push_back(one ? 1 : 0);
                }
            }
        }
    }
    [[nodiscard]] ChunkSource source() const
    {
        return {.size = size, .codes = codes, .owners = owners};
    }

    glm::ivec3 size;
    std::vector<std::uint16_t> codes;
    std::vector<std::uint8_t> owners;
};

QString measureChunks(PeerReport& report)
{
    const Balls balls(80);
    std::vector<double> times;
    std::optional<ChunkMap> map;
    for (int round = 0; round < rounds; ++round) {
        times.push_back(milliseconds([&] {
            auto tree = ChunkTree::of(balls.source(), {});
            if (tree)
                map.emplace(balls.size, VoxelBox{.minimum = {0, 0, 0}, .maximum = balls.size},
                    *std::move(tree));
        }));
    }
    if (!map)
        return QStringLiteral("refine.chunks: no chunks");
    report.add({"refine.chunks", "Ms", median(times)});
    times.clear();
    std::uint64_t given = 0;
    for (int round = 0; round < rounds; ++round) {
        times.push_back(milliseconds([&] {
            given = map->toggled({{60, 42, 40}}, 40, balls.owners, 1).given.voxelCount();
        }));
    }
    if (given < 1000)
        return QStringLiteral("refine.chunks.click: %1 voxels").arg(given);
    std::fprintf(
        stderr, "refine.chunks.click: %llu voxels come\n", static_cast<unsigned long long>(given));
    report.add({"refine.chunks.click", "Ms", median(times)});
    return {};
}

/// All that the window waits for once the values of the box are there: 17 million voxels.
QString measureLargeChunks(PeerReport& report)
{
    const Balls balls(256);
    std::vector<double> times;
    for (int round = 0; round < 3; ++round) {
        std::size_t borders = 0;
        times.push_back(milliseconds([&] {
            const auto tree = ChunkTree::of(balls.source(), {});
            borders = tree ? ChunkSurvey::of(balls.source(), *tree).borders.size() : 0;
        }));
        RowTimes::ended("refine.chunks.large", times.back());
        if (borders == 0)
            return QStringLiteral("refine.chunks.large: no chunks");
    }
    report.add({"refine.chunks.large", "Ms", median(times)});
    return {};
}

/// A sphere that goes over a ring, dab by dab.
QString measureUploads(PeerReport& report)
{
    auto context = gpu::EglContext::create();
    if (!context || !(*context)->makeCurrent())
        return QStringLiteral("refine.upload: no GL context");
    for (const auto& [id, around, across] :
        {std::tuple("refine.upload.12k", 100, 60), std::tuple("refine.upload.100k", 250, 200)}) {
        SimplexMesh mesh = test::simplexMesh(Ring::start(around, across));
        gpu::SurfaceBuffers buffers;
        buffers.apply(wholeUpdate(mesh));
        buffers.upload();
        const std::int64_t whole = buffers.counters().bytes;
        SurfaceStroke stroke(mesh, nullptr, SphereTool{.radiusMm = 5.0}, {.reddens = true});
        std::vector<double> bytes;
        for (int dab = 0; dab < 20; ++dab) {
            const double turn = 0.03 * dab;
            const std::int64_t before = buffers.counters().bytes;
            stroke.add({.placeLps = Ring::middle
                    + (Ring::radius + 11.0) * glm::dvec3(std::cos(turn), std::sin(turn), 0.0)});
            buffers.apply(updateOf(mesh, stroke.takeWritten()));
            buffers.upload();
            bytes.push_back(double(buffers.counters().bytes - before));
        }
        stroke.rollback();
        if (median(bytes) <= 0.0 || median(bytes) > double(whole))
            return QStringLiteral("%1: %2 of %3 bytes")
                .arg(QLatin1String(id))
                .arg(median(bytes))
                .arg(whole);
        report.add({id, "Bytes", median(bytes), "all of it", double(whole)});
    }
    (*context)->doneCurrent();
    return {};
}

} // namespace

QString measureRefining(PeerReport& report)
{
    const Ring ring;
    if (const QString why = measureSteps(report, ring, "refine.step.12k", 100, 60); !why.isEmpty())
        return why;
    if (const QString why = measureSteps(report, ring, "refine.step.100k", 250, 200);
        !why.isEmpty())
        return why;
    if (const QString why = measureFit(report, ring, "refine.fit.12k", 12'000); !why.isEmpty())
        return why;
    if (const QString why = measureFit(report, ring, "refine.fit.100k", 100'000); !why.isEmpty())
        return why;
    if (const QString why = measureChunks(report); !why.isEmpty())
        return why;
    if (const QString why = measureLargeChunks(report); !why.isEmpty())
        return why;
    return measureUploads(report);
}

} // namespace bench
