// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/EditParts.h"

#include "core/edits/kinds/AnyEdit.h"

#include <type_traits>
#include <utility>

namespace core {

namespace {

template <class E>
concept hasPenSamples = std::is_same_v<decltype(E::samples), std::vector<PenSample>>;

template <class E>
concept isByTime = std::is_same_v<decltype(E::byTime), bool>;

template <class E>
concept hasBrushPath = std::is_same_v<decltype(E::path), BrushPath>;

template <class E>
concept hasEditableRange = std::is_same_v<decltype(E::editable), std::optional<EditableRange>>;

template <class E>
concept hasCriteria = std::is_same_v<decltype(E::criteria), GrowCriteria>;

template <class E>
concept hasSteps = std::is_same_v<decltype(E::steps), std::optional<int>>;

/// Steps alone are no growth: one that shrinks has them too.
template <class E>
concept grows = hasCriteria<E> && hasSteps<E>;

/// What @p take gives of a growth; null: the edit is none.
template <class Part, class Take> const Part* partOfGrowth(const Edit& edit, const Take& take)
{
    return visitEdit(
        [&take](const auto& known) -> const Part* {
            if constexpr (grows<std::decay_t<decltype(known)>>)
                return &take(known);
            else
                return nullptr;
        },
        edit);
}

} // namespace

const std::vector<PenSample>* penSamplesOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) -> const std::vector<PenSample>* {
            if constexpr (hasPenSamples<std::decay_t<decltype(known)>>)
                return &known.samples;
            else
                return nullptr;
        },
        edit);
}

std::vector<PenSample>* penSamplesOf(Edit& edit)
{
    return const_cast<std::vector<PenSample>*>(penSamplesOf(std::as_const(edit)));
}

bool* byTimeOf(Edit& edit)
{
    return visitEdit(
        [](auto& known) -> bool* {
            if constexpr (isByTime<std::decay_t<decltype(known)>>)
                return &known.byTime;
            else
                return nullptr;
        },
        edit);
}

const BrushPath* brushPathOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) -> const BrushPath* {
            if constexpr (hasBrushPath<std::decay_t<decltype(known)>>)
                return &known.path;
            else
                return nullptr;
        },
        edit);
}

BrushPath* brushPathOf(Edit& edit)
{
    return const_cast<BrushPath*>(brushPathOf(std::as_const(edit)));
}

const std::optional<EditableRange>* editableRangeOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) -> const std::optional<EditableRange>* {
            if constexpr (hasEditableRange<std::decay_t<decltype(known)>>)
                return &known.editable;
            else if constexpr (hasCriteria<std::decay_t<decltype(known)>>)
                return &known.criteria.editable;
            else
                return nullptr;
        },
        edit);
}

std::optional<EditableRange>* editableRangeOf(Edit& edit)
{
    return const_cast<std::optional<EditableRange>*>(editableRangeOf(std::as_const(edit)));
}

const GrowCriteria* growCriteriaOf(const Edit& edit)
{
    return partOfGrowth<GrowCriteria>(
        edit, [](const auto& growth) -> const auto& { return growth.criteria; });
}

const GrowGuard* growGuardOf(const Edit& edit)
{
    return partOfGrowth<GrowGuard>(
        edit, [](const auto& growth) -> const auto& { return growth.guard; });
}

const std::optional<int>* growStepsOf(const Edit& edit)
{
    return partOfGrowth<std::optional<int>>(
        edit, [](const auto& growth) -> const auto& { return growth.steps; });
}

std::optional<int>* growStepsOf(Edit& edit)
{
    return const_cast<std::optional<int>*>(growStepsOf(std::as_const(edit)));
}

} // namespace core
