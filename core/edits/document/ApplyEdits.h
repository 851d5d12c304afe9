// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/IsOneOf.h"

namespace core::applyEdits {

// Between the sources of applyToDocument() (DocumentEdits.h): what an edit of the surface or of
// chunks changes in the document. Each returns whether anything is different now.

/// What works on the surface: there has to be one. @param deforms the segment holds something else
/// from now on
[[nodiscard]] Result<bool> changeSurface(Document& document, bool deforms);

template <class E>
requires isOneOf<E, FollowMask, SpherePush, PointDrag, ApplyTemplate, SmoothSurface, AttractSurface>
    Result<bool> apply(const E&, Document& document)
{
    return changeSurface(document, true);
}
Result<bool> apply(const LaySurface& edit, Document& document);
Result<bool> apply(const DropSurface& edit, Document& document);
Result<bool> apply(const MarkSurface& edit, Document& document);
Result<bool> apply(const ChangeMarks& edit, Document& document);
Result<bool> apply(const PlaneScrape& edit, Document& document);
Result<bool> apply(const WriteBack& edit, Document& document);
/// Changes nothing there, but there has to be a surface.
Result<bool> apply(const SurfaceBarrier& edit, Document& document);
Result<bool> apply(const Chunks& edit, Document& document);

} // namespace core::applyEdits
