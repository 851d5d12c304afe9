// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/itk/SegmentBenchmark.h"

#include "gpu/engine/GpuEngine.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/peers/cases/ComparedSegments.h"
#include "tests/peers/cases/SegmentReadings.h"
#include "tests/peers/cases/WholeSegments.h"
#include "ui/base/ErrorText.h"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace bench {

namespace {

double middle(std::vector<double> times)
{
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

void tell(const QString& id, const peer::WholeSegment& operation, const peer::Compared& compared)
{
    std::fprintf(stderr, "%s: %lld voxels compared, %lld changed, %lld differ from %s%s%s\n",
        qPrintable(id), static_cast<long long>(compared.voxels),
        static_cast<long long>(compared.changed), static_cast<long long>(compared.differing),
        operation.peer, compared.differing > 0 ? ": " : "",
        compared.differing > 0 ? operation.whyEither : "");
}

QString measureOperation(PeerReport& report, const QString& id, peer::RealSegment& segment,
    const peer::WholeSegment& operation)
{
    constexpr std::size_t rounds = 3;
    constexpr double patienceMs = 3000.0; // one that takes longer is measured once
    std::vector<double> workedOut;
    std::vector<double> kept;
    std::vector<double> theirs;
    for (double spent = 0.0; theirs.size() < rounds && spent < patienceMs;) {
        const core::Result<peer::Compared> compared = peer::compare(segment, operation);
        if (!compared)
            return QStringLiteral("%1: %2").arg(id, ui::errorText(compared.error()));
        if (compared->unexplained > 0 || compared->changed == 0)
            return QStringLiteral("%1: not what ITK finds").arg(id);
        if (theirs.empty())
            tell(id, operation, *compared);
        if (compared->workedOutMilliseconds)
            workedOut.push_back(*compared->workedOutMilliseconds);
        kept.push_back(compared->stepMilliseconds);
        theirs.push_back(compared->theirMilliseconds);
        spent += compared->stepMilliseconds + compared->theirMilliseconds;
    }
    const std::string name = id.toStdString();
    if (!workedOut.empty())
        report.add({name, "Ms", middle(workedOut), operation.peer, middle(theirs)});
    report.add({name + ".kept", "Ms", middle(kept), operation.peer, middle(theirs)});
    return {};
}

constexpr std::size_t readingRounds = 3;

QString measureMaskedVolume(PeerReport& report, const QString& id, peer::RealSegment& segment)
{
    std::vector<double> step;
    std::vector<double> exported;
    std::vector<double> theirs;
    while (theirs.size() < readingRounds) {
        const core::Result<peer::ComparedVolume> compared = peer::compareMaskedVolume(segment);
        if (!compared)
            return QStringLiteral("%1: %2").arg(id, ui::errorText(compared.error()));
        if (compared->differing > 0 || compared->masked == 0)
            return QStringLiteral("%1: not what ITK finds").arg(id);
        step.push_back(compared->stepMilliseconds);
        exported.push_back(compared->exportMilliseconds);
        theirs.push_back(compared->theirMilliseconds);
    }
    const std::string name = id.toStdString();
    report.add({name + ".kept", "Ms", middle(step), peer::ComparedVolume::peer, middle(theirs)});
    report.add({name + ".export", "Ms", middle(exported)});
    return {};
}

QString measureDistances(PeerReport& report, const QString& id, const peer::RealSegment& segment)
{
    std::vector<double> ours;
    std::vector<double> theirs;
    while (theirs.size() < readingRounds) {
        const core::Result<peer::ComparedDistances> compared = peer::compareDistances(segment);
        if (!compared)
            return QStringLiteral("%1: %2").arg(id, ui::errorText(compared.error()));
        if (compared->differing > 0 || compared->pairs == 0)
            return QStringLiteral("%1: not what ITK finds").arg(id);
        ours.push_back(compared->ourMilliseconds);
        theirs.push_back(compared->theirMilliseconds);
    }
    report.add(
        {id.toStdString(), "Ms", middle(ours), peer::ComparedDistances::peer, middle(theirs)});
    return {};
}

} // namespace

QString measureSegments(PeerReport& report)
{
    const auto engine = gpu::GpuEngine::create();
    if (!engine)
        return QStringLiteral("segment: no engine");
    for (const peer::RealSeries& series : peer::realSeries()) {
        const auto segment = peer::RealSegment::open((*engine)->edits(), series, 0);
        if (!segment)
            return QStringLiteral("segment.%1: %2")
                .arg(QLatin1String(series.name), ui::errorText(segment.error()));
        if (!*segment) {
            std::fprintf(
                stderr, "segment.%s: left out, the shared data are not there\n", series.name);
            continue;
        }
        for (const peer::WholeSegment& operation : peer::wholeSegments()) {
            const QString id = QStringLiteral("segment.%1.%2")
                                   .arg(QLatin1String(series.name), QLatin1String(operation.name));
            if (const QString why = measureOperation(report, id, **segment, operation);
                !why.isEmpty())
                return why;
        }
        const QString prefix = QStringLiteral("segment.%1.").arg(QLatin1String(series.name));
        if (const QString why =
                measureMaskedVolume(report, prefix + QStringLiteral("mask.volume"), **segment);
            !why.isEmpty())
            return why;
        if (const QString why =
                measureDistances(report, prefix + QStringLiteral("distance"), **segment);
            !why.isEmpty())
            return why;
    }
    return {};
}

} // namespace bench
