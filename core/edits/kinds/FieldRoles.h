// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/fields/EditFields.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/schema/EditChunks.h"
#include "core/edits/schema/EditLists.h"
#include "core/edits/schema/EditMasks.h"
#include "core/edits/schema/EditPlanes.h"
#include "core/edits/schema/EditSplits.h"

#include <cstddef>

namespace core {

/// What the value of a field of an edit stands for. Code that has to know what an edit refers to
/// goes through its fields (EditNames.h), so that no list of kinds has to be kept.
enum class FieldRole {
    Plain, ///< for itself
    Thing, ///< for objects of the document, which may have other numbers on another study
    Row, ///< for rows of the history
    File, ///< for a file
    Found, ///< for what the edit finds when it is carried out, and would find again
};

/// The types of fields whose values stand for nothing but themselves. A type that is listed neither
/// here nor in fieldRole() does not compile. Fields of masks, splits and chunks contain labels,
/// too, but are listed here because their edits are bound to the study anyway.
template <class Kind>
inline constexpr bool isPlainField = isOneOf<Kind, editFields::Number, editFields::WholeNumber,
    editFields::Connectivity, editFields::Flag, editFields::Text, editFields::Colour,
    editFields::Code, editFields::Point, editFields::StepCount, editFields::PointList,
    editFields::ContourList, editFields::Outline, editFields::ClipHalfSpaceList,
    editFields::SampleList, editFields::PressureList, editFields::PlaceList, editFields::CornerPair,
    editFields::SegmentReference, editFields::GridSize, editFields::ImportedSegmentList,
    editFields::EntryOrder, editFields::PlaneList, editFields::SplitPartList,
    editFields::PackedBytes, editFields::DrawnPlaneList>;
template <class E, std::size_t N>
inline constexpr bool isPlainField<editFields::Choice<E, N>> = true;

/// The role of all fields of a type.
template <class Kind> [[nodiscard]] constexpr FieldRole fieldRole()
{
    if constexpr (isOneOf<Kind, editFields::ThingNumber, editFields::SegmentList>) {
        return FieldRole::Thing;
    } else if constexpr (isOneOf<Kind, editFields::Row, editFields::RowList>) {
        return FieldRole::Row;
    } else if constexpr (isOneOf<Kind, editFields::FileName>) {
        return FieldRole::File;
    } else if constexpr (isOneOf<Kind, editFields::ChunkOwnerList, editFields::BrickList>) {
        return FieldRole::Found;
    } else {
        static_assert(isPlainField<Kind>, "what does the value of such a field stand for?");
        return FieldRole::Plain;
    }
}

} // namespace core
