// SPDX-License-Identifier: Apache-2.0
#pragma once

// All kinds of edits with their definitions. Only sources that handle every kind include this
// header, since they are compiled again whenever any edit changes.

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/EditKinds.h"
#include "core/edits/schema/ChunkSchema.h"
#include "core/edits/schema/FillingSchema.h"
#include "core/edits/schema/GrowthSchema.h"
#include "core/edits/schema/HistorySchema.h"
#include "core/edits/schema/LayerSchema.h"
#include "core/edits/schema/PieceSchema.h"
#include "core/edits/schema/SculptSchema.h"
#include "core/edits/schema/SegmentSchema.h"
#include "core/edits/schema/SplittingSchema.h"
#include "core/edits/schema/SurfaceSchema.h"
#include "core/edits/schema/ViewSchema.h"

#include <utility>
#include <variant>

namespace core {

struct EditVariant : VariantOfKinds<AllEdits>::Type {
    using VariantOfKinds<AllEdits>::Type::variant;
};

/// Calls the visitor with the actual edit. It must handle every kind; if one is missing, it does
/// not compile.
template <class Visitor> decltype(auto) visitEdit(Visitor&& visitor, const Edit& edit)
{
    return std::visit(std::forward<Visitor>(visitor), edit.any());
}
template <class Visitor> decltype(auto) visitEdit(Visitor&& visitor, Edit& edit)
{
    return std::visit(std::forward<Visitor>(visitor), edit.any());
}

} // namespace core
