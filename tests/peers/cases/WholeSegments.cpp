// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/WholeSegments.h"

#include "core/document/Document.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/morphology/SidedBall.h"
#include "core/volume/OtsuThresholds.h"
#include "tests/peers/ItkConnectedThreshold.h"
#include "tests/peers/ItkDistances.h"
#include "tests/peers/ItkMorphology.h"
#include "tests/peers/ItkParts.h"
#include "tests/peers/ItkSums.h"
#include "tests/peers/ItkValues.h"
#include "tests/peers/cases/BlendedSlices.h"
#include "tests/peers/cases/SeveralSegments.h"
#include "tests/peers/cases/SidedMargins.h"
#include "tests/support/scenes/PlainEdits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace peer {

namespace {

using core::ReshapeSegment;
using core::ShapeOperation;
using core::ShellPlace;
using State = RealSegment::State;

constexpr double radiusMm = 3.0;
constexpr double sigmaMm = 1.5;
constexpr int leastVoxels = 50; ///< of an island that stays

core::Edit reshape(ShapeOperation operation, double mm = radiusMm)
{
    return ReshapeSegment{.segment = RealSegment::label, .operation = operation, .mm = mm};
}

core::Edit hollow(ShellPlace place)
{
    return ReshapeSegment{.segment = RealSegment::label,
        .operation = ShapeOperation::Hollow,
        .mm = radiusMm,
        .shell = place};
}

PeerMask exactly(ItkMask mask)
{
    return {.voxels = std::move(mask.voxels), .milliseconds = mask.milliseconds};
}

/// 1 where one mask is and another is not.
PeerMask without(ItkMask one, const ItkMask& other)
{
    for (std::size_t voxel = 0; voxel < one.voxels.size(); ++voxel)
        one.voxels[voxel] = one.voxels[voxel] == 1 && other.voxels[voxel] == 0 ? 1 : 0;
    one.milliseconds += other.milliseconds;
    return exactly(std::move(one));
}

// --- By a ball -----------------------------------------------------------------------------------

/// By one filter of ITK's.
WholeSegment byBall(
    const char* name, const char* peer, ShapeOperation operation, ItkBallFilter filter)
{
    return {.name = name,
        .peer = peer,
        .before = State::Thresholded,
        .edit = [operation](const RealSegment&) { return reshape(operation); },
        .theirs =
            [filter](const RealSegment& segment) {
                return exactly(itkByBall(segment.mask(State::Thresholded), radiusMm, filter));
            }};
}

/// By the exact distance to the segment, or to all else. Its floats decide nothing where they lie
/// at the margin.
WholeSegment byDistance(const char* name, ShapeOperation operation)
{
    const auto theirs = [operation](const RealSegment& segment) {
        const GridMask mask = segment.mask(State::Thresholded);
        const bool grows = operation == ShapeOperation::Grow;
        std::vector<std::uint8_t> side(mask.voxels.begin(), mask.voxels.end());
        if (!grows) {
            for (std::uint8_t& voxel : side)
                voxel = voxel == 0 ? 1 : 0;
        }
        const ItkDistances distances = itkDistances(mask.size, mask.spacingMm, side);
        PeerMask made{.voxels = std::vector<std::uint8_t>(side.size()),
            .milliseconds = distances.milliseconds,
            .either = std::vector<std::uint8_t>(side.size())};
        constexpr double squaredRadius = radiusMm * radiusMm;
        constexpr double floats = 2e-6; // of the filter; and the millionth of core::ballOf()
        for (std::size_t voxel = 0; voxel < side.size(); ++voxel) {
            const double squared = double(distances.squared[voxel]);
            const bool isNear = squared <= squaredRadius;
            made.voxels[voxel] = isNear == grows ? 1 : 0;
            made.either[voxel] =
                std::abs(squared - squaredRadius) <= floats * squaredRadius ? 1 : 0;
        }
        return made;
    };
    return {.name = name,
        .peer = "ITK SignedMaurerDistanceMap",
        .before = State::Thresholded,
        .edit = [operation](const RealSegment&) { return reshape(operation); },
        .theirs = theirs,
        .whyEither = "its float distance is the margin, to two millionths"};
}

WholeSegment shell(const char* name, ShellPlace place)
{
    const auto theirs = [place](const RealSegment& segment) {
        const GridMask mask = segment.mask(State::Thresholded);
        const ItkMask own{.voxels = {mask.voxels.begin(), mask.voxels.end()}};
        const double ballMm = place == ShellPlace::Centred ? 0.5 * radiusMm : radiusMm;
        ItkMask outer =
            place == ShellPlace::Inside ? own : itkByBall(mask, ballMm, ItkBallFilter::Dilate);
        return without(std::move(outer),
            place == ShellPlace::Outside ? own : itkByBall(mask, ballMm, ItkBallFilter::Erode));
    };
    return {.name = name,
        .peer = place == ShellPlace::Inside ? "ITK BinaryErode"
            : place == ShellPlace::Outside  ? "ITK BinaryDilate"
                                            : "ITK BinaryDilate, BinaryErode",
        .before = State::Thresholded,
        .edit = [place](const RealSegment&) { return hollow(place); },
        .theirs = theirs};
}

// --- By a Gaussian -------------------------------------------------------------------------------

/// @param doubt where it finds one half to this, either is right
PeerMask moreThanHalf(const ItkGaussian& blurred, double doubt)
{
    constexpr double half = 0.5;
    PeerMask made{.voxels = std::vector<std::uint8_t>(blurred.values.size()),
        .milliseconds = blurred.milliseconds,
        .either = std::vector<std::uint8_t>(blurred.values.size())};
    for (std::size_t voxel = 0; voxel < blurred.values.size(); ++voxel) {
        const double value = double(blurred.values[voxel]);
        made.voxels[voxel] = value > half ? 1 : 0;
        made.either[voxel] = std::abs(value - half) < doubt ? 1 : 0;
    }
    return made;
}

PeerMask bySamples(const RealSegment& segment)
{
    constexpr double roundedTo = 5e-4;
    return moreThanHalf(itkSampledGaussian(segment.mask(State::Thresholded), sigmaMm), roundedTo);
}

PeerMask byDiscreteGaussian(const RealSegment& segment)
{
    const GridMask mask = segment.mask(State::Thresholded);
    PeerMask made = moreThanHalf(itkGaussian(mask.size, mask.spacingMm, mask.voxels, sigmaMm), 0.0);
    const PeerMask samples = bySamples(segment);
    for (std::size_t voxel = 0; voxel < made.either.size(); ++voxel)
        made.either[voxel] =
            made.voxels[voxel] != samples.voxels[voxel] || samples.either[voxel] == 1 ? 1 : 0;
    return made;
}

std::vector<WholeSegment> gaussians()
{
    const auto edit = [](const RealSegment&) { return reshape(ShapeOperation::Gaussian, sigmaMm); };
    return {{.name = "gaussian",
                .peer = "ITK DiscreteGaussian",
                .before = State::Thresholded,
                .edit = edit,
                .theirs = byDiscreteGaussian,
                .whyEither = "its kernel is Lindeberg's; with samples of a Gaussian ITK decides "
                             "there as Burin does"},
        {.name = "gaussian.samples",
            .peer = "ITK NeighborhoodOperator",
            .before = State::Thresholded,
            .edit = edit,
            .theirs = bySamples,
            .whyEither = "it finds one half to five ten-thousandths, to which Burin rounds"}};
}

// --- By values -----------------------------------------------------------------------------------

WholeSegment threshold()
{
    return {.name = "threshold",
        .peer = "ITK BinaryThreshold",
        .before = State::Empty,
        .edit =
            [](const RealSegment& segment) {
                return test::thresholdOf(
                    RealSegment::label, segment.series().lower, segment.series().upper);
            },
        .theirs =
            [](const RealSegment& segment) {
                return exactly(itkThreshold(segment.geometry().size, segment.values(),
                    float(segment.series().lower), float(segment.series().upper)));
            }};
}

/// From the first threshold to before the last one; from the only one on.
WholeSegment otsu(const char* name, int thresholds)
{
    const auto edit = [thresholds](const RealSegment& segment) -> core::Edit {
        const core::Volume& volume = segment.document().volumes.front();
        const std::vector<double> found = core::otsuThresholds(volume.histogram, thresholds);
        core::ThresholdSegment values{.segment = RealSegment::label, .lower = found.front()};
        if (found.size() > 1)
            values.upper =
                volume.encoding.value(volume.encoding.lowestCodeAtLeast(found.back()) - 1);
        return values;
    };
    const auto theirs = [thresholds](const RealSegment& segment) {
        const core::Histogram& histogram = segment.document().volumes.front().histogram;
        const ItkOtsu found =
            itkOtsu(histogram.counts, histogram.minimum, histogram.maximum, thresholds);
        const float from =
            std::nextafter(float(found.thresholds.front()), std::numeric_limits<float>::infinity());
        const float to = found.thresholds.size() > 1 ? float(found.thresholds.back())
                                                     : std::numeric_limits<float>::infinity();
        ItkMask mask = itkThreshold(segment.geometry().size, segment.values(), from, to);
        mask.milliseconds += found.milliseconds;
        PeerMask made = exactly(std::move(mask));
        made.either.resize(made.voxels.size());
        const double edge = 1e-6 * (histogram.maximum - histogram.minimum);
        for (std::size_t voxel = 0; voxel < made.either.size(); ++voxel) {
            for (const double each : found.thresholds) {
                if (std::abs(double(segment.values()[voxel]) - each) <= edge)
                    made.either[voxel] = 1;
            }
        }
        return made;
    };
    return {.name = name,
        .peer = "ITK OtsuMultipleThresholds",
        .before = State::Empty,
        .edit = edit,
        .theirs = theirs,
        .whyEither = "its value is the border of a bin, which ITK counts to the bin before"};
}

// --- Parts, mirror, slices -----------------------------------------------------------------------

core::Edit clean(core::IslandRule rule, std::optional<double> mm3 = std::nullopt)
{
    return core::CleanSegment{.segment = RealSegment::label, .rule = rule, .mm3 = mm3};
}

std::vector<WholeSegment> parts()
{
    using core::IslandRule;
    const auto labelled = [](ItkMask (*filter)(const GridMask&)) {
        return [filter](const RealSegment& segment) {
            return exactly(filter(segment.mask(State::Thresholded)));
        };
    };
    return {{.name = "island.largest",
                .peer = "ITK ConnectedComponent",
                .before = State::Thresholded,
                .edit = [](const RealSegment&) { return clean(IslandRule::KeepLargest); },
                .theirs = labelled(itkLargestPart)},
        {.name = "islands.small",
            .peer = "ITK ConnectedComponent",
            .before = State::Thresholded,
            .edit =
                [](const RealSegment& segment) {
                    return clean(IslandRule::RemoveSmall,
                        (leastVoxels - 0.5) * segment.geometry().voxelVolumeMm3());
                },
            .theirs =
                [](const RealSegment& segment) {
                    return exactly(itkPartsFrom(segment.mask(State::Thresholded), leastVoxels));
                }},
        {.name = "holes",
            .peer = "ITK BinaryFillhole",
            .before = State::Thresholded,
            .edit = [](const RealSegment&) { return clean(IslandRule::FillHoles); },
            .theirs = labelled(itkFilledHoles)}};
}

WholeSegment invert()
{
    return {.name = "invert",
        .peer = "ITK BinaryNot",
        .before = State::Thresholded,
        .edit =
            [](const RealSegment&) { return core::InvertSegment{.segment = RealSegment::label}; },
        .theirs =
            [](const RealSegment& segment) {
                return exactly(itkInverted(segment.mask(State::Thresholded)));
            }};
}

WholeSegment mirror()
{
    return {.name = "mirror",
        .peer = "ITK Flip",
        .before = State::Thresholded,
        .edit =
            [](const RealSegment&) { return core::MirrorSegment{.segment = RealSegment::label}; },
        .theirs =
            [](const RealSegment& segment) {
                return exactly(itkFlipped(segment.mask(State::Thresholded),
                    core::axesOfPatient(segment.geometry()).front()));
            }};
}

/// The segment and its image from front to back, about a plane off the middle of the volume.
WholeSegment mirrorBeside()
{
    const auto axis = [](const RealSegment& segment) {
        return core::axesOfPatient(segment.geometry())
            .at(std::size_t(core::MirroredSides::AnteriorPosterior));
    };
    const auto edit = [axis](const RealSegment& segment) -> core::Edit {
        glm::dvec3 place(0.0);
        place[axis(segment)] = segment.geometry().size[axis(segment)] / 3;
        return core::MirrorSegment{.segment = RealSegment::label,
            .sides = core::MirroredSides::AnteriorPosterior,
            .placeLps = segment.geometry().toWorld(place),
            .keep = true};
    };
    const auto theirs = [axis](const RealSegment& segment) {
        return exactly(itkWithMirrorImage(segment.mask(State::Thresholded), axis(segment),
            segment.geometry().size[axis(segment)] / 3));
    };
    return {.name = "mirror.beside",
        .peer = "ITK Flip, Resample, Or",
        .before = State::Thresholded,
        .edit = edit,
        .theirs = theirs};
}

/// From a voxel of the thresholded segment.
WholeSegment flood()
{
    const auto tolerance = [](const RealSegment& segment) {
        constexpr double noValue = 0.25; // values are whole numbers
        constexpr double part = 0.25;
        return std::floor(part * (segment.series().upper - segment.series().lower)) + noValue;
    };
    const auto seed = [](const RealSegment& segment) {
        const std::vector<std::uint8_t>& labels = segment.labels(State::Thresholded);
        const auto half = labels.begin() + std::ptrdiff_t(labels.size() / 2);
        auto found = std::find(half, labels.end(), RealSegment::label);
        if (found == labels.end())
            found = std::find(labels.begin(), half, RealSegment::label);
        return std::size_t(found - labels.begin());
    };
    const auto voxelAt = [](const RealSegment& segment, std::size_t place) {
        const glm::ivec3& size = segment.geometry().size;
        const auto columns = std::size_t(size.x);
        const auto rows = std::size_t(size.y);
        return glm::ivec3(
            int(place % columns), int(place / columns % rows), int(place / columns / rows));
    };
    const auto edit = [=](const RealSegment& segment) -> core::Edit {
        const glm::ivec3 voxel = voxelAt(segment, seed(segment));
        return core::FloodFill{.segment = RealSegment::label,
            .placeLps = segment.geometry().toWorld(glm::dvec3(voxel)),
            .tolerance = tolerance(segment)};
    };
    const auto theirs = [=](const RealSegment& segment) {
        const std::size_t place = seed(segment);
        const std::vector<glm::ivec3> seeds{voxelAt(segment, place)};
        const double value = double(segment.values()[place]);
        ItkGrown grown = itkConnectedThreshold<float>(segment.geometry().size, segment.values(),
            seeds, float(value - tolerance(segment)), float(value + tolerance(segment)));
        return PeerMask{.voxels = std::move(grown.mask), .milliseconds = grown.milliseconds};
    };
    return {.name = "flood",
        .peer = "ITK ConnectedThreshold",
        .before = State::Empty,
        .edit = edit,
        .theirs = theirs};
}

WholeSegment majority()
{
    return {.name = "median",
        .peer = "ITK NeighborhoodOperator",
        .before = State::Thresholded,
        .edit = [](const RealSegment&) { return reshape(ShapeOperation::Median); },
        .theirs =
            [](const RealSegment& segment) {
                return exactly(itkMajority(segment.mask(State::Thresholded), radiusMm));
            }};
}

WholeSegment between()
{
    return {.name = "slices.between",
        .peer = "ITK distances, blended",
        .before = State::Drawn,
        .edit =
            [](const RealSegment&) {
                return core::FillBetweenSlices{
                    .segment = RealSegment::label, .axis = core::SliceAxis::K};
            },
        .theirs =
            [](const RealSegment& segment) {
                return blendedSlices(segment.mask(State::Drawn), RealSegment::slicesApart);
            },
        .whyEither = "a slice has several parts, which Burin matches; or the blend is nothing to a "
                     "ten-thousandth of a millimetre"};
}

} // namespace

const std::vector<WholeSegment>& wholeSegments()
{
    static const std::vector<WholeSegment> all = [] {
        std::vector<WholeSegment> made = parts();
        const std::vector<WholeSegment> more{threshold(), otsu("otsu", 1), otsu("otsu.three", 2),
            byDistance("margin.grow", ShapeOperation::Grow),
            byDistance("margin.shrink", ShapeOperation::Shrink),
            byBall("opening", "ITK BinaryMorphologicalOpening", ShapeOperation::Open,
                ItkBallFilter::Open),
            byBall("closing", "ITK BinaryMorphologicalClosing", ShapeOperation::Close,
                ItkBallFilter::Close),
            byBall(
                "wrap", "ITK Dilate, Fillhole, Erode", ShapeOperation::Wrap, ItkBallFilter::Wrap),
            shell("hollow.inside", ShellPlace::Inside),
            shell("hollow.centred", ShellPlace::Centred),
            shell("hollow.outside", ShellPlace::Outside), sidedMargin(true), sidedMargin(false),
            flood(), majority(), invert(), mirror(), mirrorBeside(), between()};
        made.insert(made.end(), more.begin(), more.end());
        const std::vector<WholeSegment> blurred = gaussians();
        made.insert(made.end(), blurred.begin(), blurred.end());
        const std::vector<WholeSegment> several = severalSegments();
        made.insert(made.end(), several.begin(), several.end());
        return made;
    }();
    return all;
}

} // namespace peer
