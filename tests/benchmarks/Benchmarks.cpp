// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"
#include "gpu/engine/GpuEngine.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/Profile.h"
#include "tests/benchmarks/itk/GrowBenchmark.h"
#include "tests/benchmarks/itk/LoadBenchmark.h"
#include "tests/benchmarks/itk/RefineBenchmark.h"
#include "tests/benchmarks/itk/SegmentBenchmark.h"
#include "tests/benchmarks/itk/ShapeBenchmark.h"
#include "tests/benchmarks/own/DecodeBenchmark.h"
#include "tests/benchmarks/own/HistoryBenchmark.h"
#include "tests/benchmarks/own/MemoryBenchmark.h"
#include "tests/benchmarks/own/MovingBenchmark.h"
#include "tests/benchmarks/own/ReactionBenchmark.h"
#include "tests/benchmarks/own/SculptBenchmark.h"
#include "tests/benchmarks/own/SteeringBenchmark.h"
#include "tests/benchmarks/vtk/FrameBenchmark.h"
#include "tests/benchmarks/vtk/PlaneBenchmark.h"
#include "ui/base/ErrorText.h"

#include <QCoreApplication>

#include <array>
#include <cstdio>
#include <vector>

namespace {

/// frame.*, and growing on the demonstration head.
QString measurePeers(bench::PeerReport& report)
{
    const auto study = core::makeDemoStudy({});
    const auto engine = gpu::GpuEngine::create();
    if (!study || !engine)
        return ui::errorText(study ? engine.error() : study.error());
    std::fprintf(stderr, "on %s\n", qPrintable((*engine)->rendererName()));
    for (const auto& prepare : {bench::registerGrowth, bench::registerFrames}) {
        if (const QString why = prepare(**engine, *study); !why.isEmpty())
            return why;
    }
    benchmark::RunSpecifiedBenchmarks(&report);
    benchmark::ClearRegisteredBenchmarks();
    return {};
}

/// What can be asked for by itself; without any, all.
struct Group {
    const char* option;
    std::vector<QString (*)(bench::PeerReport&)> measure;
    bool isProfiled = false; ///< it notes when its times are taken (common/RowTimes.h)
};

const std::vector<Group>& groups()
{
    // Memory first: what others have freed would hide what is taken.
    static const std::vector<Group> all{{"--memory", {bench::measureMemory}},
        {"--frames", {measurePeers}, true}, {"--moving", {bench::measureMoving}},
        {"--reactions", {bench::measureReactions, bench::measureShapes}, true},
        {"--grow", {bench::measureGrowth, bench::measureSteering}, true},
        {"--load", {bench::measureLoading}, true}, {"--decode", {bench::measureDecoding}},
        {"--segments", {bench::measureSegments}}, {"--sculpt", {bench::measureSculpting}, true},
        {"--history", {bench::measureHistory}}, {"--plane", {bench::measurePlanes}, true},
        {"--refine", {bench::measureRefining}, true}};
    return all;
}

} // namespace

/// Burin against its peers, in one process and one run. Nothing is timed before the results were
/// found equal. Where they are not, the others are measured nevertheless, and the program fails.
int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    QStringList arguments = QCoreApplication::arguments().mid(1);
    const bool json = arguments.removeAll(QStringLiteral("--json")) > 0;
    QString profileFile;
    if (const qsizetype option = arguments.indexOf(QStringLiteral("--profile"));
        option >= 0 && option + 1 < arguments.size()) {
        profileFile = arguments.takeAt(option + 1);
        arguments.removeAt(option);
    }
    const bool profiles = !profileFile.isEmpty();
    std::vector<Group> wanted;
    QString usage = QStringLiteral("usage: burin_bench [--json] [--profile FILE]");
    for (const Group& group : groups()) {
        usage += QStringLiteral(" [%1]").arg(QLatin1String(group.option));
        if (arguments.removeAll(QLatin1String(group.option)) > 0)
            wanted.push_back(group);
    }
    if (!arguments.isEmpty()) {
        std::fprintf(stderr, "%s\n", qPrintable(usage));
        return 2;
    }
    std::array<char, 12> program{"burin_bench"};
    std::array<char, 32> repetitions{"--benchmark_repetitions=5"};
    // Stamps cost time, so that the figures of a profile are none.
    if (profiles)
        repetitions = {"--benchmark_repetitions=2"};
    std::array<char, 48> interleaved{"--benchmark_enable_random_interleaving=true"};
    std::array<char*, 3> options{program.data(), repetitions.data(), interleaved.data()};
    int count = int(options.size());
    benchmark::Initialize(&count, options.data());

    bench::PeerReport report;
    bool isRight = true;
    bench::Profile profile;
    for (const Group& group : wanted.empty() ? groups() : wanted) {
        if (profiles && !group.isProfiled)
            continue;
        if (profiles)
            profile.begin();
        for (const auto measure : group.measure) {
            const QString why = measure(report);
            if (why.isEmpty())
                continue;
            std::fprintf(
                stderr, "no times, since the results are not right: %s\n", qPrintable(why));
            isRight = false;
            // What was registered uses what is gone.
            benchmark::ClearRegisteredBenchmarks();
        }
        if (profiles)
            profile.end();
    }
    if (profiles && !profile.write(profileFile)) {
        std::fprintf(stderr, "%s cannot be written\n", qPrintable(profileFile));
        return 1;
    }
    if (profiles)
        return isRight ? 0 : 1;
    if (json)
        report.printJson();
    else
        report.printTable();
    return isRight ? 0 : 1;
}
