// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/DecodeBenchmark.h"

#include "core/base/ParallelFor.h"
#include "core/dicom/codecs/FrameCodec.h"
#include "core/dicom/codecs/FrameDecoder.h"
#include "core/dicom/header/ImageHeaderReader.h"
#include "core/fence/FencedDecoder.h"
#include "core/study/StudyLoader.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <vector>

namespace bench {

namespace {

constexpr int sliceCount = 320;
constexpr int side = 512;
constexpr int turns = 5;

/// Soft shapes under the noise of a scanner: as large when packed as a CT is.
int scannedValue(const glm::ivec3& at)
{
    std::uint32_t noise = std::uint32_t(at.x) * 73856093u ^ std::uint32_t(at.y) * 19349663u
        ^ std::uint32_t(at.z) * 83492791u;
    noise ^= noise >> 13;
    noise *= 0x5bd1e995u;
    const int x = at.x - side / 2;
    const int y = at.y - side / 2;
    const bool inside = x * x + y * y < side * side / 5;
    const int shape = inside ? 1000 + (x * y / 300 + at.z) % 200 : 24;
    return shape + int((noise >> 20) % (inside ? 48 : 6));
}

double milliseconds(const std::function<void()>& work)
{
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    return took.count();
}

double median(std::array<double, turns> times)
{
    std::nth_element(times.begin(), times.begin() + turns / 2, times.end());
    return times[turns / 2];
}

struct Times {
    std::array<double, turns> frames{};
    std::array<double, turns> open{};
};

} // namespace

QString measureDecoding(PeerReport& report)
{
    const QTemporaryDir folder;
    test::SyntheticSeries series;
    series.size = {side, side, sliceCount};
    series.step = {0.0, 0.0, 1.0};
    series.stored = scannedValue;
    series.transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.4.70");
    std::fprintf(stderr, "writing %d slices in JPEG lossless\n", sliceCount);
    const QStringList files = test::writeSeries(series, folder.path());
    std::vector<core::ImageHeader> headers;
    for (const QString& file : files) {
        const auto header = core::readImageHeader(file);
        if (!header)
            return QStringLiteral("a slice cannot be read");
        headers.push_back(*header);
    }
    const auto frames = [&] {
        std::atomic<int> failed = 0;
        core::parallelFor(sliceCount, [&](int k) {
            std::vector<std::uint16_t> stored(std::size_t(side) * side);
            failed += core::decodeFrame(headers[std::size_t(k)], stored) ? 0 : 1;
        });
        return failed == 0;
    };
    core::FencedDecoder& decoder = core::FencedDecoder::instance();
    const core::WorkerProgram fenced{
        .path = QStringLiteral(BURIN_PROGRAM), .arguments = {QStringLiteral("--decode-worker")}};
    Times outside;
    Times inside;
    std::array<QByteArray, 2> hashes;
    bool good = true;
    // The first turn warms up.
    for (int turn = -1; turn < turns; ++turn) {
        for (const bool isFenced : {true, false}) {
            if (isFenced)
                decoder.setProgram(fenced);
            else
                decoder.decodeInside(core::decodeHere);
            Times& times = isFenced ? outside : inside;
            const auto slot = std::size_t(std::max(turn, 0));
            good = frames() && good; // starts the decoders
            times.frames[slot] = milliseconds([&] { good = frames() && good; });
            times.open[slot] = milliseconds([&] {
                const auto loaded = core::loadVolume(folder.path());
                good = good && loaded && loaded->volume.sources.size() == sliceCount;
                if (loaded)
                    hashes[isFenced ? 0 : 1] = loaded->volume.voxelsSha256;
            });
        }
        std::fprintf(stderr, "turn %d of %d\n", turn + 1, turns);
    }
    if (!good || hashes[0] != hashes[1])
        return QStringLiteral("decoders give other voxels than decoding in the program");
    const auto add = [&](const char* id, const std::array<double, turns>& ours,
                         const std::array<double, turns>& theirs) {
        report.add({.id = id,
            .unit = "Ms",
            .ours = median(ours),
            .peer = "in the program itself",
            .theirs = median(theirs)});
    };
    add("decode.jpegll.frames", outside.frames, inside.frames);
    add("decode.jpegll.open", outside.open, inside.open);
    return {};
}

} // namespace bench
