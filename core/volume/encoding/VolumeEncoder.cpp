// SPDX-License-Identifier: Apache-2.0
#include "core/volume/encoding/VolumeEncoder.h"

#include "core/base/ParallelFor.h"
#include "core/base/Sha256.h"
#include "core/base/TaskThread.h"
#include "core/volume/encoding/CodeCounts.h"
#include "core/volume/encoding/StoredEncoder.h"
#include "core/volume/encoding/ValueHash.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <utility>

namespace core {

namespace {

/// Whether it is a number that was measured. Programs mark what they have no value for with NaN,
/// with infinity or with the largest number there is; on one scale with such a one all others
/// would be the same, and what is worked out from it is beyond float or even double.
bool isMeasured(double value)
{
    constexpr double most = 1e30;
    return std::abs(value) <= most;
}

std::size_t sliceSize(const Volume& volume)
{
    return std::size_t(volume.geometry.size.x) * std::size_t(volume.geometry.size.y);
}

} // namespace

void encodeStoredValues(LoadedVolume& loaded, std::span<const SliceRescale> slices, bool hasWindow)
{
    StoredEncoder encoder(loaded, {slices.begin(), slices.end()});
    parallelFor(int(slices.size()), [&](int k) { encoder.sliceIsThere(k); });
    encoder.finish(hasWindow);
}

void encodeValues(LoadedVolume& loaded,
    const std::function<void(int k, std::span<double> values)>& slice, bool hasWindow)
{
    Volume& volume = loaded.volume;
    const std::size_t size = sliceSize(volume);
    const int slices = volume.geometry.size.z;
    loaded.codes.resize(volume.geometry.voxelCount());

    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    bool whole = true;
    std::mutex mutex;
    parallelFor(slices, [&](int k) {
        std::vector<double> values(size);
        slice(k, values);
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        bool allWhole = true;
        for (const double value : values) {
            if (!isMeasured(value))
                continue;
            low = std::min(low, value);
            high = std::max(high, value);
            allWhole = allWhole && value == std::trunc(value);
        }
        const std::lock_guard lock(mutex);
        least = std::min(least, low);
        greatest = std::max(greatest, high);
        whole = whole && allWhole;
    });
    if (!(least <= greatest)) {
        least = 0.0;
        greatest = 0.0;
    }
    // Whole numbers within 16 bits are their own exact scale.
    const bool exact =
        whole && greatest - least < VoxelEncoding::codeCount && std::abs(least) < 1e9;
    // What differs by less is the same: a step may be neither 0 nor beyond float.
    constexpr double leastStep = 1e-30;
    const double spread = (greatest - least) / (VoxelEncoding::codeCount - 1);
    const double step = exact || spread < leastStep ? 1.0 : spread;
    volume.encoding = exact ? VoxelEncoding{.storedAtCodeZero = int(least)}
                            : VoxelEncoding{.rescaleSlope = step, .rescaleIntercept = least};

    bool allNumbers = true;
    double maxError = 0.0;
    parallelFor(slices, [&](int k) {
        std::vector<double> values(size);
        slice(k, values);
        std::uint16_t* code = loaded.codes.data() + std::size_t(k) * size;
        double error = 0.0;
        bool numbers = true;
        for (std::size_t voxel = 0; voxel < size; ++voxel) {
            const double value = values[voxel];
            const bool isNumber = isMeasured(value);
            numbers = numbers && isNumber;
            const double position = isNumber ? std::round((value - least) / step) : 0.0;
            code[voxel] =
                std::uint16_t(std::clamp(position, 0.0, double(VoxelEncoding::codeCount - 1)));
            if (isNumber)
                error = std::max(error, std::abs(volume.encoding.value(code[voxel]) - value));
        }
        const std::lock_guard lock(mutex);
        maxError = std::max(maxError, error);
        allNumbers = allNumbers && numbers;
    });
    volume.encoding.maxError = maxError;
    volume.minimum = least;
    volume.maximum = greatest;
    if (!allNumbers) {
        volume.problems.push_back(
            {.kind = VolumeProblem::Kind::InexactValues, .said = {ProblemCode::NoNumbers}});
    }
    if (maxError > 0.0) {
        volume.problems.push_back({.kind = VolumeProblem::Kind::InexactValues,
            .said = {
                volume.unit.isEmpty() ? ProblemCode::CommonScale : ProblemCode::CommonScaleInUnit,
                {QString::number(maxError, 'g', 3), volume.unit}}});
    }

    Sha256 hash;
    std::vector<double> values(size);
    std::vector<float> floats(size);
    const std::vector<float> valueOfCode = valuesOfCodes(volume.encoding);
    bool followFromCodes = true;
    for (int k = 0; k < slices; ++k) {
        slice(k, values);
        std::transform(values.begin(), values.end(), floats.begin(),
            [](double value) { return float(value); });
        addFloats(hash, floats);
        const std::uint16_t* code = loaded.codes.data() + std::size_t(k) * size;
        // By their bytes, as the checksum has them.
        followFromCodes = followFromCodes
            && std::equal(floats.begin(), floats.end(), code, [&](float value, std::uint16_t of) {
                   return std::memcmp(&value, &valueOfCode[of], sizeof value) == 0;
               });
    }
    volume.voxelsSha256 = hash.takeHex();
    if (!followFromCodes)
        volume.codesSha256 = sha256OfCodes(loaded);
    describeCounts(volume, countCodes(loaded), hasWindow);
}

void describeCodes(LoadedVolume& loaded, int outsideCode, std::uint64_t outside)
{
    loaded.volume.codesSha256.clear();
    QByteArray hash;
    LoneTask checksum([&] { hash = sha256OfValues(loaded); });
    CodeCounts counts = countCodes(loaded);
    checksum.finish();
    loaded.volume.voxelsSha256 = hash;
    describeExactCounts(loaded, std::move(counts), {.code = outsideCode, .voxels = outside}, true);
}

QByteArray sha256OfValues(const LoadedVolume& loaded)
{
    Sha256 hash;
    addValues(hash, loaded);
    return hash.takeHex();
}

QByteArray sha256OfCodes(const LoadedVolume& loaded)
{
    static_assert(std::endian::native == std::endian::little);
    Sha256 hash;
    hash.add(loaded.codes.data(), loaded.codes.size() * sizeof(std::uint16_t));
    return hash.takeHex();
}

void addValues(Sha256& hash, const LoadedVolume& loaded)
{
    addByTable(hash, loaded.codes, valuesOfCodes(loaded.volume.encoding));
}

} // namespace core
