// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/itk/GrowBenchmark.h"

#include "core/study/StudyLoader.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/RowTimes.h"
#include "tests/peers/ItkConnectedThreshold.h"
#include "tests/support/cases/growth/GrowToClosure.h"
#include "tests/support/scenes/SharedData.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

namespace bench {

namespace {

constexpr int codeOfZero = 1024;
constexpr std::int16_t lower = -20;
constexpr std::int16_t upper = 120;

struct Task {
    gpu::GpuEngine& engine;
    const core::DemoStudy& study;
    std::vector<std::uint16_t> codes;
    std::array<glm::ivec3, 1> seed{glm::ivec3(110, 128, 120)}; // white matter

    [[nodiscard]] test::GrownVoxels ours() const
    {
        if (!engine.edits().openVolume(study.geometry.size, codes))
            return {};
        return test::growToClosure(
            engine.edits(), study.geometry.size, seed, lower + codeOfZero, upper + codeOfZero);
    }
    /// The same, for the profile.
    [[nodiscard]] test::GrownVoxels noted() const
    {
        if (!engine.edits().openVolume(study.geometry.size, codes))
            return {};
        const RowTimes::Clock::time_point begin = RowTimes::Clock::now();
        test::GrownVoxels grown = test::growToClosure(
            engine.edits(), study.geometry.size, seed, lower + codeOfZero, upper + codeOfZero);
        RowTimes::took("grow.closure", begin, grown.milliseconds);
        return grown;
    }
    [[nodiscard]] peer::ItkGrown theirs() const
    {
        return peer::itkConnectedThreshold<std::int16_t>(
            study.geometry.size, study.hounsfield, seed, lower, upper);
    }
};

/// A queue and a look at the neighbours of each come on top of it.
void noteMoved(const std::string& id, std::ptrdiff_t voxels)
{
    RowTimes::moves(id, 7.0 * double(voxels),
        "of each voxel that is taken, its value read, its label and its seed word written");
}

// --- Shapes --------------------------------------------------------------------------------------

constexpr int shapeSide = 512;
constexpr std::int16_t inShape = 1000;

struct Shape {
    const char* id;
    std::function<bool(int, int, int)> holds; ///< around the middle
};

/// As in ALGORITHMS 1.6.9: 10, 27 and 60 million voxels.
const std::array<Shape, 3>& shapes()
{
    static const std::array<Shape, 3> all{
        Shape{"grow.ball", [](int x, int y, int z) { return x * x + y * y + z * z < 134 * 134; }},
        Shape{"grow.cube",
            [](int x, int y, int z) {
                return std::max({std::abs(x), std::abs(y), std::abs(z)}) < 150;
            }},
        Shape{"grow.cylinder",
            [](int x, int y, int z) { return x * x + y * y < 200 * 200 && std::abs(z) < 240; }}};
    return all;
}

std::vector<std::uint16_t> codesOf(const Shape& shape)
{
    std::vector<std::uint16_t> codes(std::size_t(shapeSide) * shapeSide * shapeSide);
    std::size_t i = 0;
    for (int z = 0; z < shapeSide; ++z) {
        for (int y = 0; y < shapeSide; ++y) {
            for (int x = 0; x < shapeSide; ++x)
                codes[i++] = shape.holds(x - shapeSide / 2, y - shapeSide / 2, z - shapeSide / 2)
                    ? inShape
                    : 0;
        }
    }
    return codes;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// What is grown: from seeds, in a volume, all codes of an interval.
struct Flood {
    std::string id;
    glm::ivec3 size{0};
    std::vector<std::uint16_t> codes;
    std::vector<glm::ivec3> seeds;
    int low = 0;
    int high = 0;
};

/// Every voxel with its generation, against ITK's filter without; until the last voxel is in the
/// textures, and until the step stands in the history too.
QString measureFlood(PeerReport& report, gpu::GpuEngine& engine, const Flood& flood)
{
    constexpr int rounds = 3;
    const auto id = QString::fromStdString(flood.id);
    // 16 bits, as ITK is fastest, in the same order.
    const auto valueOf = [](int code) { return std::int16_t(code - 32768); };
    std::vector<std::int16_t> values(flood.codes.size());
    std::transform(flood.codes.begin(), flood.codes.end(), values.begin(), valueOf);
    std::vector<double> shown;
    std::vector<double> kept;
    std::vector<double> theirs;
    for (int round = 0; round < rounds; ++round) {
        if (!engine.edits().openVolume(flood.size, flood.codes))
            return QStringLiteral("%1: no room").arg(id);
        const RowTimes::Clock::time_point begin = RowTimes::Clock::now();
        const test::GrownVoxels ours =
            test::growToClosure(engine.edits(), flood.size, flood.seeds, flood.low, flood.high);
        if (round > 0) // the first one compiles
            RowTimes::took(flood.id, begin, ours.closureMilliseconds);
        const peer::ItkGrown itk = peer::itkConnectedThreshold<std::int16_t>(
            flood.size, values, flood.seeds, valueOf(flood.low), valueOf(flood.high));
        const auto members = std::count(itk.mask.begin(), itk.mask.end(), std::uint8_t{1});
        if (ours.mask != itk.mask || members < 100'000)
            return QStringLiteral("%1: not what ITK grows").arg(id);
        shown.push_back(ours.closureMilliseconds);
        kept.push_back(ours.milliseconds);
        theirs.push_back(itk.milliseconds);
        noteMoved(flood.id, members);
        if (round == 0)
            std::fprintf(stderr, "%s: equal, %lld voxels in %u generations\n", flood.id.c_str(),
                static_cast<long long>(members), ours.generation);
    }
    report.add({flood.id, "Ms", median(shown), "ITK ConnectedThreshold", median(theirs)});
    report.add({flood.id + ".kept", "Ms", median(kept), "ITK ConnectedThreshold", median(theirs)});
    return {};
}

QString measureShape(PeerReport& report, gpu::GpuEngine& engine, const Shape& shape)
{
    const glm::ivec3 size(shapeSide);
    return measureFlood(
        report, engine, {shape.id, size, codesOf(shape), {size / 2}, inShape, inShape});
}

// --- Real series ---------------------------------------------------------------------------------

struct Series {
    const char* id;
    const char* folder; ///< of the shared data
    double lower; ///< modality units
    double upper;
};

constexpr std::array<Series, 3> series{Series{"grow.skull", "ct_cranium_inv3", 226.0, 3071.0},
    Series{"grow.abdomen", "ct_abdomen_j2k_organs", -29.5, 150.5},
    Series{"grow.brain", "mr_t1_sag_mprage", 90.0, 400.0}};

/// Nothing is added where the shared data are not.
QString measureSeries(PeerReport& report, gpu::GpuEngine& engine, const Series& real)
{
    const test::SharedCase data = test::sharedCase(QString::fromLatin1(real.folder));
    if (data.source.isEmpty()) {
        std::fprintf(stderr, "%s: left out, the shared data are not there\n", real.id);
        return {};
    }
    const auto loaded = core::loadVolume(
        data.unpacked.isEmpty() ? data.source + QStringLiteral("/dicom") : data.unpacked);
    if (!loaded)
        return QStringLiteral("%1: does not open").arg(QLatin1String(real.id));
    const core::VoxelEncoding& encoding = loaded->volume.encoding;
    Flood flood{.id = real.id,
        .size = loaded->volume.geometry.size,
        .codes = loaded->codes,
        .seeds = {},
        .low = encoding.lowestCodeAtLeast(real.lower),
        .high = encoding.highestCodeAtMost(real.upper)};
    flood.seeds = test::seedsOnDiagonal(flood.size, flood.codes, flood.low, flood.high);
    return measureFlood(report, engine, flood);
}

} // namespace

QString measureGrowth(PeerReport& report)
{
    const auto engine = gpu::GpuEngine::create();
    if (!engine)
        return QStringLiteral("grow: no engine");
    for (const Shape& shape : shapes()) {
        if (const QString why = measureShape(report, **engine, shape); !why.isEmpty())
            return why;
    }
    for (const Series& real : series) {
        if (const QString why = measureSeries(report, **engine, real); !why.isEmpty())
            return why;
    }
    return {};
}

std::vector<std::uint16_t> demoCodes(const core::DemoStudy& study)
{
    std::vector<std::uint16_t> codes(study.hounsfield.size());
    std::transform(study.hounsfield.begin(), study.hounsfield.end(), codes.begin(),
        [](int value) { return static_cast<std::uint16_t>(value + codeOfZero); });
    return codes;
}

QString registerGrowth(gpu::GpuEngine& engine, const core::DemoStudy& study)
{
    const auto task = std::make_shared<Task>(Task{engine, study, demoCodes(study)});
    const test::GrownVoxels ours = task->ours();
    const peer::ItkGrown theirs = task->theirs();
    const auto members = std::count(theirs.mask.begin(), theirs.mask.end(), std::uint8_t{1});
    if (ours.mask != theirs.mask || members < 1'000'000)
        return QStringLiteral("grow.closure: Burin grew %1 voxels, ITK %2")
            .arg(std::count(ours.mask.begin(), ours.mask.end(), std::uint8_t{1}))
            .arg(members);
    std::fprintf(stderr, "grow.closure: equal, %lld voxels in %u generations\n",
        static_cast<long long>(members), ours.generation);
    noteMoved("grow.closure", members);

    benchmark::RegisterBenchmark("grow.closure/burin",
        [task](benchmark::State& state) {
            for (auto _ : state)
                state.SetIterationTime(task->noted().milliseconds / 1000.0);
        })
        ->UseManualTime()
        ->Iterations(1);
    benchmark::RegisterBenchmark("grow.closure/ITK ConnectedThreshold",
        [task](benchmark::State& state) {
            for (auto _ : state)
                state.SetIterationTime(task->theirs().milliseconds / 1000.0);
        })
        ->UseManualTime()
        ->Iterations(1);
    return {};
}

} // namespace bench
