// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/GrowBenchmark.h"

#include "tests/benchmarks/PeerReport.h"
#include "tests/peers/ItkConnectedThreshold.h"
#include "tests/support/GrowToClosure.h"

#include <algorithm>
#include <array>
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
    [[nodiscard]] peer::ItkGrown theirs() const
    {
        return peer::itkConnectedThreshold<std::int16_t>(
            study.geometry.size, study.hounsfield, seed, lower, upper);
    }
};

} // namespace

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

    benchmark::RegisterBenchmark("grow.closure/burin",
        [task](benchmark::State& state) {
            for (auto _ : state)
                state.SetIterationTime(task->ours().milliseconds / 1000.0);
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
