// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/SeveralSegments.h"

#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/peers/ItkParts.h"
#include "tests/peers/ItkSums.h"
#include "tests/peers/ItkValues.h"
#include "tests/support/scenes/PlainEdits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace peer {

namespace {

using core::CombineSegments;
using State = RealSegment::State;

constexpr int label = RealSegment::label;
constexpr int other = 2;
constexpr double sigmaMm = 1.5;

/// The values of another segment, from below those of the first to @p within of them.
struct OtherValues {
    float lower;
    float upper;
};
OtherValues valuesBelow(const RealSegment& segment, double within)
{
    constexpr double beneath = 60.0;
    constexpr double noValue = 0.5; // values are whole numbers
    const RealSeries& series = segment.series();
    return {float(series.lower - beneath - noValue), float(series.lower + within - noValue)};
}

ItkMask maskOf(const RealSegment& segment, const OtherValues& values)
{
    return itkThreshold(segment.geometry().size, segment.values(), values.lower, values.upper);
}

GridMask onGrid(const RealSegment& segment, const ItkMask& mask)
{
    GridMask made = segment.mask(State::Thresholded);
    made.voxels = mask.voxels;
    return made;
}

// --- Set operations ------------------------------------------------------------------------------

WholeSegment combined(
    const char* name, const char* peer, CombineSegments::How how, ItkSetOperation operation)
{
    constexpr double within = 40.0;
    return {.name = name,
        .peer = peer,
        .before = State::Thresholded,
        .edit =
            [how](const RealSegment&) {
                return CombineSegments{.segment = label, .with = other, .how = how};
            },
        .theirs =
            [operation](const RealSegment& segment) {
                const ItkMask beside = maskOf(segment, valuesBelow(segment, within));
                ItkMask made = itkCombined(
                    segment.mask(State::Thresholded), onGrid(segment, beside), operation);
                return PeerMask{
                    .voxels = std::move(made.voxels), .milliseconds = made.milliseconds};
            },
        .first =
            [](const RealSegment& segment) {
                const OtherValues values = valuesBelow(segment, within);
                return std::vector<core::Edit>{
                    core::AddSegment{.name = QStringLiteral("B"), .plane = 1},
                    test::thresholdOf(other, double(values.lower), double(values.upper))};
            }};
}

// --- Islands -------------------------------------------------------------------------------------

/// Of an island that becomes a segment, so that there are labels for all of them.
int leastVoxels(const RealSegment& segment)
{
    constexpr int mostIslands = 200;
    int least = 1;
    while (itkPartCount(segment.mask(State::Thresholded), least) > mostIslands)
        least *= 2;
    return least;
}

WholeSegment islands()
{
    constexpr double half = 0.5;
    return {.name = "islands.split",
        .peer = "ITK RelabelComponent",
        .before = State::Thresholded,
        .edit =
            [](const RealSegment& segment) {
                return core::SplitIslands{.segment = label,
                    .mm3 = (leastVoxels(segment) - half) * segment.geometry().voxelVolumeMm3()};
            },
        .theirs =
            [](const RealSegment& segment) {
                ItkMask made =
                    itkNumberedParts(segment.mask(State::Thresholded), leastVoxels(segment));
                return PeerMask{
                    .voxels = std::move(made.voxels), .milliseconds = made.milliseconds};
            }};
}

// --- Smoothing together --------------------------------------------------------------------------

/// Of free voxels and of both segments the one that is blurred to the greatest value, the lowest
/// first.
PeerMask smoothedTogether(const RealSegment& segment)
{
    constexpr double roundedTo = 5e-4; // to which Burin rounds
    const std::size_t count = segment.labels(State::Thresholded).size();
    std::array<ItkMask, 3> masks;
    masks[label].voxels.assign(
        segment.labels(State::Thresholded).begin(), segment.labels(State::Thresholded).end());
    masks[other] = maskOf(segment, valuesBelow(segment, 0.0));
    masks[0].voxels.resize(count);
    for (std::size_t voxel = 0; voxel < count; ++voxel)
        masks[0].voxels[voxel] =
            masks[label].voxels[voxel] == 0 && masks[other].voxels[voxel] == 0 ? 1 : 0;
    PeerMask made{
        .voxels = std::vector<std::uint8_t>(count), .either = std::vector<std::uint8_t>(count)};
    std::array<ItkGaussian, 3> blurred;
    for (std::size_t each = 0; each < masks.size(); ++each) {
        blurred.at(each) = itkSampledGaussian(onGrid(segment, masks.at(each)), sigmaMm);
        made.milliseconds += blurred.at(each).milliseconds;
    }
    for (std::size_t voxel = 0; voxel < count; ++voxel) {
        std::array<double, 3> values{double(blurred[0].values[voxel]),
            double(blurred[label].values[voxel]), double(blurred[other].values[voxel])};
        const auto greatest = std::max_element(values.begin(), values.end());
        made.voxels[voxel] = std::uint8_t(greatest - values.begin());
        const double most = *greatest;
        const auto near = [most](double value) { return value > most - roundedTo; };
        made.either[voxel] = std::count_if(values.begin(), values.end(), near) > 1 ? 1 : 0;
    }
    return made;
}

WholeSegment together()
{
    return {.name = "gaussian.together",
        .peer = "ITK NeighborhoodOperator",
        .before = State::Thresholded,
        .edit =
            [](const RealSegment&) {
                return core::ReshapeSegment{.segment = label,
                    .operation = core::ShapeOperation::Gaussian,
                    .mm = sigmaMm,
                    .with = std::vector<int>{other}};
            },
        .theirs = smoothedTogether,
        .whyEither = "two of its values differ by no more than Burin rounds to",
        .first =
            [](const RealSegment& segment) {
                const OtherValues values = valuesBelow(segment, 0.0);
                return std::vector<core::Edit>{test::newSegment(QStringLiteral("B")),
                    test::thresholdOf(other, double(values.lower), double(values.upper))};
            }};
}

} // namespace

std::vector<WholeSegment> severalSegments()
{
    using How = CombineSegments::How;
    return {combined("union", "ITK Or", How::Union, ItkSetOperation::Union),
        combined("subtract", "ITK BinaryNot, And", How::Subtract, ItkSetOperation::Subtract),
        combined("intersect", "ITK And", How::Intersect, ItkSetOperation::Intersect), islands(),
        together()};
}

} // namespace peer
