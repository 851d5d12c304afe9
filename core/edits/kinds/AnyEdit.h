// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every kind of edit, whole, with its fields (schema/SchemaParts.h says how they are shown to a
// visitor). Only sources that ask all of them alike include this: they are built anew when any edit
// changes.

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/EditKinds.h"
#include "core/edits/schema/ChunkSchema.h"
#include "core/edits/schema/GrowthSchema.h"
#include "core/edits/schema/HistorySchema.h"
#include "core/edits/schema/LayerSchema.h"
#include "core/edits/schema/PieceSchema.h"
#include "core/edits/schema/SculptSchema.h"
#include "core/edits/schema/SegmentSchema.h"
#include "core/edits/schema/SurfaceSchema.h"
#include "core/edits/schema/ViewSchema.h"

#include <utility>
#include <variant>

namespace core {

struct EditVariant : VariantOfKinds<AllEdits>::Type {
    using VariantOfKinds<AllEdits>::Type::variant;
};

/// Calls the visitor with the edit as what it is. It must have an answer for every kind: one that
/// it forgot does not compile.
template <class Visitor> decltype(auto) visitEdit(Visitor&& visitor, const Edit& edit)
{
    return std::visit(std::forward<Visitor>(visitor), edit.any());
}
template <class Visitor> decltype(auto) visitEdit(Visitor&& visitor, Edit& edit)
{
    return std::visit(std::forward<Visitor>(visitor), edit.any());
}

} // namespace core
