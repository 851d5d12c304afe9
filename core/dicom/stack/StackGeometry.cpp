// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/StackGeometry.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace core {

namespace {

QString millimetres(double value)
{
    return QString::number(value, 'g', 5);
}

void placeSingle(SliceStack& stack, glm::dmat4& affine)
{
    const ImageHeader& slice = stack.slices.front();
    double distance = 1.0;
    QString source;
    if (slice.spacingBetweenSlices > 0.0) {
        distance = slice.spacingBetweenSlices;
        source = QStringLiteral("SpacingBetweenSlices");
    } else if (slice.sliceThickness > 0.0) {
        distance = slice.sliceThickness;
        source = QStringLiteral("SliceThickness");
    }
    affine[2] = glm::dvec4(slice.plane->normal() * distance, 0.0);
    stack.problems.push_back({.kind = VolumeProblem::Kind::AssumedSpacing,
        .said = {source.isEmpty() ? ProblemCode::DepthAssumed : ProblemCode::DepthTakenFrom,
            {millimetres(distance), source}},
        .caution = true});
}

/// Gaps that are whole multiples of the usual one are missing slices; empty if they are not.
std::vector<ProblemSentence> missingBetween(
    const std::vector<double>& gaps, double usual, int& missing, std::vector<SliceSpan>& slices)
{
    constexpr double share = 0.05;
    std::vector<ProblemSentence> where;
    for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
        const double ratio = gaps[gap] / usual;
        const double steps = std::round(ratio);
        if (steps < 1.0 || std::abs(ratio - steps) > share * steps)
            return {};
        if (steps < 2.0)
            continue;
        missing += int(steps) - 1;
        slices.push_back({.first = int(gap) + 1, .last = int(gap) + 2});
        where.push_back({ProblemCode::SlicesMissingBetween,
            {std::int64_t(steps) - 1, std::int64_t(gap) + 1, std::int64_t(gap) + 2,
                millimetres(gaps[gap]), millimetres(usual)}});
    }
    return where;
}

/// "4 mm between slices 1 and 6, 7 mm between 6 and 10"; where the distance changes too often for
/// that, between which slices it is greatest.
std::vector<ProblemSentence> distancesInWords(
    const std::vector<double>& gaps, std::vector<SliceSpan>& slices)
{
    constexpr std::size_t mostRuns = 4;
    std::vector<SliceSpan> runs;
    for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
        const auto slice = int(gap) + 1;
        const double usual = runs.empty() ? 0.0 : gaps[std::size_t(runs.back().first - 1)];
        if (!runs.empty() && std::abs(gaps[gap] - usual) <= evenSlicesToleranceMm(usual))
            runs.back().last = slice + 1;
        else
            runs.push_back({.first = slice, .last = slice + 1});
    }
    if (runs.size() > mostRuns) {
        const auto greatest = std::max_element(gaps.begin(), gaps.end());
        const auto slice = int(greatest - gaps.begin()) + 1;
        slices = {{.first = slice, .last = slice + 1}};
        return {{ProblemCode::GreatestDistanceBetween, {slice, slice + 1}}};
    }
    std::vector<ProblemSentence> words;
    for (const SliceSpan& run : runs)
        words.push_back(
            {words.empty() ? ProblemCode::DistanceBetweenSlices : ProblemCode::DistanceBetween,
                {millimetres(gaps[std::size_t(run.first - 1)]), run.first, run.last}});
    slices = std::move(runs);
    return words;
}

void reportGaps(SliceStack& stack, const std::vector<double>& gaps, double usual)
{
    int missing = 0;
    std::vector<SliceSpan> slices;
    const std::vector<ProblemSentence> where = missingBetween(gaps, usual, missing, slices);
    if (!where.empty()) {
        stack.problems.push_back({.kind = VolumeProblem::Kind::MissingSlices,
            .said = {ProblemCode::SlicesMissing, {missing, withCommas(where)}},
            .caution = true,
            .slices = slices});
        return;
    }
    const auto [least, greatest] = std::minmax_element(gaps.begin(), gaps.end());
    std::vector<ProblemSentence> distances = distancesInWords(gaps, slices);
    stack.problems.push_back({.kind = VolumeProblem::Kind::UnevenSpacing,
        .said = {ProblemCode::DistancesVary,
            {millimetres(*least), millimetres(*greatest), withCommas(std::move(distances))}},
        .caution = true,
        .slices = slices});
}

void reportDrift(SliceStack& stack)
{
    stack.problems.push_back({.kind = VolumeProblem::Kind::UnevenSpacing,
        .said = {ProblemCode::PositionsWander, {millimetres(sidewaysDriftMm(stack))}},
        .caution = true});
}

void placeMany(SliceStack& stack, glm::dmat4& affine)
{
    const std::vector<ImageHeader>& slices = stack.slices;
    const glm::dvec3 normal = slices.front().plane->normal();
    const glm::dvec3 first = *slices.front().position;
    const glm::dvec3 step = (*slices.back().position - first) / double(slices.size() - 1);
    affine[2] = glm::dvec4(step, 0.0);

    std::vector<double> gaps;
    for (std::size_t k = 1; k < slices.size(); ++k)
        gaps.push_back(glm::dot(*slices[k].position - *slices[k - 1].position, normal));
    std::vector<double> sorted = gaps;
    const std::size_t middle = (sorted.size() - 1) / 2;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(middle), sorted.end());
    const double usual = sorted[middle];

    const double tolerance = evenSlicesToleranceMm(usual);
    double worst = 0.0;
    double worstAlong = 0.0;
    for (std::size_t k = 0; k < slices.size(); ++k) {
        const glm::dvec3 off = *slices[k].position - (first + step * double(k));
        worst = std::max(worst, glm::length(off));
        worstAlong = std::max(worstAlong, std::abs(glm::dot(off, normal)));
    }
    if (worst <= tolerance)
        return;
    for (const ImageHeader& slice : slices)
        stack.geometry.slicePositions.push_back(*slice.position);
    const bool isEven = worstAlong <= tolerance
        && std::all_of(gaps.begin(), gaps.end(),
            [&](double gap) { return std::abs(gap - usual) <= tolerance; });
    if (isEven)
        reportDrift(stack);
    else
        reportGaps(stack, gaps, usual);
}

} // namespace

void placeSlices(SliceStack& stack)
{
    const ImageHeader& first = stack.slices.front();
    VolumeGeometry& geometry = stack.geometry;
    geometry.size = {first.layout.columns, first.layout.rows, int(stack.slices.size())};
    geometry.slicePositions.clear();
    glm::dmat4& affine = geometry.indexToWorld;
    affine[0] = glm::dvec4(first.plane->row * first.spacing->x, 0.0);
    affine[1] = glm::dvec4(first.plane->column * first.spacing->y, 0.0);
    affine[3] = glm::dvec4(*first.position, 1.0);
    if (stack.slices.size() == 1) {
        placeSingle(stack, affine);
        return;
    }
    placeMany(stack, affine);
    constexpr double straightDegrees = 0.1;
    if (const double angle = geometry.shearAngleDegrees(); angle > straightDegrees) {
        stack.problems.push_back({.kind = VolumeProblem::Kind::Tilt,
            .said = {ProblemCode::SlicesTilted, {QString::number(angle, 'f', 1)}},
            .caution = true});
    }
}

double sidewaysDriftMm(const SliceStack& stack)
{
    const std::vector<ImageHeader>& slices = stack.slices;
    if (slices.size() < 3)
        return 0.0;
    const glm::dvec3 normal = slices.front().plane->normal();
    const glm::dvec3 first = *slices.front().position;
    const glm::dvec3 whole = *slices.back().position - first;
    const double depth = glm::dot(whole, normal);
    double worst = 0.0;
    for (const ImageHeader& slice : slices) {
        const glm::dvec3 here = *slice.position - first;
        worst = std::max(worst, glm::length(here - whole * (glm::dot(here, normal) / depth)));
    }
    return worst;
}

VolumeProblem damagedSlices(const QStringList& names)
{
    return {.kind = VolumeProblem::Kind::DamagedSlice,
        .said = {ProblemCode::DamagedLeftOut, {std::int64_t(names.size()), namesIn(names)}},
        .caution = true};
}

VolumeProblem undecodedSlices(const std::vector<UndecodedSlice>& slices)
{
    constexpr std::size_t named = 10;
    ProblemSentence::Listed each{.joiner = ProblemCode::Semicolon};
    for (std::size_t i = 0; i < std::min(slices.size(), named); ++i)
        each.all.push_back({i == 0 ? ProblemCode::FirstUndecoded : ProblemCode::NextUndecoded,
            {slices[i].number, slices[i].image, slices[i].reason}});
    if (slices.size() > named)
        each.all.push_back({ProblemCode::UndecodedMore, {std::int64_t(slices.size() - named)}});
    return {.kind = VolumeProblem::Kind::DamagedSlice,
        .said = {slices.size() == 1 ? ProblemCode::OneUndecodedLeftOut
                                    : ProblemCode::UndecodedLeftOut,
            {std::move(each)}},
        .caution = true};
}

QString imageName(const ImageHeader& image)
{
    const QString name = QFileInfo(image.file).fileName();
    return image.frames > 1 ? QStringLiteral("%1 frame %2").arg(name).arg(image.frame + 1) : name;
}

} // namespace core
