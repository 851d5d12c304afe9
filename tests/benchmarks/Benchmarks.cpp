// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"
#include "gpu/GpuEngine.h"
#include "tests/benchmarks/FrameBenchmark.h"
#include "tests/benchmarks/GrowBenchmark.h"
#include "tests/benchmarks/PeerReport.h"
#include "ui/ErrorText.h"

#include <QCoreApplication>

#include <array>
#include <cstdio>

/// Burin against its peers on the demonstration head, in one process and one run. Nothing is timed
/// before the results were found equal.
int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments().mid(1);
    const bool json = arguments == QStringList{QStringLiteral("--json")};
    if (!json && !arguments.isEmpty()) {
        std::fprintf(stderr, "usage: burin_bench [--json]\n");
        return 2;
    }

    const auto study = core::makeDemoStudy({});
    const auto engine = gpu::GpuEngine::create();
    if (!study || !engine) {
        std::fprintf(
            stderr, "%s\n", qPrintable(ui::errorText(study ? engine.error() : study.error())));
        return 1;
    }
    std::fprintf(stderr, "on %s\n", qPrintable((*engine)->rendererName()));
    for (const auto& prepare : {bench::registerGrowth, bench::registerFrames}) {
        const QString why = prepare(**engine, *study);
        if (!why.isEmpty()) {
            std::fprintf(
                stderr, "no times, since the results are not equal: %s\n", qPrintable(why));
            return 1;
        }
    }

    std::array<char, 12> program{"burin_bench"};
    std::array<char, 32> repetitions{"--benchmark_repetitions=5"};
    std::array<char, 48> interleaved{"--benchmark_enable_random_interleaving=true"};
    std::array<char*, 3> options{program.data(), repetitions.data(), interleaved.data()};
    int count = int(options.size());
    benchmark::Initialize(&count, options.data());
    bench::PeerReport report;
    benchmark::RunSpecifiedBenchmarks(&report);
    if (json)
        report.printJson();
    else
        report.printTable();
    return 0;
}
