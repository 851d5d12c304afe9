// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"
#include "gpu/GpuEngine.h"
#include "tests/benchmarks/FrameBenchmark.h"
#include "tests/benchmarks/GrowBenchmark.h"
#include "tests/benchmarks/HistoryBenchmark.h"
#include "tests/benchmarks/LoadBenchmark.h"
#include "tests/benchmarks/PeerReport.h"
#include "tests/benchmarks/SculptBenchmark.h"
#include "tests/benchmarks/SteeringBenchmark.h"
#include "ui/ErrorText.h"

#include <QCoreApplication>

#include <array>
#include <cstdio>

namespace {

/// grow.*, frame.*: on the demonstration head.
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

} // namespace

/// Burin against its peers, in one process and one run. Nothing is timed before the results were
/// found equal.
int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    QStringList arguments = QCoreApplication::arguments().mid(1);
    const bool json = arguments.removeAll(QStringLiteral("--json")) > 0;
    const bool historyOnly = arguments.removeAll(QStringLiteral("--history")) > 0;
    const bool loadOnly = arguments.removeAll(QStringLiteral("--load")) > 0;
    const bool sculptOnly = arguments.removeAll(QStringLiteral("--sculpt")) > 0;
    const bool growOnly = arguments.removeAll(QStringLiteral("--grow")) > 0;
    if (!arguments.isEmpty()) {
        std::fprintf(
            stderr, "usage: burin_bench [--json] [--grow] [--history] [--load] [--sculpt]\n");
        return 2;
    }
    std::array<char, 12> program{"burin_bench"};
    std::array<char, 32> repetitions{"--benchmark_repetitions=5"};
    std::array<char, 48> interleaved{"--benchmark_enable_random_interleaving=true"};
    std::array<char*, 3> options{program.data(), repetitions.data(), interleaved.data()};
    int count = int(options.size());
    benchmark::Initialize(&count, options.data());

    bench::PeerReport report;
    QString why;
    const bool all = !historyOnly && !sculptOnly && !growOnly && !loadOnly;
    if (all)
        why = measurePeers(report);
    if (why.isEmpty() && (all || growOnly))
        why = bench::measureGrowth(report);
    if (why.isEmpty() && (all || growOnly))
        why = bench::measureSteering(report);
    if (why.isEmpty() && (all || loadOnly))
        why = bench::measureLoading(report);
    if (why.isEmpty() && (all || sculptOnly))
        why = bench::measureSculpting(report);
    if (why.isEmpty() && (all || historyOnly))
        why = bench::measureHistory(report);
    if (!why.isEmpty()) {
        std::fprintf(stderr, "no times, since the results are not right: %s\n", qPrintable(why));
        return 1;
    }
    if (json)
        report.printJson();
    else
        report.printTable();
    return 0;
}
