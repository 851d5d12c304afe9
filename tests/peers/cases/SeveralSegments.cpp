// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/SeveralSegments.h"

#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/peers/ItkLabels.h"
#include "tests/peers/ItkParts.h"
#include "tests/peers/ItkSums.h"
#include "tests/peers/ItkValues.h"
#include "tests/support/scenes/PlainEdits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

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

PeerMask exactly(ItkMask mask)
{
    return {.voxels = std::move(mask.voxels), .milliseconds = mask.milliseconds};
}

/// Makes the other segment.
/// @param plane none: that of the first
std::vector<core::Edit> otherSegment(
    const RealSegment& segment, double within, std::optional<int> plane)
{
    const OtherValues values = valuesBelow(segment, within);
    return {core::AddSegment{.name = QStringLiteral("B"), .plane = plane},
        test::thresholdOf(other, double(values.lower), double(values.upper))};
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
                return exactly(itkCombined(
                    segment.mask(State::Thresholded), onGrid(segment, beside), operation));
            },
        .first = [](const RealSegment& segment) { return otherSegment(segment, within, 1); }};
}

// --- Merging, swapping, copying ------------------------------------------------------------------

/// Of two segments of one plane.
WholeSegment exchanged(
    const char* name, CombineSegments::How how, const std::vector<ChangedLabel>& changes)
{
    return {.name = name,
        .peer = "ITK ChangeLabel",
        .before = State::Thresholded,
        .edit =
            [how](const RealSegment&) {
                return CombineSegments{.segment = label, .with = other, .how = how};
            },
        .theirs =
            [changes](const RealSegment& segment) {
                const ItkMask beside = maskOf(segment, valuesBelow(segment, 0.0));
                ItkMask labels{.voxels = segment.labels(State::Thresholded)};
                for (std::size_t voxel = 0; voxel < labels.voxels.size(); ++voxel) {
                    if (beside.voxels[voxel] == 1)
                        labels.voxels[voxel] = other;
                }
                return exactly(itkRelabelled(onGrid(segment, labels), changes));
            },
        .first =
            [](const RealSegment& segment) { return otherSegment(segment, 0.0, std::nullopt); }};
}

/// Into a plane in which another segment keeps its voxels.
WholeSegment copied()
{
    constexpr double within = 40.0;
    constexpr int copy = 3;
    return {.name = "copy",
        .peer = "ITK MaskNegated",
        .before = State::Thresholded,
        .edit =
            [](const RealSegment&) {
                return core::CopySegment{.segment = label, .name = QStringLiteral("C"), .plane = 1};
            },
        .theirs =
            [](const RealSegment& segment) {
                const ItkMask beside = maskOf(segment, valuesBelow(segment, within));
                ItkMask labels{.voxels = segment.labels(State::Thresholded)};
                std::replace(labels.voxels.begin(), labels.voxels.end(), std::uint8_t(label),
                    std::uint8_t(copy));
                return exactly(
                    itkOutsideOf(onGrid(segment, labels), onGrid(segment, beside), other));
            },
        .first = [](const RealSegment& segment) { return otherSegment(segment, within, 1); },
        .plane = 1};
}

// --- Splitting by a plane ------------------------------------------------------------------------

/// Oblique, in numbers that edits hold as they are.
const glm::dvec3 splitNormalLps(1.0, 0.5, -0.75);

/// The middle of the segment, likewise.
glm::dvec3 splitPointLps(const RealSegment& segment)
{
    constexpr double perMillimetre = 1024.0;
    const glm::ivec3 size = segment.geometry().size;
    const std::vector<std::uint8_t>& labels = segment.labels(State::Thresholded);
    glm::dvec3 sum(0.0);
    double count = 0.0;
    std::size_t voxel = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++voxel) {
                if (labels[voxel] != label)
                    continue;
                sum += glm::dvec3(x, y, z);
                count += 1.0;
            }
        }
    }
    const glm::dvec3 middle = segment.geometry().toWorld(sum / std::max(count, 1.0));
    return glm::round(middle * perMillimetre) / perMillimetre;
}

PeerMask splitByPlane(const RealSegment& segment)
{
    const core::VolumeGeometry& geometry = segment.geometry();
    const glm::dvec3 point = splitPointLps(segment);
    PeerMask made = exactly(itkSplitByPlane(segment.mask(State::Thresholded),
        {.originLps = geometry.originLps(), .direction = geometry.direction()}, point,
        splitNormalLps, other));
    // Burin rounds what a step along an axis of the grid contributes to 20 bits of the greatest.
    const glm::dvec3 perStep =
        glm::abs(glm::transpose(glm::dmat3(geometry.indexToWorld)) * splitNormalLps);
    const double roundedTo = 0.5 * std::max({perStep.x, perStep.y, perStep.z}) / 1048576.0;
    const glm::ivec3 size = geometry.size;
    const double doubt = roundedTo * (size.x + size.y + size.z + 1);
    made.either.reserve(made.voxels.size());
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 place = geometry.toWorld(glm::dvec3(x, y, z));
                const double depth = glm::dot(splitNormalLps, place - point);
                made.either.push_back(std::abs(depth) <= doubt ? 1 : 0);
            }
        }
    }
    return made;
}

WholeSegment planeSplit()
{
    return {.name = "split.plane",
        .peer = "ITK TransformIndexToPhysicalPoint",
        .before = State::Thresholded,
        .edit =
            [](const RealSegment& segment) {
                return core::SplitSegment{.segment = label,
                    .placeLps = splitPointLps(segment),
                    .normalLps = splitNormalLps,
                    .into = {.name = QStringLiteral("B")}};
            },
        .theirs = splitByPlane,
        .whyEither = "its centre lies in the plane, as exactly as Burin holds the plane's slope"};
}

// --- Islands -------------------------------------------------------------------------------------

WholeSegment islands()
{
    constexpr double half = 0.5;
    return {.name = "islands.split",
        .peer = "ITK RelabelComponent",
        .before = State::Thresholded,
        .edit =
            [](const RealSegment& segment) {
                return core::SplitIslands{.segment = label,
                    .mm3 =
                        (leastIslandVoxels(segment) - half) * segment.geometry().voxelVolumeMm3()};
            },
        .theirs =
            [](const RealSegment& segment) {
                return exactly(
                    itkNumberedParts(segment.mask(State::Thresholded), leastIslandVoxels(segment)));
            }};
}

/// Islands by their size, 2 the second largest, and 1 the largest or one that is too small.
ItkMask numberedIslands(const RealSegment& segment)
{
    return itkNumberedParts(segment.mask(State::Thresholded), leastIslandVoxels(segment));
}

/// The second largest island is clicked.
/// @param becomes what voxels of that island become, and what those of the others do
WholeSegment clicked(
    const char* name, core::IslandRule rule, std::uint8_t becomes, std::uint8_t othersBecome)
{
    constexpr std::uint8_t second = 2;
    const bool gives = rule == core::IslandRule::GiveClicked;
    WholeSegment made{.name = name,
        .peer = "ITK RelabelComponent",
        .before = State::Thresholded,
        .edit =
            [=](const RealSegment& segment) {
                const std::vector<std::uint8_t> islands = numberedIslands(segment).voxels;
                const auto place = std::size_t(
                    std::find(islands.begin(), islands.end(), second) - islands.begin());
                const glm::ivec3 size = segment.geometry().size;
                const auto columns = std::size_t(size.x);
                const auto rows = std::size_t(size.y);
                const glm::dvec3 voxel(double(place % columns), double(place / columns % rows),
                    double(place / columns / rows));
                return core::CleanSegment{.segment = label,
                    .rule = rule,
                    .islandLps = segment.geometry().toWorld(voxel),
                    .to = gives ? std::optional(other) : std::nullopt};
            },
        .theirs =
            [=](const RealSegment& segment) {
                ItkMask islands = numberedIslands(segment);
                for (std::uint8_t& voxel : islands.voxels) {
                    if (voxel != 0)
                        voxel = voxel == second ? becomes : othersBecome;
                }
                return exactly(std::move(islands));
            }};
    if (gives)
        made.first = [](const RealSegment&) {
            return std::vector<core::Edit>{core::AddSegment{.name = QStringLiteral("B")}};
        };
    return made;
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
            [](const RealSegment& segment) { return otherSegment(segment, 0.0, std::nullopt); }};
}

} // namespace

int leastIslandVoxels(const RealSegment& segment)
{
    constexpr int mostIslands = 200;
    int least = 1;
    while (itkPartCount(segment.mask(RealSegment::State::Thresholded), least) > mostIslands)
        least *= 2;
    return least;
}

std::vector<WholeSegment> severalSegments()
{
    using How = CombineSegments::How;
    return {combined("union", "ITK Or", How::Union, ItkSetOperation::Union),
        combined("subtract", "ITK BinaryNot, And", How::Subtract, ItkSetOperation::Subtract),
        combined("intersect", "ITK And", How::Intersect, ItkSetOperation::Intersect),
        exchanged("merge", How::Merge, {{.from = other, .to = label}}),
        exchanged("swap", How::Swap, {{.from = label, .to = other}, {.from = other, .to = label}}),
        copied(), planeSplit(), islands(),
        clicked("island.clicked.keep", core::IslandRule::KeepClicked, label, 0),
        clicked("island.clicked.remove", core::IslandRule::RemoveClicked, 0, label),
        clicked("island.clicked.give", core::IslandRule::GiveClicked, other, label), together()};
}

} // namespace peer
