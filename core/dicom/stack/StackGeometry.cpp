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
    QString source = QStringLiteral("nothing in the file");
    if (slice.spacingBetweenSlices > 0.0) {
        distance = slice.spacingBetweenSlices;
        source = QStringLiteral("SpacingBetweenSlices");
    } else if (slice.sliceThickness > 0.0) {
        distance = slice.sliceThickness;
        source = QStringLiteral("SliceThickness");
    }
    affine[2] = glm::dvec4(slice.plane->normal() * distance, 0.0);
    stack.problems.push_back({.kind = VolumeProblem::Kind::AssumedSpacing,
        .text = QStringLiteral("A single image: its depth of %1 mm is assumed from %2.")
                    .arg(millimetres(distance), source),
        .caution = true});
}

/// Gaps that are whole multiples of the usual one are missing slices; empty if they are not.
QStringList missingBetween(
    const std::vector<double>& gaps, double usual, int& missing, std::vector<SliceSpan>& slices)
{
    constexpr double share = 0.05;
    QStringList where;
    for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
        const double ratio = gaps[gap] / usual;
        const double steps = std::round(ratio);
        if (steps < 1.0 || std::abs(ratio - steps) > share * steps)
            return {};
        if (steps < 2.0)
            continue;
        missing += int(steps) - 1;
        slices.push_back({.first = int(gap) + 1, .last = int(gap) + 2});
        where.append(QStringLiteral("%1 between slices %2 and %3 (%4 mm instead of %5)")
                         .arg(int(steps) - 1)
                         .arg(gap + 1)
                         .arg(gap + 2)
                         .arg(millimetres(gaps[gap]), millimetres(usual)));
    }
    return where;
}

/// "4 mm between slices 1 and 6, 7 mm between 6 and 10"; where the distance changes too often for
/// that, between which slices it is greatest.
QString distancesInWords(const std::vector<double>& gaps, std::vector<SliceSpan>& slices)
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
        return QStringLiteral("it is greatest between slices %1 and %2").arg(slice).arg(slice + 1);
    }
    QStringList words;
    for (const SliceSpan& run : runs) {
        words += QStringLiteral("%1 mm between %2%3 and %4")
                     .arg(millimetres(gaps[std::size_t(run.first - 1)]),
                         words.isEmpty() ? QStringLiteral("slices ") : QString())
                     .arg(run.first)
                     .arg(run.last);
    }
    slices = std::move(runs);
    return words.join(QLatin1String(", "));
}

void reportGaps(SliceStack& stack, const std::vector<double>& gaps, double usual)
{
    int missing = 0;
    std::vector<SliceSpan> slices;
    const QStringList where = missingBetween(gaps, usual, missing, slices);
    if (!where.isEmpty()) {
        stack.problems.push_back({.kind = VolumeProblem::Kind::MissingSlices,
            .text = (missing == 1 ? QStringLiteral("1 slice is missing: %2.")
                                  : QStringLiteral("%1 slices are missing: %2.").arg(missing))
                        .replace(QLatin1String("%2"), where.join(QLatin1String(", "))),
            .caution = true,
            .slices = slices});
        return;
    }
    const auto [least, greatest] = std::minmax_element(gaps.begin(), gaps.end());
    stack.problems.push_back({.kind = VolumeProblem::Kind::UnevenSpacing,
        .text =
            QStringLiteral("The distance between slices varies from %1 to %2 mm: %3.")
                .arg(millimetres(*least), millimetres(*greatest), distancesInWords(gaps, slices)),
        .caution = true,
        .slices = slices});
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
    for (std::size_t k = 0; k < slices.size(); ++k)
        worst = std::max(worst, glm::length(*slices[k].position - (first + step * double(k))));
    if (worst > tolerance) {
        for (const ImageHeader& slice : slices)
            stack.geometry.slicePositions.push_back(*slice.position);
        reportGaps(stack, gaps, usual);
    }
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
            .text = QStringLiteral("The slices are tilted by %1° against their stacking direction "
                                   "(gantry tilt).")
                        .arg(angle, 0, 'f', 1),
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
        .text = names.size() == 1
            ? QStringLiteral("1 damaged slice was left out: %1.").arg(names.front())
            : QStringLiteral("%1 damaged slices were left out: %2.")
                  .arg(names.size())
                  .arg(names.join(QLatin1String(", "))),
        .caution = true};
}

VolumeProblem undecodedSlices(const std::vector<UndecodedSlice>& slices)
{
    constexpr std::size_t named = 10;
    QStringList each;
    for (std::size_t i = 0; i < std::min(slices.size(), named); ++i)
        each += QStringLiteral("slice %1 (%2) could not be decoded: %3")
                    .arg(slices[i].number)
                    .arg(slices[i].image, slices[i].reason);
    QString text = each.join(QLatin1String("; "));
    text[0] = text.at(0).toUpper();
    if (slices.size() > named)
        text += QStringLiteral("; and %1 more").arg(slices.size() - named);
    text += slices.size() == 1 ? QStringLiteral(". It was left out.")
                               : QStringLiteral(". They were left out.");
    return {.kind = VolumeProblem::Kind::DamagedSlice, .text = text, .caution = true};
}

QString imageName(const ImageHeader& image)
{
    const QString name = QFileInfo(image.file).fileName();
    return image.frames > 1 ? QStringLiteral("%1 frame %2").arg(name).arg(image.frame + 1) : name;
}

} // namespace core
