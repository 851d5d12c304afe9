// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/SliceStack.h"

#include "core/dicom/stack/ApartImage.h"
#include "core/dicom/stack/QuantitySplit.h"
#include "core/dicom/stack/SeriesSplit.h"
#include "core/dicom/stack/SlicePlaces.h"
#include "core/dicom/stack/StackGeometry.h"
#include "core/dicom/stack/TimePoints.h"

#include <QFileInfo>

#include <algorithm>
#include <tuple>

namespace core {

namespace {

using Images = std::vector<ImageHeader>;

void putApart(std::vector<ForeignObject>& foreign, const ImageHeader& image, const ApartImage& why)
{
    const auto same =
        std::find_if(foreign.begin(), foreign.end(), [&](const ForeignObject& object) {
            return object.kind == why.kind && object.reason == why.reason;
        });
    if (same == foreign.end()) {
        foreign.push_back({.kind = why.kind,
            .reason = why.reason,
            .identity = image.identity,
            .files = {image.file}});
    } else if (same->files.back() != image.file) {
        same->files.append(image.file);
    }
}

/// Leaves out what ends before its pixels do. @return which that was, in words
std::vector<VolumeProblem> dropCut(Images& images)
{
    QStringList cut;
    for (const ImageHeader& image : images) {
        if (image.pixelsCut)
            cut.append(imageName(image));
    }
    std::erase_if(images, [](const ImageHeader& image) { return image.pixelsCut; });
    if (cut.isEmpty())
        return {};
    return {damagedSlices(cut)};
}

void putFirst(SliceStack& stack, const std::vector<VolumeProblem>& problems)
{
    stack.problems.insert(stack.problems.begin(), problems.begin(), problems.end());
}

/// Every point is a volume of its own; together they are one in time.
void stackTimes(TimeAxis axis, const std::vector<VolumeProblem>& problems, StackSorting& sorting)
{
    const auto count = int(axis.points.size());
    std::vector<SliceStack> times;
    for (TimePoint& point : axis.points) {
        SliceStack stack = stackOf(std::move(point.slices));
        putFirst(stack, problems);
        stack.time = point.label;
        ProblemSentence said{
            point.label.isEmpty() ? ProblemCode::PointInTime : ProblemCode::NamedPointInTime,
            {count, std::int64_t(times.size()) + 1, point.label}};
        if (!axis.certain)
            said = {ProblemCode::ToldApartByNumbers, {asPart(std::move(said))}};
        stack.problems.push_back({.kind = VolumeProblem::Kind::MixedSlices,
            .said = std::move(said),
            .caution = !axis.certain});
        times.push_back(std::move(stack));
    }
    SliceStack first = std::move(times.front());
    first.laterTimes.assign(
        std::make_move_iterator(times.begin() + 1), std::make_move_iterator(times.end()));
    sorting.stacks.push_back(std::move(first));
}

using Doubled = std::shared_ptr<const Images>;

std::vector<SliceSpan> doubledPlaces(const std::vector<SlicePlace>& places)
{
    std::vector<SliceSpan> slices;
    for (std::size_t place = 0; place < places.size(); ++place) {
        if (places[place].images.size() > 1)
            slices.push_back({.first = int(place) + 1, .last = int(place) + 1});
    }
    return slices;
}

/// Where places hold different numbers of images each candidate is listed with a warning.
void stackCandidates(TimeAxis axis, const std::vector<SliceSpan>& places, const Doubled& doubled,
    const std::vector<VolumeProblem>& problems, StackSorting& sorting)
{
    const auto count = int(axis.points.size());
    int number = 0;
    for (TimePoint& point : axis.points) {
        SliceStack stack = stackOf(std::move(point.slices));
        putFirst(stack, problems);
        stack.part = Clause::saying("%1 of %2 (%3)", ++number, count,
            point.label.isEmpty() ? Clause::saying("by instance number") : point.label);
        stack.doubled = doubled;
        stack.problems.push_back({.kind = VolumeProblem::Kind::DoubledSlices,
            .said = {ProblemCode::Doubled, {count, slicesInWords(places), stack.part}},
            .caution = true,
            .slices = places});
        sorting.stacks.push_back(std::move(stack));
    }
}

void stackGroup(Images group, FileContents& contents, StackSorting& sorting);

/// Volumes beside each other, each perhaps in time.
void stackQuantities(std::vector<QuantityImages> quantities,
    const std::vector<VolumeProblem>& problems, FileContents& contents, StackSorting& sorting)
{
    Clauses names;
    for (const QuantityImages& each : quantities)
        names.append(each.quantity);
    for (QuantityImages& each : quantities) {
        StackSorting own;
        stackGroup(std::move(each.images), contents, own);
        for (SliceStack& stack : own.stacks) {
            stack.part = stack.part.isEmpty() ? each.quantity
                                              : Clause::saying("%1, %2", each.quantity, stack.part);
            putFirst(stack, problems);
            stack.problems.push_back({.kind = VolumeProblem::Kind::MixedSlices,
                .said = {
                    ProblemCode::Quantities, {namesIn(names, ProblemCode::AndOf), each.quantity}}});
            sorting.stacks.push_back(std::move(stack));
        }
    }
}

void stackGroup(Images group, FileContents& contents, StackSorting& sorting)
{
    std::vector<VolumeProblem> problems = dropCut(group);
    if (group.empty())
        return;
    if (framesOfReferenceAreMeaningless(group)) {
        problems.push_back({.kind = VolumeProblem::Kind::Other,
            .said = {ProblemCode::FramesOfReferenceTakenAsOne}});
    }
    Doubled doubled = std::make_shared<const Images>(group);
    std::vector<SlicePlace> places = sortIntoPlaces(std::move(group));
    const std::vector<VolumeProblem> duplicates = dropDuplicates(places, contents);
    const bool contradicting = std::any_of(duplicates.begin(), duplicates.end(),
        [](const VolumeProblem& problem) { return problem.caution; });
    problems.insert(problems.end(), duplicates.begin(), duplicates.end());

    const bool single = std::all_of(places.begin(), places.end(),
        [](const SlicePlace& place) { return place.images.size() == 1; });
    if (!single) {
        if (std::vector<QuantityImages> quantities = takeApartByQuantity(places);
            !quantities.empty())
            return stackQuantities(std::move(quantities), problems, contents, sorting);
        const std::vector<SliceSpan> severalAt = doubledPlaces(places);
        TimeAxis axis = findTimeAxis(std::move(places));
        if (axis.complete)
            stackTimes(std::move(axis), problems, sorting);
        else
            stackCandidates(std::move(axis), severalAt, doubled, problems, sorting);
        return;
    }
    Images slices;
    for (SlicePlace& place : places)
        slices.push_back(std::move(place.images.front()));
    SliceStack stack = stackOf(std::move(slices));
    putFirst(stack, problems);
    if (contradicting)
        stack.doubled = std::move(doubled);
    sorting.stacks.push_back(std::move(stack));
}

/// Positions that wander sideways are no grid, whatever the affine says.
void putCrookedApart(StackSorting& sorting)
{
    std::vector<SliceStack> straight;
    for (SliceStack& stack : sorting.stacks) {
        const double drift = sidewaysDriftMm(stack);
        const double pixel = std::max(stack.slices[0].spacing->x, stack.slices[0].spacing->y);
        if (drift <= pixel) {
            straight.push_back(std::move(stack));
            continue;
        }
        const ApartImage why{Clause::saying("images that are no stack"),
            Clause::saying(
                "their positions wander sideways by %1 mm", QString::number(drift, 'f', 1))};
        for (const ImageHeader& image : stack.slices)
            putApart(sorting.foreign, image, why);
        for (const SliceStack& later : stack.laterTimes) {
            for (const ImageHeader& image : later.slices)
                putApart(sorting.foreign, image, why);
        }
    }
    sorting.stacks = std::move(straight);
}

} // namespace

SliceStack stackOf(std::vector<ImageHeader> slices)
{
    SliceStack stack;
    stack.slices = std::move(slices);
    placeSlices(stack);
    const bool lossy = std::any_of(stack.slices.begin(), stack.slices.end(),
        [](const ImageHeader& image) { return image.isLossy; });
    if (lossy) {
        stack.problems.push_back({.kind = VolumeProblem::Kind::LossyCompression,
            .said = {ProblemCode::CompressedWithLoss}});
    }
    const auto wrong =
        std::find_if(stack.slices.begin(), stack.slices.end(), [](const ImageHeader& image) {
            return image.layout.falseHighBit && image.layout.floatBits == 0;
        });
    if (wrong != stack.slices.end()) {
        const PixelLayout& layout = wrong->layout;
        stack.problems.push_back({.kind = VolumeProblem::Kind::Other,
            .said = {ProblemCode::HighBitTaken,
                {*layout.falseHighBit, layout.bitsStored, layout.highBit}}});
    }
    return stack;
}

SliceStack oneAtEveryPlace(const SliceStack& stack, bool last)
{
    const auto order = [](const ImageHeader& image) {
        return std::tie(image.instanceNumber, image.file, image.frame);
    };
    const auto isBefore = [&](const ImageHeader& a, const ImageHeader& b) {
        return order(a) < order(b);
    };
    Images slices;
    for (const SlicePlace& place : sortIntoPlaces(*stack.doubled)) {
        const auto& images = place.images;
        slices.push_back(last ? *std::max_element(images.begin(), images.end(), isBefore)
                              : *std::min_element(images.begin(), images.end(), isBefore));
    }
    SliceStack chosen = stackOf(std::move(slices));
    std::vector<VolumeProblem> named;
    for (const VolumeProblem& problem : stack.problems) {
        if (problem.kind == VolumeProblem::Kind::DoubledSlices
            || problem.kind == VolumeProblem::Kind::DuplicateSlices)
            named.push_back(problem);
    }
    putFirst(chosen, named);
    chosen.time = stack.time;
    return chosen;
}

StackSorting sortIntoStacks(std::vector<ImageHeader> images)
{
    StackSorting sorting;
    std::sort(images.begin(), images.end(), [](const ImageHeader& a, const ImageHeader& b) {
        return std::tie(a.file, a.frame) < std::tie(b.file, b.frame);
    });
    Images placed;
    for (ImageHeader& image : images) {
        if (const std::optional<ApartImage> why = whyApart(image))
            putApart(sorting.foreign, image, *why);
        else
            placed.push_back(std::move(image));
    }
    FileContents contents;
    for (Images& group : splitSeries(std::move(placed)))
        stackGroup(std::move(group), contents, sorting);
    putCrookedApart(sorting);

    if (sorting.stacks.size() > 1) {
        for (std::size_t index = 0; index < sorting.stacks.size(); ++index) {
            Clause& part = sorting.stacks[index].part;
            if (part.isEmpty())
                part = Clause::saying("part %1 of %2", index + 1, sorting.stacks.size());
        }
    }
    return sorting;
}

} // namespace core
